#include "Sphere/SheetCaps.h"

#include "Mesh/MeshTopology.h"
#include "Mesh/PolygonTriangulation.h"

#include <algorithm>

namespace conformal
{
namespace
{
Points positionsOf(const Points& all, const BorderLoop& loop)
{
  Points corners(static_cast<Index>(loop.size()), 3);
  for (Index i = 0; i < corners.rows(); ++i)
  {
    corners.row(i) = all.row(loop[i]);
  }
  return corners;
}

/// Twice the area vector that a closed polygon encloses.
Vector3 enclosed(const Points& corners)
{
  Vector3 sum = Vector3::Zero();
  for (Index i = 0; i < corners.rows(); ++i)
  {
    sum += Vector3(corners.row(i)).cross(Vector3(corners.row((i + 1) % corners.rows())));
  }
  return sum;
}

/// Append triangles of vertex ids.
void append(Triangles& triangles, const Triangles& more)
{
  const Index old = triangles.rows();
  triangles.conservativeResize(old + more.rows(), 3);
  triangles.bottomRows(more.rows()) = more;
}

/// Close a border by triangles around a new vertex, at a position on the sphere.
void addFan(CappedSheet& sheet, const BorderLoop& loop, const Vector3& direction)
{
  const auto size = static_cast<Index>(loop.size());
  const Index center = sheet.Positions.rows();
  Triangles fan(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    fan.row(i) << loop[(i + 1) % size], loop[i], static_cast<int>(center);
  }
  append(sheet.Triangles, fan);
  const Eigen::RowVector3d middle = positionsOf(sheet.Positions, loop).colwise().mean();
  sheet.Positions.conservativeResize(center + 1, 3);
  sheet.Positions.row(center) = middle;
  sheet.SpherePositions.conservativeResize(center + 1, 3);
  sheet.SpherePositions.row(center) = direction;
}

/// Return triangles between the vertices of a border, which do not overlap on the sphere. Return
/// none if the border reaches too far around the sphere.
Triangles flatCap(const Points& sphere, const BorderLoop& loop)
{
  constexpr double narrowest = 0.02; // cosine
  BorderLoop reversed(loop.rbegin(), loop.rend());
  Points corners = positionsOf(sphere, reversed);
  const Vector3 middle = enclosed(corners).stableNormalized();
  const Eigen::VectorXd cosines = corners * middle;
  if (!(cosines.minCoeff() > narrowest))
  {
    return {};
  }
  corners.array().colwise() /= cosines.array(); // gnomonic: great circles become straight
  Triangles cap = triangulatePolygon(corners);
  for (Index i = 0; i < cap.size(); ++i)
  {
    cap.data()[i] = reversed[cap.data()[i]];
  }
  return cap;
}
}

CappedSheet withCaps(const MappedMesh& sheet)
{
  CappedSheet capped;
  static_cast<MappedMesh&>(capped) = sheet;
  const std::vector<BorderLoop> loops = borderLoops(sheet);
  for (const BorderLoop& loop : loops)
  {
    const Triangles cap =
      &loop == &loops.front() ? Triangles() : flatCap(sheet.SpherePositions, loop);
    if (cap.rows() > 0)
    {
      append(capped.Triangles, cap);
      continue;
    }
    const Vector3 around = enclosed(positionsOf(sheet.SpherePositions, loop));
    addFan(capped, loop, -around.stableNormalized());
  }
  capped.NumberOfCapVertices = capped.Positions.rows() - sheet.Positions.rows();
  capped.NumberOfCapTriangles = capped.Triangles.rows() - sheet.Triangles.rows();
  return capped;
}
}
