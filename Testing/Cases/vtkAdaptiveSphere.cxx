#include "vtkAdaptiveSphere.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Sphere/AdaptiveSphere.h"
#include "Surfaces.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkAdaptiveSphere;
constexpr unsigned int Reads = BadPoints | BadIds | BadMap;

Mode DensityMode(
  const char* name, const std::vector<Port>& ports, const std::function<void(F*)>& set)
{
  Mode mode = { name, ports,
    Set<F>(
      [=](F* f)
      {
        f->SetNumberOfPoints(500);
        set(f);
      }),
    true };
  mode.IsUnitless = true;
  return mode;
}

ScaledRun MakesASphere(int density)
{
  return Scaled<F>("Density" + std::to_string(density),
    [=](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale));
      f->SetNumberOfPoints(700);
      f->SetDensity(density);
    },
    { { "Points", 0 } }); // of the unit sphere
}

ProgressRun Makes(
  const char* name, const std::function<SurfacePointer()>& input, int size, int density)
{
  return Run<F>(name, input,
    [=](F* sphere)
    {
      sphere->SetNumberOfPoints(size);
      sphere->SetDensity(density);
      if (density == F::IMAGE)
      {
        sphere->SetImageData(LargePicture());
      }
    });
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> sphere;
  sphere->SetNumberOfPoints(500 + source.byte());
  sphere->SetDensity(source.below(4));
  sphere->SetDensityArrayName(source.flag() ? "Priority" : "Colors");
  sphere->SetInputData(source.surface());
  if (source.flag())
  {
    sphere->SetImageData(source.picture());
  }
  fuzz::run(sphere, true);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::AdaptiveSphereOptions options;
  vtkNew<vtkAdaptiveSphere> filter;
  using Limits = conformal::AdaptiveSphereLimits;
  return { Same("NumberOfPoints", filter->GetNumberOfPoints(), options.NumberOfPoints),
    Same("NumberOfPointsMinValue", filter->GetNumberOfPointsMinValue(), Limits::MinimumPoints),
    Same("NumberOfPointsMaxValue", filter->GetNumberOfPointsMaxValue(), Limits::MaximumPoints) };
}
}

Case AdaptiveSphere()
{
  Case all = CaseOf<F>("vtkAdaptiveSphere");
  Mode area = DensityMode("Area", { Surface(Reads) }, [](F*) {});
  area.Properties = { Integer("NumberOfPoints", &F::SetNumberOfPoints),
    Integer("Density", &F::SetDensity) };
  Mode array = DensityMode("Array", { Surface(Reads) },
    [](F* f)
    {
      f->SetDensityToArray();
      f->SetDensityArrayName("Priority");
    });
  array.Properties = { Name("DensityArrayName", &F::SetDensityArrayName) };
  all.Modes = { area,
    DensityMode("Curvature", { Surface(Reads) }, [](F* f) { f->SetDensityToCurvature(); }), array,
    DensityMode(
      "Image", { Surface(Reads), Picture("picture") }, [](F* f) { f->SetDensityToImage(); }) };
  all.Scaled = { MakesASphere(F::AREA), MakesASphere(F::CURVATURE) };
  all.Progress = { Makes(
                     "Area", []() { return Limbs(40); }, 30000, F::AREA),
    Makes(
      "Area of a fine mesh", []() { return Head(200); }, 5000, F::AREA),
    Makes(
      "Curvature", []() { return Limbs(100); }, 30000, F::CURVATURE),
    Makes(
      "Image", []() { return Head(40); }, 30000, F::IMAGE) };
  all.Mirrors = Mirrors;
  all.Fuzz = Fuzz;
  return all;
}
}
