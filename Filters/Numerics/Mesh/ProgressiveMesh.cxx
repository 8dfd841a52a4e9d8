#include "Mesh/ProgressiveMesh.h"

#include <algorithm>

namespace conformal
{
ProgressiveMesh makeProgressiveMesh(
  const Mesh& mesh, QuadricCollapse::Needles needles, const Run& run)
{
  const Points& points = mesh.Positions;
  const Triangles& triangles = mesh.Triangles;
  ProgressiveMesh result = { VertexRings(triangles, points.rows()), {} };
  QuadricCollapse collapses(points, result.Rings, needles);
  const Index count = triangles.rows() / 2 - 2;
  result.Splits.reserve(count);
  constexpr Index stride = 1 << 10;
  for (Index i = 0; i < count; ++i)
  {
    result.Splits.push_back(collapses.next());
    if (i % stride == 0)
    {
      run.report(static_cast<double>(i) / static_cast<double>(count));
    }
  }
  std::reverse(result.Splits.begin(), result.Splits.end());
  run.report(1.0);
  return result;
}
}
