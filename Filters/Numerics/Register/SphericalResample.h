/// Interpolate the values of a source surface at the points of a target surface, with the methods
/// of \cite Glasser2013. Each surface has a map to the sphere. Points of both surfaces correspond
/// if they have the same position on the sphere.

#ifndef ConformalSphericalResample_h
#define ConformalSphericalResample_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Register/ResampleWeights.h"

namespace conformal
{
/// Method by which the weights of source points are computed.
enum class ResampleMethod
{
  Barycentric, ///< interpolate in the source triangle that contains each target point
  /// Every source point contributes in proportion to its area. The area of a point is a third of
  /// the total area of its triangles.
  AreaAdaptive
};

/// Options of resampleSurface().
struct SphericalResampleOptions
{
  ResampleMethod Method = ResampleMethod::AreaAdaptive;
};

/// Weights of source points, and the number of folds of the source's map.
struct SphericalResampling
{
  ResampleWeights Weights; ///< weights of source points for each target point
  /// Number of folded triangles of the source's map. Folded triangles cover parts of the sphere
  /// more than once.
  Index NumberOfFolds = 0;
};

/// Compute the weights of source points for each target point, as defined by the software
/// Connectome Workbench.
///
/// Barycentric: The source's sphere is the mesh of the source's triangles, with sphere positions as
/// vertices. Find the point of this mesh that is closest to the sphere position of the target
/// point. The weights are the barycentric coordinates of this closest point in its flat triangle.
///
/// AreaAdaptive (ADAP_BARY_AREA of Connectome Workbench):
/// 1. Compute forward weights: the Barycentric weights of source points for each target point.
///    Compute reverse weights: the Barycentric weights of target points for each source point.
/// 2. Select the weights of each target point. If the reverse weights include source points that
///    have no forward weight for this target point, select the reverse weights. Otherwise, select
///    the forward weights.
/// 3. Multiply the weights of each target point by the area of the target point.
/// 4. Scale the weights of each source point so that their sum is the area of the source point.
/// 5. Scale the weights of each target point to sum 1.
///
/// As a result, all source points contribute if the target is coarser than the source. If the
/// target is finer, values are interpolated.
///
/// @param[in] source  surface with a map to the sphere. The areas of points are computed from its
///   positions. Points without triangles are ignored.
/// @param[in] target  surface with a map to the sphere. For Barycentric, only its SpherePositions
///   are used.
/// @throws std::invalid_argument if a surface is open, or its map does not cover the sphere once. A
///   mirrored map (with reversed orientation) is allowed. For Barycentric, the target is not
///   checked.
/// @throws Aborted
SphericalResampling resampleSurface(const MappedMesh& source, const MappedMesh& target,
  const SphericalResampleOptions& options = {}, const Run& run = {});
}

#endif
