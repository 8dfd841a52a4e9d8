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
  /// The whole shape rotates gradually. In a frame that rotates with it, points move along straight
  /// lines. Parts that rotate relative to the whole shape shrink in between.
  Linear,
  Rigid ///< path on which triangles rotate and stretch gradually; parts that rotate keep their size
};

/// Options of morphShapes().
struct SphericalMorphOptions
{
  MorphPath Path = MorphPath::Linear;
};

/// Compute the weights of the shapes at a position on a path from the first shape to the last. On
/// the path, the shapes are evenly spaced: the first at factor 0, the last at factor 1.
/// @param[in] factor  position on the path, in [0, 1]
/// @throws std::invalid_argument if the factor is outside of [0, 1], or NaN
/// @return weight of each shape. Only one shape, or two consecutive shapes, have weights above 0.
std::vector<double> morphWeights(double factor, std::size_t numberOfShapes);

/// Blend shapes by weights.
///
/// For each shape, the rotation is found that best aligns the first shape with this shape. Vertices
/// are weighted by area. MorphPath::Linear rotates each shape back by its rotation, averages the
/// shapes, and applies the mean rotation to the result. The mean rotation is that of the averaged
/// logarithms (rotation vectors). Shapes that face different ways therefore do not shrink.
///
/// MorphPath::Rigid blends triangles as follows:
/// 1. Rotate each shape back by its rotation.
/// 2. Compute the deformation gradient of each triangle: the linear map from the triangle of the
///    first shape to that of this shape. The gradient also maps the unit normal of one triangle to
///    that of the other. Split the gradient into a rotation and a stretch (polar decomposition).
/// 3. Undo the rotation of each triangle, and average the triangles of all shapes. Average the
///    logarithms (rotation vectors) of the rotations of triangles, and of whole shapes. Apply the
///    mean rotations to the mean triangles.
/// 4. Assemble the blended triangles to a shape by least squares, which is one linear system. The
///    weights of this system are cotangents of triangle angles, clamped to [MinimumCotangent,
///    MaximumCotangent].
/// 5. Scale the shape so that its area is the weighted mean of the areas of the shapes.
///
/// Implementation note: step 5 is not part of \cite Xu2005. The mean of triangles that are
/// stretched in different directions is larger than the triangles.
///
/// A rotation has several logarithms, which differ by multiples of 360 degrees. The logarithms of
/// neighboring triangles are chosen to be similar. With this choice, parts can rotate by more than
/// 180 degrees. Rotations by 360 degrees are not possible. The area-weighted center of the shape
/// moves on a straight line.
///
/// If two shapes are blended, their order affects the result only by rounding. If more than two
/// shapes are blended, rotations are relative to the first shape of weight above 0.
///
/// @param[in] sphere   sphere positions of the points, and the triangles of every shape
/// @param[in] shapes   #S shapes, at least one, each #V by 3
/// @param[in] weights  #S, weight of each shape, at least 0. The sum of the weights is 1.
/// @return the blended shape, #V by 3; a shape of weight 1 is returned unchanged
/// @throws std::invalid_argument if the number or the sum of the weights is wrong, or a weight is
///   negative
/// @throws Aborted
Points morphShapes(const Mesh& sphere, const std::vector<Points>& shapes,
  const std::vector<double>& weights, const SphericalMorphOptions& options = {},
  const Run& run = {});

/// Compute the mean of shapes, with equal weights and the rotations of MorphPath::Rigid. Parts that
/// rotate relative to each other, such as legs in different poses, keep their size. The area of the
/// mean is the mean of the areas, and its center is the mean of the centers.
///
/// The first mean is the blend by morphShapes(), with rotations relative to the first shape. In the
/// next rounds, rotations are relative to the latest mean. Rounds end if the mean changes by at
/// most 0.1 percent of its size, so that the result hardly depends on the order of the shapes. In
/// the limit, the rotation vectors of a triangle relative to the mean have the sum 0. This is the
/// Karcher mean \cite Karcher1977 of its rotations.
///
/// @param[in] sphere  the triangles of every shape, and the sphere positions of the points
/// @param[in] shapes  #S shapes, at least one, each #V by 3; a single shape is returned unchanged
/// @throws std::invalid_argument if there is no shape
/// @throws Aborted
/// @post the result does not depend on the number of threads
Points rigidMean(const Mesh& sphere, const std::vector<Points>& shapes, const Run& run = {});

/// Limits of cotangents of triangle angles in morphShapes(). With these limits, the linear system
/// is regular even if triangles are thin.
constexpr double MinimumCotangent = 0.02, MaximumCotangent = 50.0;
}

#endif
