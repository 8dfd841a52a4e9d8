/// Make meshes with handles for tests of the core.
#ifndef ConformalTestHandleMeshes_h
#define ConformalTestHandleMeshes_h

#include "../Handles.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/Mesh.h"

namespace handles
{
inline Mesh fromCore(const conformal::Mesh& mesh)
{
  Mesh result;
  for (conformal::Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    result.Points.push_back({ mesh.Positions(i, 0), mesh.Positions(i, 1), mesh.Positions(i, 2) });
  }
  for (conformal::Index i = 0; i < mesh.Triangles.rows(); ++i)
  {
    result.Triangles.push_back(
      { mesh.Triangles(i, 0), mesh.Triangles(i, 1), mesh.Triangles(i, 2) });
  }
  return result;
}

inline conformal::Mesh toCore(const Mesh& mesh)
{
  conformal::Mesh result;
  result.Positions = Eigen::Map<const conformal::Points>(
    mesh.Points.front().data(), static_cast<conformal::Index>(mesh.Points.size()), 3);
  result.Triangles = Eigen::Map<const conformal::Triangles>(
    mesh.Triangles.front().data(), static_cast<conformal::Index>(mesh.Triangles.size()), 3);
  return result;
}

inline Mesh sphere(int frequency)
{
  return fromCore(conformal::makeGeodesicSphere(frequency));
}

/// Build a unit sphere with `count` handles. Each handle has 12 edges around.
inline conformal::Mesh sphereWithHandles(int count, int frequency = 40)
{
  Mesh mesh = sphere(frequency);
  addHandles(mesh, count, 2, 14.0 * 1.1 / frequency, 20);
  return toCore(mesh);
}

/// Build a torus of major radius 1. The torus has `around` by `along` quadrilaterals, each divided
/// into two triangles. `radius` is the minor radius.
inline conformal::Mesh torus(int around, int along, double radius = 0.4)
{
  conformal::Mesh mesh;
  mesh.Positions.resize(static_cast<conformal::Index>(around) * along, 3);
  mesh.Triangles.resize(static_cast<conformal::Index>(around) * along * 2, 3);
  const auto id = [=](int i, int j) { return (i % along) * around + j % around; };
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const double s = 2.0 * conformal::Pi * i / along, t = 2.0 * conformal::Pi * j / around;
      const double r = 1.0 + radius * std::cos(t);
      mesh.Positions.row(id(i, j)) << r * std::cos(s), r * std::sin(s), radius * std::sin(t);
      mesh.Triangles.row(2 * id(i, j)) << id(i, j), id(i + 1, j), id(i + 1, j + 1);
      mesh.Triangles.row(2 * id(i, j) + 1) << id(i, j), id(i + 1, j + 1), id(i, j + 1);
    }
  }
  return mesh;
}
}

#endif
