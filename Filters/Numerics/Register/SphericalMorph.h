/// Interpolate between shapes with the same triangles, by the Poisson interpolation of
/// \cite Xu2005. Vertices with equal ids correspond.

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
  Linear, ///< straight line; parts that rotate shrink in between
  Rigid   ///< triangles rotate and stretch gradually; parts that rotate keep their size
};

/// Options of morphShapes().
struct SphericalMorphOptions
{
  MorphPath Path = MorphPath::Linear;
};

/// Compute the weights of the shapes at a position on a path from the first shape to the last. On
/// the path, the shapes are evenly spaced: the first at factor 0, the last at factor 1.
/// @param[in] factor  position on the path, in [0, 1]
/// @return weight of each shape. Only one shape, or two consecutive shapes, have weights above 0.
std::vector<double> morphWeights(double factor, std::size_t numberOfShapes);

/// Blend shapes by weights.
///
/// With MorphPath::Linear, positions are averaged. MorphPath::Rigid blends triangles as follows:
/// 1. Find the best rotation between each whole shape and the first shape, and remove this
///    rotation.
/// 2. Compute the deformation gradient of each triangle, including its normal. Split the gradient
///    into a rotation and a stretch (polar decomposition).
/// 3. Average the triangles without their rotations. Average the logarithms of the rotations of
///    triangles and of whole shapes. Apply the mean rotations to the mean triangles.
/// 4. Assemble the blended triangles by least squares, which is one linear system. The cotangent
///    weights of this system are clamped to [MinimumCotangent, MaximumCotangent].
///
/// Logarithms of rotations are chosen to be continuous between neighboring triangles. A part may
/// therefore rotate by more than 180 degrees, but not by 360 degrees. The area-weighted center of
/// the shape moves on a straight line.
///
/// If two shapes are exchanged together with their weights, the result changes only by rounding.
/// With more than two shapes, rotations are relative to the first shape of weight above 0.
///
/// @param[in] sphere   sphere positions of the points, and the triangles of every shape
/// @param[in] shapes   #S shapes, at least one, each #V by 3
/// @param[in] weights  #S, weight of each shape, at least 0. The sum of the weights is 1.
/// @return the blended shape, #V by 3; a shape of weight 1 is returned unchanged
/// @throws std::invalid_argument if the number of weights is not #S, a weight is negative, or the
///   sum of the weights is not 1
/// @throws Aborted
Points morphShapes(const Mesh& sphere, const std::vector<Points>& shapes,
  const std::vector<double>& weights, const SphericalMorphOptions& options = {},
  const Run& run = {});

/// Limits of cotangents of triangle angles, so that thin triangles do not make the system singular.
constexpr double MinimumCotangent = 0.02, MaximumCotangent = 50.0;
}

#endif
