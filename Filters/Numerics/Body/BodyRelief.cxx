#include "Body/BodyRelief.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/VertexNormals.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
struct BodyMoments
{
  double Volume = 0.0;
  Vector3 Middle = Vector3::Zero();
  Eigen::Matrix3d Second = Eigen::Matrix3d::Zero(); ///< second moments about Middle
};

// Sum over tetrahedra with an apex near the body.
BodyMoments momentsOf(const Mesh& body)
{
  if (body.Triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  const Vector3 origin = body.Positions.colwise().mean();
  BodyMoments moments;
  double area = 0.0;
  for (Index r = 0; r < body.Triangles.rows(); ++r)
  {
    const Vector3 a = body.Positions.row(body.Triangles(r, 0)).transpose() - origin,
                  b = body.Positions.row(body.Triangles(r, 1)).transpose() - origin,
                  c = body.Positions.row(body.Triangles(r, 2)).transpose() - origin;
    const double volume = a.dot(b.cross(c)) / 6.0;
    const Vector3 sum = a + b + c;
    moments.Volume += volume;
    moments.Middle += volume / 4.0 * sum;
    moments.Second += volume / 20.0 *
      (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    area += areaVector(body.Positions, body.Triangles, r).norm();
  }
  // The volume of a sphere is 0.094 times its area to the power 1.5.
  constexpr double minimum = 1e-9;
  if (!(std::abs(moments.Volume) > minimum * std::pow(area, 1.5)))
  {
    throw std::invalid_argument("the surface encloses no volume");
  }
  moments.Middle /= moments.Volume;
  moments.Second /= moments.Volume;
  moments.Second -= moments.Middle * moments.Middle.transpose();
  moments.Middle += origin;
  moments.Volume = std::abs(moments.Volume);
  return moments;
}

double radiusOfSphere(double volume)
{
  return std::cbrt(volume * 3.0 / (4.0 * Pi));
}
}

//------------------------------------------------------------------------------
ReferenceEllipsoid referenceSphere(const Mesh& body)
{
  const BodyMoments moments = momentsOf(body);
  ReferenceEllipsoid reference;
  reference.Center = moments.Middle;
  reference.Radii.setConstant(radiusOfSphere(moments.Volume));
  return reference;
}

//------------------------------------------------------------------------------
ReferenceEllipsoid referenceEllipsoid(const Mesh& body)
{
  const BodyMoments moments = momentsOf(body);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.Second);
  ReferenceEllipsoid reference;
  reference.Center = moments.Middle;
  for (int k = 0; k < 3; ++k)
  {
    reference.Axes.col(k) = solver.eigenvectors().col(2 - k);
    reference.Radii[k] = std::sqrt(std::max(0.0, solver.eigenvalues()[2 - k]));
  }
  reference.Axes.col(2) = reference.Axes.col(0).cross(reference.Axes.col(1));
  if (!(reference.Radii[2] > 0.0))
  {
    throw std::invalid_argument("the surface encloses no volume");
  }
  reference.Radii *= radiusOfSphere(moments.Volume) / std::cbrt(reference.Radii.prod());
  return reference;
}

//------------------------------------------------------------------------------
BodyRelief measureRelief(const Mesh& body, const ReferenceEllipsoid& reference)
{
  Points normals = vertexNormals(body.Positions, body.Triangles);
  const Points centered = body.Positions.rowwise() - reference.Center.transpose();
  if (signedVolume(centered, body.Triangles) < 0.0)
  {
    normals *= -1.0; // outward
  }
  BodyRelief relief;
  for (Index v = 0; v < body.Positions.rows(); ++v)
  {
    const Vector3 p =
      reference.Axes.transpose() * (body.Positions.row(v).transpose() - reference.Center);
    const Vector3 direction = p.normalized();
    const Vector3 scaled = direction.cwiseQuotient(reference.Radii);
    const double distance =
      scaled.squaredNorm() > 0.0 ? 1.0 / scaled.norm() : reference.Radii[2]; // at the center
    const Vector3 n = reference.Axes.transpose() * normals.row(v).transpose(),
                  up = scaled.cwiseQuotient(reference.Radii).normalized();
    const bool hasBoth = n.squaredNorm() > 0.0 && up.squaredNorm() > 0.0;
    relief.Heights.push_back(p.norm() - distance);
    relief.Slopes.push_back(hasBoth ? std::atan2(n.cross(up).norm(), n.dot(up)) * 180.0 / Pi : 0.0);
  }
  return relief;
}
}
