/// Make point clouds on the unit sphere, and meshes of spheres, for tests.

#ifndef ConformalTestSpheres_h
#define ConformalTestSpheres_h

#include "Base/Types.h"
#include "Clouds.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/Mesh.h"
#include "Shapes.h"

#include <cmath>
#include <functional>

namespace spheres
{
/// Return a geodesic sphere that is its own map to the sphere.
inline conformal::MappedMesh mapped(int frequency)
{
  conformal::MappedMesh mesh{ conformal::makeGeodesicSphere(frequency), {} };
  mesh.SpherePositions = mesh.Positions;
  return mesh;
}

/// Return a geodesic sphere whose points are moved to place(n), for directions n.
inline conformal::Mesh shaped(
  int frequency, const std::function<conformal::Vector3(const conformal::Vector3&)>& place)
{
  conformal::Mesh mesh = conformal::makeGeodesicSphere(frequency);
  mesh.Positions = shapes::over(mesh.Positions, place);
  return mesh;
}

/// Return the points of a geodesic sphere that satisfy a condition.
inline conformal::Points geodesicWhere(
  int frequency, const std::function<bool(const conformal::Vector3&)>& test)
{
  return clouds::where(conformal::makeGeodesicSphere(frequency).Positions, test);
}

/// Return random points on the sphere, with uniform density. If `sparseHalf` is true, the density
/// for x < 0 is a hundredth of the density for x > 0.
inline conformal::Points random(conformal::Index size, bool sparseHalf = false)
{
  conformal::Random random(5);
  conformal::Points points(size, 3);
  for (conformal::Index i = 0; i < size;)
  {
    const double z = 2.0 * random.uniform() - 1.0, turn = 2.0 * conformal::Pi * random.uniform();
    const double r = std::sqrt(1.0 - z * z), x = r * std::cos(turn);
    const bool taken = !sparseHalf || x > 0.0 || random.uniform() < 0.01;
    if (taken)
    {
      points.row(i++) << x, r * std::sin(turn), z;
    }
  }
  return points;
}

/// Return points that are evenly distributed along a spiral.
inline conformal::Points spiral(conformal::Index size)
{
  conformal::Points points(size, 3);
  for (conformal::Index i = 0; i < size; ++i)
  {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(size);
    const double turn = 2.399963229728653 * static_cast<double>(i), r = std::sqrt(1.0 - z * z);
    points.row(i) << r * std::cos(turn), r * std::sin(turn), z;
  }
  return points;
}
}

#endif
