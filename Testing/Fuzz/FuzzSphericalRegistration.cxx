#include "vtkSphericalRegistration.h"
#include "vtkSphericalTemplate.h"

#include "FuzzFilter.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

namespace
{
// Without features of its own, or by landmarks, most of which fix the rotation: what takes a
// second otherwise.
void registerTwo(fuzz::FilterSource& source)
{
  vtkNew<vtkSphericalRegistration> registration;
  registration->SetFrequency(8);
  registration->SetSpaceOfTransforms(source.below(3));
  registration->SetShapeWeight(source.below(8) == 1 ? source.number() : 0.0);
  registration->SetStretchWeight(source.flag() ? source.number() : 1.0);
  for (int i = source.flag() ? source.below(6) : 0; i > 0; --i)
  {
    const vtkIdType id = source.byte() - 4;
    registration->AddLandmark(id, source.byte() - 4);
  }
  if (source.below(4) == 1)
  {
    const double x = source.number(), y = source.number(), z = source.number();
    registration->AddLandmarkPosition(x, y, z, z, x, y);
  }
  registration->SetInputDataObject(0, source.surface());
  registration->SetInputDataObject(1, source.surface());
  fuzz::run(registration);
}

void registerMany(fuzz::FilterSource& source)
{
  vtkNew<vtkSphericalTemplate> many;
  many->SetFrequency(8);
  many->SetMeanFrequency(8);
  many->SetShapeWeight(0.0);
  many->SetMaximumNumberOfRounds(source.below(3));
  many->SetAlignment(source.below(3));
  many->SetTolerance(source.number());
  for (int i = 1 + source.below(3); i > 0; --i)
  {
    many->AddInputDataObject(0, source.surface());
  }
  fuzz::run(many);
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  if (source.below(3) == 1)
  {
    registerMany(source);
  }
  else
  {
    registerTwo(source);
  }
  return 0;
}
