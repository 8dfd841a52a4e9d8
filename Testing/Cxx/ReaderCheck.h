// Check whether the output of a reader is valid.
#ifndef ReaderCheck_h
#define ReaderCheck_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

namespace contract
{
inline bool IsFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

/// Return a description of the first fault of a surface. A fault is an id out of range, an array of
/// a wrong length, or a number that is not finite. If there is no fault, return an empty text.
inline std::string WhatIsWrong(vtkPolyData* surface)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  vtkNew<vtkIdList> ids;
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, ids);
      for (const vtkIdType id : *ids)
      {
        if (id < 0 || id >= points)
        {
          return "id out of range";
        }
      }
    }
  }
  if (points > 0 && !IsFinite(surface->GetPoints()->GetData()))
  {
    return "point not finite";
  }
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(surface->GetPointData()),
         static_cast<vtkDataSetAttributes*>(surface->GetCellData()) })
  {
    const vtkIdType tuples = data == surface->GetPointData() ? points : surface->GetNumberOfCells();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (data->GetAbstractArray(i)->GetNumberOfTuples() != tuples)
      {
        return "array of the wrong length";
      }
      if (!IsFinite(data->GetArray(i)))
      {
        return "value not finite";
      }
    }
  }
  return {};
}
}

#endif
