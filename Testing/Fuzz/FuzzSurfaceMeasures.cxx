#include "vtkConformalDistortion.h"
#include "vtkGenusZeroCheck.h"
#include "vtkSurfaceMismatch.h"
#include "vtkSurfaceShape.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  const auto surface = source.surface();
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputDataObject(0, surface);
  fuzz::run(check);

  vtkNew<vtkConformalDistortion> distortion;
  distortion->SetInputDataObject(0, surface);
  fuzz::run(distortion);

  vtkNew<vtkSurfaceShape> shape;
  shape->SetInputDataObject(0, surface);
  fuzz::run(shape);

  vtkNew<vtkSurfaceMismatch> mismatch;
  mismatch->SetLengthUnit(source.below(3));
  mismatch->SetNumberOfSamples(1 + source.byte());
  mismatch->SetInputDataObject(0, surface);
  mismatch->SetInputDataObject(1, source.surface());
  fuzz::run(mismatch);
  return 0;
}
