#include "vtkSphericalResample.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Register/SphericalResample.h"
#include "Surfaces.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSphericalResample;
constexpr unsigned int Reads = BadPoints | BadIds | BadMap;

ScaledRun Carries(const char* name, int method)
{
  return Scaled<F>(name,
    [=](F* f, double scale)
    {
      const SurfacePointer source = BumpyMesh(scale, 7);
      vtkNew<vtkDoubleArray> numbers;
      numbers->SetName("Numbers");
      for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
      {
        numbers->InsertNextValue(source->GetPoint(i)[2] / scale);
      }
      source->GetPointData()->AddArray(numbers);
      f->SetInputData(BumpyMesh(scale, 5));
      f->SetSourceData(source);
      f->SetMethod(method);
    });
}

ProgressRun CarriesOn(const std::string& name, int target, int source, int method)
{
  return { name,
    [=]() -> Maker
    {
      const SurfacePointer to = Colored(Head(target)), from = Colored(Head(source));
      return [=]() -> Algorithm
      {
        const auto resample = vtkSmartPointer<F>::New();
        resample->SetInputData(to);
        resample->SetSourceData(from);
        resample->SetMethod(method);
        return resample;
      };
    } };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> resample;
  resample->SetInputDataObject(0, source.surface());
  resample->SetInputDataObject(1, source.surface());
  resample->SetMethod(source.below(2));
  if (source.flag())
  {
    resample->SetMaskArrayName("Priority");
  }
  fuzz::run(resample);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SphericalResampleOptions options;
  vtkNew<vtkSphericalResample> filter;
  using conformal::ResampleMethod;
  return { Same("Method", filter->GetMethod(), static_cast<int>(options.Method)),
    Same("BARYCENTRIC", vtkSphericalResample::BARYCENTRIC,
      static_cast<int>(ResampleMethod::Barycentric)),
    Same("AREA_ADAPTIVE", vtkSphericalResample::AREA_ADAPTIVE,
      static_cast<int>(ResampleMethod::AreaAdaptive)) };
}
}

Case SphericalResample()
{
  Case all = CaseOf<F>("vtkSphericalResample");
  Mode own = { "target", { Surface(Reads), Surface(Reads, "source") } };
  own.ResultOfMap = "Curvature";
  own.Properties = { Integer("Method", &F::SetMethod),
    Name("MaskArrayName", &F::SetMaskArrayName) };
  const Mode barycentric = { "target, barycentric",
    { Variant(Reads), Surface(Reads, "source, barycentric") },
    Set<F>([](F* f) { f->SetMethodToBarycentric(); }) };
  const Mode masked = { "target, mask", { Good(), Surface(Reads, "source, mask") },
    Set<F>([](F* f) { f->SetMaskArrayName("Curvature"); }) };
  all.Modes = { own, barycentric, masked };
  all.Scaled = { Carries("CarriesBetween", F::BARYCENTRIC),
    Carries("CarriesByAreas", F::AREA_ADAPTIVE) };
  for (const int method : { F::BARYCENTRIC, F::AREA_ADAPTIVE })
  {
    const std::string name = std::to_string(method);
    all.Progress.push_back(CarriesOn(name + ", to a coarse mesh", 60, 150, method));
    all.Progress.push_back(CarriesOn(name + ", to a fine mesh", 150, 60, method));
  }
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
