#include "vtkGenusZeroHull.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkGenusZeroHull> hull;
  hull->SetSpacing(source.between(0.08, 0.2)); // finer ones only take longer
  hull->SetOffset(source.between(0.9, 4.0));
  hull->SetPersistence(source.between(1.1, 3.0));
  hull->SetSmoothingPasses(source.below(20));
  hull->SetDistributeOutput(source.flag());
  hull->SetInputDataObject(0, source.surface());
  hull->SetMethod(source.below(3));
  fuzz::run(hull, true);
  return 0;
}
