// Meshes to be broken, shared by the tests of what reads meshes.
#ifndef MeshFixtures_h
#define MeshFixtures_h

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "vtkGeodesicSphereSource.h"

namespace fixtures
{
/// A mapped ellipsoid of three different axes, away from the origin; 10 f^2 + 2 points.
inline vtkNew<vtkPolyData> Ellipsoid(int frequency = 4)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, 3.0 * p[0] + 10.0, 2.0 * p[1], p[2]);
  }
  return surface;
}

/// Polygons written anew, changed one by one: change(cell, ids) returns whether to keep it.
template <typename Change>
void ChangePolygons(vtkPolyData* surface, Change change)
{
  vtkNew<vtkCellArray> changed;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, ids);
    if (change(i, ids.Get()))
    {
      changed->InsertNextCell(ids);
    }
  }
  surface->SetPolys(changed);
}

/// Every so manieth triangle, from the first on, turned over.
inline void TurnOverEvery(vtkIdType step, vtkPolyData* surface)
{
  ChangePolygons(surface,
    [step](vtkIdType i, vtkIdList* ids)
    {
      if (i % step == 0)
      {
        const vtkIdType first = ids->GetId(0);
        ids->SetId(0, ids->GetId(1));
        ids->SetId(1, first);
      }
      return true;
    });
}
}

#endif
