#include "Glue/CloudNormals.h"

#include "Cloud/TrainingSamples.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/VertexNormals.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace glue
{
namespace
{
std::int64_t CountUsed(const conformal::Triangles& triangles, vtkIdType numberOfPoints)
{
  std::vector<bool> used(numberOfPoints, false);
  for (conformal::Index i = 0; i < triangles.size(); ++i)
  {
    used[triangles.data()[i]] = true;
  }
  return std::count(used.begin(), used.end(), true);
}

// Drop triangles with a corner that is not finite, which have no normal.
void DropInfinite(const conformal::Points& points, conformal::Triangles& triangles)
{
  conformal::Index kept = 0;
  for (conformal::Index r = 0; r < triangles.rows(); ++r)
  {
    if (points.row(triangles(r, 0)).allFinite() && points.row(triangles(r, 1)).allFinite() &&
      points.row(triangles(r, 2)).allFinite())
    {
      triangles.row(kept++) = triangles.row(r);
    }
  }
  triangles.conservativeResize(kept, 3);
}
}

//------------------------------------------------------------------------------
void FindNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::Reduce& reduce, bool needed, CloudNormals& normals)
{
  vtkPolyData* surface = vtkPolyData::SafeDownCast(input);
  vtkDataArray* array = input->GetPointData()->GetNormals();
  const vtkIdType size = input->GetNumberOfPoints();
  conformal::Triangles triangles;
  if (HasTriangles(surface) && (needed || HasCellIds(surface)))
  {
    triangles = ToTriangles(surface);
  }
  const bool hasArray = array && array->GetNumberOfComponents() == 3;
  std::int64_t counts[] = { size, CountUsed(triangles, size), size > 0 && !hasArray };
  reduce.sum(counts, 3);
  const bool byTriangles = 2 * counts[1] > counts[0];
  normals.Known = counts[0] > 0 && (byTriangles || counts[2] == 0);
  if (size == 0 || !normals.Known)
  {
    return;
  }
  if (!byTriangles)
  {
    normals.View = ViewVectors(array, "normals", normals.Copy);
    return;
  }
  conformal::orientConsistently(triangles);
  conformal::Points points = ToPoints(input->GetPoints(), frame);
  DropInfinite(points, triangles);
  // Points with coordinates that are not finite are left out later.
  points = points.array().isFinite().select(points, 0.0);
  normals.Copy = conformal::vertexNormals(points, triangles);
  normals.View = normals.Copy;
}

//------------------------------------------------------------------------------
void SetNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  conformal::HullMethod method, conformal::TrainingSamples& samples, CloudNormals& normals)
{
  if (method == conformal::HullMethod::Distance)
  {
    return;
  }
  const bool needed = method == conformal::HullMethod::WindingNumbers;
  FindNormals(input, frame, samples.reduce(), needed, normals);
  if (normals.Known)
  {
    samples.setNormals(normals.View);
  }
}
}
