/// Compute heights and slopes of a body relative to a reference ellipsoid or sphere. The method is
/// an own construction, not from a publication. The reference is computed from the volume, centroid
/// and second moments of the body. No iterative fit is required.

#ifndef ConformalBodyRelief_h
#define ConformalBodyRelief_h

#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Reference ellipsoid. If all radii are equal, the ellipsoid is a sphere.
struct ReferenceEllipsoid
{
  Vector3 Center = Vector3::Zero(); ///< center of the ellipsoid
  /// Unit vectors along the axes of the ellipsoid, as columns; right-handed.
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
  Vector3 Radii = Vector3::Ones(); ///< radii along the columns of Axes, in descending order
};

/// Compute the sphere that has the same volume as a body. The center of the sphere is the centroid
/// of the volume.
/// @throws std::invalid_argument if the mesh encloses no volume
ReferenceEllipsoid referenceSphere(const Mesh& body);

/// Compute the ellipsoid that has the same volume as a body. Its center is the centroid of the
/// volume, and its axes are the principal axes of inertia of the body. The radii are proportional
/// to the square roots of the second moments of the body's volume along these axes.
/// @throws std::invalid_argument if the mesh encloses no volume
ReferenceEllipsoid referenceEllipsoid(const Mesh& body);

struct BodyRelief
{
  /// Height of each vertex, #V. Let d be the distance of the vertex from the center of the
  /// reference. The height is d minus the distance from the center to the surface of the reference,
  /// in the same direction.
  std::vector<double> Heights;
  /// Angle between the normals of body and reference at each vertex, #V [degrees].
  std::vector<double> Slopes;
};

/// Measure heights and slopes at each vertex. Each vertex is compared with the point of the
/// reference in the same direction from the center. If a vertex has no normal, its slope is 0.
BodyRelief measureRelief(const Mesh& body, const ReferenceEllipsoid& reference);
}

#endif
