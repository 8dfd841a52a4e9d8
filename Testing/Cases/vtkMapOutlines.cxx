#include "vtkMapOutlines.h"

#include "FuzzFilter.h"
#include "Projections.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
// Triangles in a map of 1000 by 500 pixels.
vtkSmartPointer<vtkPolyData> Triangles(int count)
{
  auto outlines = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> polygons;
  for (int i = 0; i < count; ++i)
  {
    const double x = 50.0 + 900.0 * i / count, y = 100.0 + 37 * i % 200;
    const vtkIdType ids[] = { points->InsertNextPoint(x, y, 0.0),
      points->InsertNextPoint(x + 90.0, y + 20.0, 0.0),
      points->InsertNextPoint(x + 30.0, y + 110.0, 0.0) };
    polygons->InsertNextCell(3, ids);
  }
  outlines->SetPoints(points);
  outlines->SetPolys(polygons);
  return outlines;
}

// Outlines in pixels, among them surfaces that are none.
void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<vtkMapOutlines> filter;
  FuzzProjection(filter.Get(), source);
  filter->SetYAxis(source.below(2));
  const int width = 1 + source.byte();
  filter->SetImageSize(width, 1 + source.byte());
  filter->SetInputDataObject(0, source.surface());
  filter->SetInputDataObject(1, source.flag() ? Triangles(source.below(9)) : source.surface());
  fuzz::run(filter);
}
}

Case MapOutlines()
{
  using F = vtkMapOutlines;
  Case all = CaseOf<F>("vtkMapOutlines");
  Mode outlines = { "",
    { Surface(BadPoints | BadIds | BadMap), Outlines(BadPoints | BadIds, "outlines") },
    Set<F>(
      [](F* f)
      {
        f->SetImageSize(2, 2);
        f->SetYAxisToUp();
      }) };
  outlines.Properties = { Integer("Projection", &F::SetProjection),
    Number("CentralLongitude", &F::SetCentralLongitude),
    Number("CapsuleAspect", &F::SetCapsuleAspect), Vector2<F, int>("ImageSize", &F::SetImageSize),
    Integer("YAxis", &F::SetYAxis) };
  outlines.WritesAreas = true;
  all.Modes = { outlines };
  all.Scaled = { Scaled<F>(
    "MeasuresOutlines",
    [](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale));
      f->SetOutlinesData(Triangles(5));
    },
    { { "Area", 2 }, { "Length", 1 } }, 1e-6) };
  all.Progress = { Run<F>(
    "triangles", []() { return BumpyMesh(1.0, 60); },
    [](F* f) { f->SetOutlinesData(Triangles(100)); }) };
  all.Fuzz = Fuzz;
  all.Mirrors = ProjectionMirrors<F>;
  return all;
}
}
