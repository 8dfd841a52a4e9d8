#include "vtkSphericalRegistration.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Register/SphericalRegistration.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSphericalRegistration;
constexpr unsigned int Reads = BadPoints | BadIds | BadMap;

Setter Registers(int space, bool hasLandmarks)
{
  return Set<F>(
    [=](F* f)
    {
      f->SetSpaceOfTransforms(space);
      f->SetFrequency(8);
      for (int i = 0; hasLandmarks && i < 4; ++i)
      {
        f->AddLandmark(30 * i, 31 * i);
      }
    });
}

std::vector<Mode> Modes()
{
  // The output has the moving surface's own polygons, as they are oriented.
  Mode free = { "Diffeomorphic", { Surface(Reads), Surface(Reads, "fixed") },
    Registers(F::DIFFEOMORPHIC, false) };
  free.ResultOfMap = "SpherePosition";
  free.IsSlow = true;
  free.Properties = { Integer("SpaceOfTransforms", &F::SetSpaceOfTransforms),
    Number("ShapeWeight", &F::SetShapeWeight), Number("StretchWeight", &F::SetStretchWeight),
    Values<F, vtkIdType>(
      "landmark", ExtremeIds(), [](F* f, vtkIdType id) { f->AddLandmark(id, 3); }),
    Values<F, double>("landmark position", ExtremeValues(),
      [](F* f, double value) { f->AddLandmarkPosition(value, 0.0, 0.0, 1.0, value, 0.0); }),
    Values<F, double>(
      "feature", ExtremeValues(), [](F* f, double value) { f->AddFeature("Weights", value); }) };
  Mode rotation = { "Rotation, landmarks", { Surface(Reads), Good() },
    Registers(F::ROTATION, true) };
  rotation.Properties = { Integer("Frequency", &F::SetFrequency) };
  const Mode landmarks = { "landmarks", { Surface(BadIds | BadMap), Good() },
    Registers(F::DIFFEOMORPHIC, true) };
  return { free, rotation, landmarks };
}

ProgressRun RegistersOn(const char* name, int space)
{
  return { name,
    [=]() -> Maker
    {
      const SurfacePointer head = Head(25), limbs = Limbs(25);
      return [=]() -> Algorithm
      {
        const auto registration = vtkSmartPointer<F>::New();
        registration->SetInputData(head);
        registration->SetFixedData(limbs);
        registration->SetSpaceOfTransforms(space);
        return registration;
      };
    } };
}

// Without features of its own, or by landmarks, most of which fix the rotation: what takes a
// second otherwise.
void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> registration;
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

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SphericalRegistrationOptions options;
  vtkNew<vtkSphericalRegistration> filter;
  using Filter = vtkSphericalRegistration;
  using conformal::SpaceOfTransforms;
  return {
    Same("SpaceOfTransforms", filter->GetSpaceOfTransforms(), static_cast<int>(options.Space)),
    Same("ShapeWeight", filter->GetShapeWeight(), options.ShapeWeight),
    Same("StretchWeight", filter->GetStretchWeight(), options.StretchWeight),
    Same("Frequency", filter->GetFrequency(), options.Frequency),
    Same("ROTATION", Filter::ROTATION, static_cast<int>(SpaceOfTransforms::Rotation)),
    Same("MOEBIUS", Filter::MOEBIUS, static_cast<int>(SpaceOfTransforms::Moebius)),
    Same("DIFFEOMORPHIC", Filter::DIFFEOMORPHIC, static_cast<int>(SpaceOfTransforms::Diffeomorphic))
  };
}
}

Case SphericalRegistration()
{
  Case all = CaseOf<F>("vtkSphericalRegistration");
  all.Modes = Modes();
  all.Scaled = { Scaled<F>("Registers",
    [](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale, 7));
      f->SetFixedData(BumpyMesh(scale, 5));
      f->SetFrequency(8);
    }) };
  all.Progress = { RegistersOn("Diffeomorphic", F::DIFFEOMORPHIC),
    RegistersOn("Rotation", F::ROTATION) };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
