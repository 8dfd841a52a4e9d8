#include "vtkSurfaceShape.h"

#include "FuzzFilter.h"
#include "Measure/SurfaceShape.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SurfaceShapeOptions options;
  vtkNew<vtkSurfaceShape> filter;
  return { Same("CurvatureScale", filter->GetCurvatureScale(), options.CurvatureScale),
    Same("DepthScale", filter->GetDepthScale(), options.DepthScale) };
}
}

Case SurfaceShape()
{
  using F = vtkSurfaceShape;
  Case all = CaseOf<F>("vtkSurfaceShape");
  Mode shape = { "", { Surface(BadPoints | BadIds) }, {}, true };
  shape.Properties = { Number("CurvatureScale", &F::SetCurvatureScale),
    Number("DepthScale", &F::SetDepthScale) };
  all.Modes = { shape };
  all.Scaled = { Scaled<F>("MeasuresShape",
    [](F* f, double scale) { f->SetInputData(BumpyMesh(scale)); },
    { { "SulcalDepth", 1 }, { "MeanCurvature", -1 }, { "GaussianCurvature", -2 } }) };
  const auto fine = []() { return Head(120); };
  all.Progress = { Run<F>("smoothed", fine),
    Run<F>("not smoothed", fine, [](F* f) { f->SetCurvatureScale(0.0); }) };
  all.Fuzz = [](fuzz::FilterSource& source)
  {
    const SurfacePointer surface = source.surface();
    // The filter passes a map as it is, also a damaged one.
    surface->GetPointData()->RemoveArray("SpherePosition");
    vtkNew<F> filter;
    filter->SetInputDataObject(0, surface);
    fuzz::run(filter);
  };
  all.Mirrors = Mirrors;
  return all;
}
}
