/// Interpolate between shapes of one connectivity.
/// Poisson interpolation of \cite Xu2005.

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
  Linear, ///< straight: rotating parts shrink on the way
  Rigid   ///< triangles rotate and stretch evenly: rotating parts keep their size
};

struct SphericalMorphOptions
{
  MorphPath Path = MorphPath::Linear;
};

/// Compute the weights of a path through shapes: factor 0 is the first shape, 1 the last, and the
/// others follow at equal steps.
/// @param[in] factor  in [0, 1]
std::vector<double> morphWeights(double factor, std::size_t numberOfShapes);

/// Blend shapes by weights.
///
/// With MorphPath::Rigid, the deformation gradient of each triangle, including its normal, is split
/// into a rotation and a stretch (polar decomposition). Logarithms of rotations and stretches are
/// averaged by the weights. First, the best rotation between whole shapes is separated and averaged
/// in the same way. Logarithms are chosen to be continuous between neighboring triangles, so that a
/// part may rotate by more than half a turn, but not by a whole one. The blended triangles are
/// assembled by least squares, one linear system. Its cotangent weights are clamped to
/// [MinimumCotangent, MaximumCotangent]. The area-weighted center moves straight.
///
/// For two shapes, an exchange of both shapes and weights changes the result by rounding only. For
/// more, rotations are relative to the first shape of weight above 0.
///
/// @param[in] sphere   positions of the points on the sphere, and the triangles of all shapes
/// @param[in] shapes   #S, at least one, each #V by 3
/// @param[in] weights  #S, at least 0, of sum 1
/// @return #V by 3; a shape of weight 1 is returned unchanged
/// @throws std::invalid_argument if the number of weights is not #S, a weight is negative, or the
///   sum is not 1
/// @throws Aborted
Points morphShapes(const Mesh& sphere, const std::vector<Points>& shapes,
  const std::vector<double>& weights, const SphericalMorphOptions& options = {},
  const Run& run = {});

constexpr double MinimumCotangent = 0.02, MaximumCotangent = 50.0;
}

#endif
