#include "vtkSphericalAlignment.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkSphericalAlignment> alignment;
  alignment->SetTransform(source.below(2));
  for (int i = source.flag() ? source.below(6) : 0; i > 0; --i)
  {
    const vtkIdType id = source.byte() - 4;
    alignment->AddLandmark(id, source.byte() - 4);
  }
  alignment->SetInputDataObject(0, source.surface());
  alignment->SetInputDataObject(1, source.surface());
  fuzz::run(alignment);
  return 0;
}
