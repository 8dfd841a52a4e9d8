#include "vtkSurfaceGeodesics.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace cases
{
Case SurfaceGeodesics()
{
  using F = vtkSurfaceGeodesics;
  Case all = CaseOf<F>("vtkSurfaceGeodesics");
  const auto one = [](F* f) { f->SetNumberOfFarthestPoints(1); };
  Mode farthest = { "farthest points", { Surface(BadPoints | BadIds) }, Set<F>(one) };
  farthest.Properties = { Integer("Method", &F::SetMethod),
    Integer("NumberOfFarthestPoints", &F::SetNumberOfFarthestPoints),
    Name("SourceArrayName", &F::SetSourceArrayName),
    Values<F, vtkIdType>(
      "SourceIds", ExtremeIds(), [](F* f, const vtkIdType& id) { f->AddSourceId(id); }) };
  const Mode picked = { "picked points",
    { Variant(BadPoints | BadIds), Places(BadPoints, "sources"),
      Places(BadPoints, "starts of paths") } };
  const Mode exact = { "exact distances", { Surface(BadPoints | BadIds) },
    Set<F>(
      [](F* f)
      {
        f->SetMethodToExact();
        f->AddSourceId(0);
      }) };
  all.Modes = { farthest, picked, exact };
  all.Scaled = { Scaled<F>(
    "MeasuresDistances",
    [](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale));
      f->AddSourceId(5);
      vtkNew<vtkPolyData> starts;
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      points->InsertNextPoint(BumpyMesh(scale)->GetPoint(100));
      starts->SetPoints(points);
      f->SetTargetsData(starts);
    },
    { { "GeodesicDistance", 1 }, { "PathLength", 1 } }, 1e-7) };
  all.Progress = { Run<F>(
    "many", []() { return Head(60); }, [](F* f) { f->SetNumberOfFarthestPoints(20); }) };
  all.Fuzz = [](fuzz::FilterSource& source)
  {
    vtkNew<F> filter;
    filter->SetInputDataObject(0, source.surface());
    filter->SetNumberOfFarthestPoints(source.below(4));
    filter->SetMethod(source.below(2));
    fuzz::run(filter);
  };
  return all;
}
}
