#include "vtkGenusZeroCheck.h"

#include "Case.h"
#include "FuzzFilter.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
Case GenusZeroCheck()
{
  using F = vtkGenusZeroCheck;
  Case all = CaseOf<F>("vtkGenusZeroCheck");
  all.Modes = { { "", { Surface(BadIds) } } };
  all.Scaled = { Scaled<F>(
    "Checks", [](F* f, double scale) { f->SetInputData(BumpyMesh(scale)); }) };
  all.Progress = { Run<F>("fine", []() { return Head(250); }) };
  all.Fuzz = [](fuzz::FilterSource& source)
  {
    vtkNew<F> check;
    check->SetInputDataObject(0, source.surface());
    fuzz::run(check);
  };
  return all;
}
}
