#include "vtkCloudNormals.h"

#include "Mesh/VertexNormals.h"
#include "vtkConformalConversions.h"
#include "vtkInputChecks.h"
#include "vtkMeshConversions.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

namespace vtkConformalConversions
{
namespace
{
bool HasCellIds(vtkPolyData* surface)
{
  try
  {
    vtkInputChecks::RequireCellIds(surface);
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
  return true;
}
}

//------------------------------------------------------------------------------
void FindNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::Reduce& reduce, bool needed, CloudNormals& normals)
{
  vtkPolyData* surface = vtkPolyData::SafeDownCast(input);
  vtkDataArray* array = input->GetPointData()->GetNormals();
  const bool empty = input->GetNumberOfPoints() == 0;
  const bool hasTriangles = surface &&
    surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0 &&
    (needed || HasCellIds(surface));
  const bool hasArray = array && array->GetNumberOfComponents() == 3;
  std::int64_t counts[] = { !empty, !empty && !hasTriangles, !empty && !hasArray };
  reduce.sum(counts, 3);
  const bool triangles = counts[1] == 0;
  normals.Known = counts[0] > 0 && (triangles || counts[2] == 0);
  if (empty || !normals.Known)
  {
    return;
  }
  if (!triangles)
  {
    normals.View = ViewVectors(array, "normals", normals.Copy);
    return;
  }
  conformal::Points points = ToPoints(input->GetPoints(), frame);
  // One that is not finite is left out later; it must not spoil the others' unit.
  points = points.array().isFinite().select(points, 0.0);
  normals.Copy = conformal::vertexNormals(points, ToTriangles(surface));
  normals.View = normals.Copy;
}
}
