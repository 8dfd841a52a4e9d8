/// Interpolate between shapes with the same triangles, by the Poisson interpolation of
/// \cite Xu2005.

#ifndef ConformalSphericalMorph_h
#define ConformalSphericalMorph_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Path of a point from one shape to the other.
enum class MorphPath
{
  Linear, ///< straight path: rotating parts shrink on the way
  Rigid   ///< triangles rotate and stretch evenly: rotating parts keep their size
};

struct SphericalMorphOptions
{
  MorphPath Path = MorphPath::Linear;
};

/// Compute the weights of shapes at a position on a path through all shapes. The first shape is at
/// factor 0, the last at 1, and the others are at equal steps between them.
/// @param[in] factor  position on the path, in [0, 1]
std::vector<double> morphWeights(double factor, std::size_t numberOfShapes);

/// Blend shapes by weights.
///
/// With MorphPath::Rigid, the deformation gradient of each triangle, including its normal, is split
/// into a rotation and a stretch (polar decomposition). Logarithms of rotations and stretches are
/// averaged by the weights. The best rotation between whole shapes is separated before, and
/// averaged in the same way. Logarithms are chosen to be continuous between neighboring triangles.
/// A part may therefore rotate by more than 180 degrees, but not by 360 degrees. The blended
/// triangles are assembled by least squares, which is one linear system. Its cotangent weights are
/// clamped to [MinimumCotangent, MaximumCotangent]. The area-weighted center moves on a straight
/// line.
///
/// For two shapes, the result does not depend on their order, except for rounding. For more shapes,
/// rotations are relative to the first shape of weight above 0.
///
/// @param[in] sphere   sphere positions of the points, and the triangles of all shapes
/// @param[in] shapes   #S shapes, at least one, each #V by 3
/// @param[in] weights  #S, weight of each shape, at least 0; the sum is 1
/// @return the blended shape, #V by 3; a shape of weight 1 is returned unchanged
/// @throws std::invalid_argument if the number of weights is not #S, a weight is negative, or the
///   sum is not 1
/// @throws Aborted
Points morphShapes(const Mesh& sphere, const std::vector<Points>& shapes,
  const std::vector<double>& weights, const SphericalMorphOptions& options = {},
  const Run& run = {});

constexpr double MinimumCotangent = 0.02, MaximumCotangent = 50.0;
}

#endif
