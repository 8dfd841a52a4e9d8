/// Aligns one map to the sphere with another.

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
  Rotation, ///< keeps angles and areas
  Moebius   ///< keeps angles
};

struct SphericalAlignmentResult
{
  MoebiusTransform Transform;
  double Error = 0.0; ///< weighted root mean square distance that is left, on the unit sphere
};

/// The transform that brings places on the sphere closest to those they correspond to.
/// @param[in] from, to  #P by 3 unit vectors
/// @param[in] weights   #P, not negative
/// @throws std::invalid_argument if there are too few places to fix the transform: two for a
///         rotation, three for a Moebius transform
SphericalAlignmentResult alignSpheres(const Points& from, const Points& to,
  const Eigen::VectorXd& weights, AlignmentKind kind = AlignmentKind::Rotation,
  const Run& run = {});

/// Where the points of one surface lie on the sphere according to another one's map: each takes the
/// place of the nearest point of the other surface, both being laid over each other.
/// @param[in] points  #P by 3, finite
/// @param[in] other   a surface with its map
/// @return #P by 3 unit vectors
Points carryMap(const Points& points, const MappedMesh& other, const Run& run = {});
}

#endif
