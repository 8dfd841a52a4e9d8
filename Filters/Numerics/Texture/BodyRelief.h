/// Heights and slopes of a body relative to a reference ellipsoid or sphere. Own construction: the
/// reference is computed from volume and moments, because no fit is then required.

#ifndef ConformalBodyRelief_h
#define ConformalBodyRelief_h

#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Reference ellipsoid. It is a sphere if all radii are equal.
struct ReferenceEllipsoid
{
  Vector3 Center = Vector3::Zero();
  /// Columns: unit vectors along the axes, right-handed
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
  Vector3 Radii = Vector3::Ones(); ///< semi-axes along the columns of Axes, in descending order
};

/// Compute the sphere that has the same volume as a body. Its center is the centroid of the body's
/// volume.
/// @throws std::invalid_argument if the mesh encloses no volume
ReferenceEllipsoid referenceSphere(const Mesh& body);

/// Compute the ellipsoid that has the same volume as a body. Its axes are the body's principal axes
/// of inertia. The ratios of its radii are those of the square roots of the body's second moments.
/// @throws std::invalid_argument if the mesh encloses no volume
ReferenceEllipsoid referenceEllipsoid(const Mesh& body);

struct BodyRelief
{
  /// #V heights: distance of the vertex from the center, minus the distance of the reference in the
  /// same direction
  std::vector<double> Heights;
  std::vector<double> Slopes; ///< #V angles between the normals of body and reference [degrees]
};

/// Measure heights and slopes at each vertex. Each vertex is compared with the point of the
/// reference in the same direction from the center. The slope is 0 for a vertex without a normal.
BodyRelief measureRelief(const Mesh& body, const ReferenceEllipsoid& reference);
}

#endif
