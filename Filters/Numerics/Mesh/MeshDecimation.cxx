#include "Mesh/MeshDecimation.h"

#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/QuadricCollapse.h"

#include <algorithm>
#include <stdexcept>

namespace conformal
{
DecimatedMesh decimate(const Mesh& mesh, Index numberOfVertices, const Run& run)
{
  if (numberOfVertices < 4)
  {
    throw std::invalid_argument("a closed surface must have at least 4 vertices");
  }
  Steps steps(run, { 0.06, 0.06, 0.87, 0.01 }); // check, tables, collapses, result
  requireGenusZero(mesh.Triangles, mesh.Positions.rows(), steps.next());
  steps.next();
  const Points places = inUnitBox(mesh.Positions);
  VertexRings rings(mesh.Triangles, mesh.Positions.rows());
  QuadricCollapse collapses(places, rings);
  const Run collapsing = steps.next();
  const Index used = mesh.Triangles.rows() / 2 + 2;
  constexpr Index stride = 1 << 10;
  for (Index count = used; count > numberOfVertices; --count)
  {
    collapses.next();
    if (count % stride == 0)
    {
      collapsing.report(
        static_cast<double>(used - count) / static_cast<double>(used - numberOfVertices));
    }
  }

  steps.next();
  DecimatedMesh result;
  result.Triangles = rings.triangles();
  result.PointIds = dropIsolatedPoints(result.Triangles, mesh.Positions.rows());
  result.Positions.resize(static_cast<Index>(result.PointIds.size()), 3);
  for (std::size_t i = 0; i < result.PointIds.size(); ++i)
  {
    result.Positions.row(static_cast<Index>(i)) = mesh.Positions.row(result.PointIds[i]);
  }
  run.report(1.0);
  return result;
}
}
