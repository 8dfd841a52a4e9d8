/// Heights and slopes of a body over a reference ellipsoid or sphere. Own construction: equal
/// volume and ratios of moments define the reference without a fit.

#ifndef ConformalBodyRelief_h
#define ConformalBodyRelief_h

#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Ellipsoid, or sphere if its radii are equal.
struct ReferenceEllipsoid
{
  Vector3 Center = Vector3::Zero();
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity(); ///< columns: right-handed unit vectors
  Vector3 Radii = Vector3::Ones(); ///< semi-axes along the columns of Axes, in descending order
};

/// Compute the sphere of the same volume as a body, around the centroid of that volume.
/// @throws std::invalid_argument if the mesh encloses no volume
ReferenceEllipsoid referenceSphere(const Mesh& body);

/// Compute the ellipsoid of the same volume as a body, along its principal axes of inertia. The
/// radii are in the ratio of the square roots of its second moments.
/// @throws std::invalid_argument if the mesh encloses no volume
ReferenceEllipsoid referenceEllipsoid(const Mesh& body);

struct BodyRelief
{
  /// #V: distance from the center, minus that of the reference in the same direction
  std::vector<double> Heights;
  std::vector<double> Slopes; ///< #V: angle between the normals of body and reference [degrees]
};

/// Measure heights and slopes in the direction of each vertex from the center of the reference. The
/// slope is 0 for a vertex without a normal.
BodyRelief measureRelief(const Mesh& body, const ReferenceEllipsoid& reference);
}

#endif
