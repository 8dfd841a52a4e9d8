/// Align one sphere map with another by a rotation \cite Kabsch1976 or a Moebius transform.

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
  Rotation, ///< preserves angles and areas
  Moebius   ///< preserves angles
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
/// @param[in] from, to  #P by 3 unit vectors
/// @param[in] weights   #P weights, at least 0
/// @throws std::invalid_argument if there are too few positions: two for a rotation, three for a
///   Moebius transform
SphericalAlignmentResult alignSpheres(const Points& from, const Points& to,
  const Eigen::VectorXd& weights, AlignmentKind kind = AlignmentKind::Rotation,
  const Run& run = {});

/// Transfer the sphere map of one surface to the points of another surface at the same position and
/// orientation. Each point gets the sphere position of the closest point of the mapped surface.
/// @param[in] points  #P by 3, finite
/// @param[in] other   surface with a map to the sphere
/// @return #P by 3 unit vectors
Points carryMap(const Points& points, const MappedMesh& other, const Run& run = {});
}

#endif
