#include "vtkGeodesicSphereSource.h"

#include "Properties.h"

namespace cases
{
Case GeodesicSphereSource()
{
  using F = vtkGeodesicSphereSource;
  Case all = CaseOf<F>("vtkGeodesicSphereSource");
  Mode sphere = { "", {}, {}, true };
  sphere.Properties = { Integer("Frequency", &F::SetFrequency) };
  all.Modes = { sphere };
  all.Progress = { { "fine",
    []() -> Maker
    {
      return []() -> Algorithm
      {
        const auto source = vtkSmartPointer<F>::New();
        source->SetFrequency(600);
        return source;
      };
    } } };
  return all;
}
}
