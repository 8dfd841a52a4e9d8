/// Align one map of a surface to the sphere with another map, by a rotation \cite Kabsch1976 or a
/// Moebius transform (conformal map of the sphere to itself).

#ifndef ConformalSphericalAlignment_h
#define ConformalSphericalAlignment_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Sphere/MoebiusTransform.h"

namespace conformal
{
enum class AlignmentKind
{
  Rotation, ///< a rotation, which preserves angles and areas
  Moebius   ///< a Moebius transform, which preserves angles
};

struct SphericalAlignmentResult
{
  MoebiusTransform Transform;
  /// Weighted root mean square distance between corresponding positions on the unit sphere, after
  /// the transform.
  double Error = 0.0;
};

/// Find the transform that minimizes the weighted mean square distance between corresponding
/// positions on the sphere.
/// @param[in] from  positions that are transformed, #P by 3 unit vectors
/// @param[in] to  corresponding positions, #P by 3 unit vectors
/// @param[in] weights  weights of the pairs, at least 0, #P
/// @throws std::invalid_argument if the pairs do not determine the transform: a rotation needs two
///   pairs that are neither equal nor antipodal, a Moebius transform three different pairs, all
///   with positive weights
SphericalAlignmentResult alignSpheres(const Points& from, const Points& to,
  const Eigen::VectorXd& weights, AlignmentKind kind = AlignmentKind::Rotation,
  const Run& run = {});

/// Transfer the sphere map of a surface to given points. In space, the points must be aligned with
/// the surface. Each point gets the sphere position of the closest point of the surface.
/// @param[in] points  #P by 3 coordinates, finite
/// @param[in] other  surface with a map to the sphere
/// @return #P by 3 unit vectors
Points carryMap(const Points& points, const MappedMesh& other, const Run& run = {});
}

#endif
