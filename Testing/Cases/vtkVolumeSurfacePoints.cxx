#include "vtkVolumeSurfacePoints.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Surfaces.h"
#include "Volume/VolumeSurface.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
// Defaults of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::VolumeSurfaceOptions options;
  vtkNew<vtkVolumeSurfacePoints> filter;
  return { Same("Smoothing", filter->GetSmoothing(), options.Smoothing),
    Same("LevelMethod", filter->GetLevelMethod() == vtkVolumeSurfacePoints::OTSU,
      options.UseOtsuLevel),
    Same("Level", filter->GetLevel(), options.Level),
    Same("ClosingRadius", filter->GetClosingRadius(), options.ClosingRadius),
    Same("LargestObject", filter->GetLargestObject(), options.LargestObject) };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<vtkVolumeSurfacePoints> filter;
  filter->SetComponent(source.below(2));
  filter->SetLevelMethod(source.below(2));
  filter->SetLargestObject(source.flag());
  if (source.flag())
  {
    filter->SetLevel(source.number());
    filter->SetSmoothing(source.number());
    filter->SetClosingRadius(source.number());
  }
  filter->SetInputDataObject(0, source.volume());
  fuzz::run(filter);
}
}

Case VolumeSurfacePoints()
{
  using F = vtkVolumeSurfacePoints;
  Case all = CaseOf<F>("vtkVolumeSurfacePoints");
  Mode points = { "", { Picture() } };
  points.Properties = { Name("ArrayName", &F::SetArrayName), Integer("Component", &F::SetComponent),
    Number("Smoothing", &F::SetSmoothing), Integer("LevelMethod", &F::SetLevelMethod),
    Number("Level", &F::SetLevel), Number("ClosingRadius", &F::SetClosingRadius),
    Switch("LargestObject", &F::SetLargestObject) };
  all.Modes = { points };
  all.Progress = { { "ball",
    []() -> Maker
    {
      const vtkSmartPointer<vtkImageData> ball = BallVolume(90);
      return [=]() -> Algorithm
      {
        auto filter = vtkSmartPointer<F>::New();
        filter->SetInputDataObject(ball);
        return filter;
      };
    } } };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
