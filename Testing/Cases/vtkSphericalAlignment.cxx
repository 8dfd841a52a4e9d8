#include "vtkSphericalAlignment.h"

#include "FuzzFilter.h"
#include "Measure/SphericalAlignment.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSphericalAlignment;
constexpr unsigned int Reads = BadPoints | BadIds | BadMap;

Setter Transforms(int transform, bool hasLandmarks)
{
  return Set<F>(
    [=](F* f)
    {
      f->SetTransform(transform);
      for (int i = 0; hasLandmarks && i < 4; ++i)
      {
        f->AddLandmark(30 * i, 31 * i);
      }
    });
}

ScaledRun Aligns(const char* name, int transform)
{
  return Scaled<F>(name,
    [=](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale, 5));
      const SurfacePointer reference = BumpyMesh(scale, 6);
      vtkDataArray* map = reference->GetPointData()->GetArray("SpherePosition");
      for (vtkIdType i = 0; i < map->GetNumberOfTuples(); ++i)
      {
        double n[3];
        map->GetTuple(i, n);
        map->SetTuple3(i, n[1], n[2], n[0]);
      }
      f->SetReferenceData(reference);
      f->SetTransform(transform);
    });
}

ProgressRun AlignsOn(const char* name, int frequency, int transform)
{
  return { name,
    [=]() -> Maker
    {
      const SurfacePointer surface = Head(100), reference = Head(frequency);
      return [=]() -> Algorithm
      {
        const auto alignment = vtkSmartPointer<F>::New();
        alignment->SetInputData(surface);
        alignment->SetReferenceData(reference);
        alignment->SetTransform(transform);
        return alignment;
      };
    } };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> alignment;
  alignment->SetTransform(source.below(2));
  for (int i = source.flag() ? source.below(6) : 0; i > 0; --i)
  {
    const vtkIdType id = source.byte() - 4;
    alignment->AddLandmark(id, source.byte() - 4);
  }
  alignment->SetInputDataObject(0, source.surface());
  alignment->SetInputDataObject(1, source.surface());
  fuzz::run(alignment);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  using conformal::AlignmentKind;
  return { Same("ROTATION", vtkSphericalAlignment::ROTATION,
             static_cast<int>(AlignmentKind::Rotation)),
    Same("MOEBIUS", vtkSphericalAlignment::MOEBIUS, static_cast<int>(AlignmentKind::Moebius)) };
}
}

Case SphericalAlignment()
{
  Case all = CaseOf<F>("vtkSphericalAlignment");
  const Property landmarks = Values<F, vtkIdType>("landmark", ExtremeIds(),
    [](F* f, vtkIdType id)
    {
      for (int i = 0; i < 3; ++i)
      {
        f->AddLandmark(id, 3);
      }
    });
  Mode rotation = { "Rotation", { Surface(Reads), Surface(Reads, "reference") },
    Transforms(F::ROTATION, false) };
  rotation.ResultOfMap = "SpherePosition";
  rotation.MixesUnits = true;
  rotation.Properties = { Integer("Transform", &F::SetTransform), landmarks };
  Mode moebius = { "Moebius", { Surface(Reads), Variant(Reads, "reference, Moebius") },
    Transforms(F::MOEBIUS, false) };
  moebius.Properties = { landmarks };
  // Of the reference only the landmarks are read.
  const Mode byLandmarks = { "Moebius, landmarks",
    { Surface(BadIds | BadMap), Surface(BadMap, "reference, landmarks") },
    Transforms(F::MOEBIUS, true) };
  all.Modes = { rotation, moebius, byLandmarks };
  all.Scaled = { Aligns("Turns", F::ROTATION), Aligns("TransformsByMoebius", F::MOEBIUS) };
  all.Progress = { AlignsOn("coarse", 60, F::ROTATION), AlignsOn("fine", 250, F::ROTATION),
    AlignsOn("Moebius", 100, F::MOEBIUS) };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
