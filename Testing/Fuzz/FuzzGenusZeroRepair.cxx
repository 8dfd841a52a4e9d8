#include "vtkGenusZeroRepair.h"

#include "FuzzFilter.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

// What says that it is of genus zero must be so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkGenusZeroRepair> repair;
  repair->SetMaximumHoleArea(source.flag() ? source.number() : 1.0);
  repair->SetInputDataObject(0, source.surface());
  fuzz::run(repair);
  vtkPolyData* repaired = repair->GetOutput();
  vtkDataArray* claim = repaired->GetFieldData()->GetArray("IsGenusZero");
  if (claim && claim->GetTuple1(0) == 1.0)
  {
    fuzz::require(
      { hostile::IsClosedSphere(repaired) ? hostile::Verdict::Fine : hostile::Verdict::Wrong,
        "IsGenusZero is wrong" },
      repair->GetClassName());
  }
  return 0;
}
