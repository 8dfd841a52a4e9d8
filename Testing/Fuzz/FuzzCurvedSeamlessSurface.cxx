#include "vtkCurvedSeamlessSurface.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkCurvedSeamlessSurface> surface;
  surface->SetFrequency(1 + source.below(4));
  surface->SetSeamMode(source.below(2));
  surface->SetDomeHeight(source.below(5));
  surface->SetNumberOfFitRounds(source.below(3));
  const int odd = source.byte();
  if (odd & 1)
  {
    surface->SetVertexShift(source.number());
    surface->SetFitSmoothness(source.number());
  }
  surface->SetInputDataObject(0, source.surface());
  if (odd & 2)
  {
    surface->SetInputDataObject(2, source.surface());
  }
  const bool hasSphere = (odd & 12) == 12;
  if (hasSphere)
  {
    surface->SetInputDataObject(1, source.surface());
  }
  fuzz::run(surface, !hasSphere);
  return 0;
}
