#include "MeshDecimation.h"

#include "GenusZeroCheck.h"
#include "QuadricCollapse.h"
#include "UnitBox.h"

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
  requireGenusZero(triangles, points.rows());
  const Points places = inUnitBox(points);
  report(progress, 0.1);
  VertexRings rings(triangles, points.rows());
  QuadricCollapse collapses(places, rings);
  const Index used = triangles.rows() / 2 + 2;
  constexpr Index stride = 1 << 10;
  for (Index count = used; count > numberOfVertices; --count)
  {
    collapses.next();
    if (count % stride == 0)
    {
      report(progress,
        0.2 +
          0.8 * static_cast<double>(used - count) / static_cast<double>(used - numberOfVertices));
    }
  }

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
