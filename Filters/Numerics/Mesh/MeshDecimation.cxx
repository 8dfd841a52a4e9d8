#include "Mesh/MeshDecimation.h"

#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/QuadricCollapse.h"

#include <algorithm>
#include <stdexcept>

namespace conformal
{
DecimatedMesh decimate(const Points& points, const Triangles& triangles, Index numberOfVertices,
  const Progress& progress)
{
  if (numberOfVertices < 4)
  {
    throw std::invalid_argument("a closed surface has at least 4 vertices");
  }
  // For each vertex, but collapsing.
  const auto size = static_cast<double>(points.rows());
  const double collapsed = std::max(0.0, size - static_cast<double>(numberOfVertices));
  Steps steps(progress, { 580.0 * size, 600.0 * size, 9000.0 * collapsed, 50.0 * size });
  requireGenusZero(triangles, points.rows(), steps.next());
  steps.next();
  const Points places = inUnitBox(points);
  VertexRings rings(triangles, points.rows());
  QuadricCollapse collapses(places, rings);
  const Progress collapsing = steps.next();
  const Index used = triangles.rows() / 2 + 2;
  constexpr Index stride = 1 << 10;
  for (Index count = used; count > numberOfVertices; --count)
  {
    collapses.next();
    if (count % stride == 0)
    {
      report(collapsing,
        static_cast<double>(used - count) / static_cast<double>(used - numberOfVertices));
    }
  }

  steps.next();
  DecimatedMesh result;
  result.Triangles = rings.triangles();
  result.PointIds = dropIsolatedPoints(result.Triangles, points.rows());
  result.Points.resize(static_cast<Index>(result.PointIds.size()), 3);
  for (std::size_t i = 0; i < result.PointIds.size(); ++i)
  {
    result.Points.row(static_cast<Index>(i)) = points.row(result.PointIds[i]);
  }
  report(progress, 1.0);
  return result;
}
}
