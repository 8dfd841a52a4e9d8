#include "vtkGlobalConformalMap.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkGlobalConformalMap> map;
  map->SetMethod(source.below(2));
  map->SetAreaBalance(source.flag() ? source.number() : 0.0);
  map->SetMaximumNumberOfIterations(source.below(50));
  map->SetTolerance(source.flag() ? source.number() : 1e-7);
  map->SetInputDataObject(0, source.surface());
  fuzz::run(map, true);
  return 0;
}
