/// Heights and slopes of a body over a reference ellipsoid or sphere.

#ifndef ConformalBodyRelief_h
#define ConformalBodyRelief_h

#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// An ellipsoid; a sphere if its radii are equal.
struct ReferenceEllipsoid
{
  Vector3 Center = Vector3::Zero();
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity(); ///< columns: unit vectors, right-handed
  Vector3 Radii = Vector3::Ones();                    ///< along these, the largest first
};

/// The sphere around the middle of a body's volume that has as much volume.
/// @throws std::invalid_argument if the mesh encloses no volume
ReferenceEllipsoid referenceSphere(const Mesh& body);

/// The ellipsoid whose axes are the body's principal axes of inertia, with radii in the ratio of
/// its moments (as those of an ellipsoid are), and as much volume.
/// @throws std::invalid_argument if the mesh encloses no volume
ReferenceEllipsoid referenceEllipsoid(const Mesh& body);

struct BodyRelief
{
  std::vector<double> Heights; ///< #V: distance from the center less that of the reference there
  std::vector<double> Slopes;  ///< #V: degrees between the normals of body and reference there
};

/// In the direction of each point from the center of the reference; 0 slope where a point has no
/// normal.
BodyRelief measureRelief(const Mesh& body, const ReferenceEllipsoid& reference);
}

#endif
