#include "Mesh/ProgressiveMesh.h"

#include <algorithm>

namespace conformal
{
ProgressiveMesh makeProgressiveMesh(const Points& points, const Triangles& triangles,
  QuadricCollapse::Needles needles, const Progress& progress)
{
  ProgressiveMesh mesh = { VertexRings(triangles, points.rows()), {} };
  QuadricCollapse collapses(points, mesh.Rings, needles);
  const Index count = triangles.rows() / 2 - 2;
  mesh.Splits.reserve(count);
  constexpr Index stride = 1 << 10;
  for (Index i = 0; i < count; ++i)
  {
    mesh.Splits.push_back(collapses.next());
    if (i % stride == 0)
    {
      report(progress, static_cast<double>(i) / static_cast<double>(count));
    }
  }
  std::reverse(mesh.Splits.begin(), mesh.Splits.end());
  report(progress, 1.0);
  return mesh;
}
}
