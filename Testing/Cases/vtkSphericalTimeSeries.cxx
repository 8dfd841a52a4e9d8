#include "vtkSphericalTimeSeries.h"

#include "FuzzFilter.h"
#include "Motion/SphericalTimeSeries.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSphericalTimeSeries;

std::vector<Mode> Modes()
{
  Mode whole = { "", { Surface(BadPoints | BadIds | BadMap) },
    SetWith<F>(
      [](F* f, vtkPolyData* good)
      {
        f->AddInputDataObject(good);
        f->SetFrequency(8);
        f->SetNumberOfSweeps(0);
      }) };
  whole.IsSlow = true;
  whole.TakesMore = true;
  whole.Properties = { Integer("ReferenceStep", &F::SetReferenceStep),
    Integer("NumberOfSweeps", &F::SetNumberOfSweeps), Integer("Frequency", &F::SetFrequency),
    Number("TimeInterval", &F::SetTimeInterval), Number("PositionWeight", &F::SetPositionWeight),
    Number("ShapeWeight", &F::SetShapeWeight), Number("StretchWeight", &F::SetStretchWeight),
    Name("LandmarkArrayName", &F::SetLandmarkArrayName) };
  return { whole };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> series;
  series->SetFrequency(8);
  series->SetShapeWeight(0.0);
  series->SetNumberOfSweeps(source.below(2));
  series->SetReferenceStep(source.below(3));
  series->SetPositionWeight(source.number());
  for (int i = 1 + source.below(3); i > 0; --i)
  {
    series->AddInputDataObject(0, source.surface());
  }
  fuzz::run(series);
}

// Defaults of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SphericalTimeSeriesOptions options;
  vtkNew<vtkSphericalTimeSeries> filter;
  return { Same("PositionWeight", filter->GetPositionWeight(), options.Registration.PositionWeight),
    Same("ShapeWeight", filter->GetShapeWeight(), options.Registration.ShapeWeight),
    Same("StretchWeight", filter->GetStretchWeight(), options.Registration.StretchWeight),
    Same("Frequency", filter->GetFrequency(), options.Registration.Frequency),
    Same("NumberOfSweeps", filter->GetNumberOfSweeps(), options.NumberOfSweeps),
    Same("ReferenceStep", filter->GetReferenceStep(), static_cast<int>(options.Reference)) };
}
}

Case SphericalTimeSeries()
{
  Case all = CaseOf<F>("vtkSphericalTimeSeries");
  all.Modes = Modes();
  all.Scaled = { Scaled<F>("FindsMotion",
    [](F* f, double scale)
    {
      f->AddInputDataObject(BumpyMesh(scale, 7));
      f->AddInputDataObject(BumpyMesh(scale, 5));
      f->SetFrequency(8);
      f->SetNumberOfSweeps(0);
      f->SetShapeWeight(0.0);
    },
    { { "Velocity", 1 }, { "NormalVelocity", 1 }, { "TangentialVelocity", 1 },
      { "MeanNormalSpeed", 1 }, { "MeanTangentialSpeed", 1 } }) };
  all.Progress = { { "three surfaces",
    []() -> Maker
    {
      const SurfacePointer head = Head(25), coarse = Head(15);
      return [=]() -> Algorithm
      {
        const auto filter = vtkSmartPointer<F>::New();
        for (vtkPolyData* surface : { head.Get(), coarse.Get(), head.Get() })
        {
          filter->AddInputDataObject(surface);
        }
        filter->SetNumberOfSweeps(0);
        return filter;
      };
    } } };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
