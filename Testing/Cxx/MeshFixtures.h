// Meshes to be broken, shared by the tests of what reads meshes.
#ifndef MeshFixtures_h
#define MeshFixtures_h

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace fixtures
{
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
}

#endif
