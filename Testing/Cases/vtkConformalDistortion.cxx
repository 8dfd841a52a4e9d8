#include "vtkConformalDistortion.h"

#include "Case.h"
#include "FuzzFilter.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
Case ConformalDistortion()
{
  using F = vtkConformalDistortion;
  Case all = CaseOf<F>("vtkConformalDistortion");
  Mode mode = { "", { Surface(BadPoints | BadIds | BadMap) } };
  mode.ResultOfMap = "AreaDistortion";
  all.Modes = { mode };
  all.Scaled = { Scaled<F>(
    "Measures", [](F* f, double scale) { f->SetInputData(BumpyMesh(scale)); }) };
  all.Progress = { Run<F>("fine", []() { return Head(250); }) };
  all.Fuzz = [](fuzz::FilterSource& source)
  {
    vtkNew<F> distortion;
    distortion->SetInputDataObject(0, source.surface());
    fuzz::run(distortion);
  };
  return all;
}
}
