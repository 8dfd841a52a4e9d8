#include "vtkSurfaceMismatch.h"

#include "FuzzFilter.h"
#include "Measure/SurfaceMismatch.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSurfaceMismatch;
constexpr unsigned int Reads = BadPoints | BadIds;

Mode UnitMode(const char* name, const std::vector<Port>& ports, int unit)
{
  Mode mode = { name, ports,
    Set<F>(
      [=](F* f)
      {
        f->SetNumberOfSamples(500);
        f->SetLengthUnit(unit);
      }) };
  mode.MixesUnits = true;
  mode.WritesAreas = unit == F::NONE;
  return mode;
}

ScaledRun Measures(int unit, bool isCloud)
{
  const bool none = unit == F::NONE;
  ScaledRun run = Scaled<F>("Unit" + std::to_string(unit) + (isCloud ? "Cloud" : "Mesh"),
    [=](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale, 5));
      f->SetReferenceData(isCloud ? BumpyCloud(scale) : BumpyMesh(scale, 7));
      f->SetLengthUnit(unit);
      f->SetNumberOfSamples(2000);
    });
  run.Powers = { { "LengthUnit", 1 } };
  if (none)
  {
    run.Powers = { { "HausdorffDistance", 1 }, { "MeanSquarePointToSurface", 2 },
      { "MeanSquarePointToVertex", 2 }, { "MeanSquareSurfaceToPoint", 2 },
      { "RootMeanSquareCurvatureError", -1 } };
    run.Ignored = { "WebFraction" }; // farther than 0.02 in this unit
  }
  return run;
}

ProgressRun MeasuresOn(const char* name, const std::function<SurfacePointer()>& model,
  const std::function<SurfacePointer()>& reference, int samples)
{
  return { name,
    [=]() -> Maker
    {
      const SurfacePointer first = model(), second = reference();
      return [=]() -> Algorithm
      {
        const auto mismatch = vtkSmartPointer<F>::New();
        mismatch->SetInputData(first);
        mismatch->SetReferenceData(second);
        if (samples > 0)
        {
          mismatch->SetNumberOfSamples(samples);
        }
        return mismatch;
      };
    } };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> mismatch;
  mismatch->SetInputDataObject(0, source.surface());
  mismatch->SetLengthUnit(source.below(3));
  mismatch->SetNumberOfSamples(1 + source.byte());
  mismatch->SetInputDataObject(1, source.surface());
  fuzz::run(mismatch);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SurfaceMismatchOptions options;
  vtkNew<vtkSurfaceMismatch> filter;
  using conformal::MismatchUnit;
  return { Same("LengthUnit", filter->GetLengthUnit(), static_cast<int>(options.LengthUnit)),
    Same("NumberOfSamples", filter->GetNumberOfSamples(), options.NumberOfSamples),
    Same("RandomSeed", filter->GetRandomSeed(), options.RandomSeed),
    Same("CurvatureRadius", filter->GetCurvatureRadius(), options.CurvatureRadius),
    Same("MAX_RADIUS", vtkSurfaceMismatch::MAX_RADIUS, static_cast<int>(MismatchUnit::MaxRadius)),
    Same("HALF_DIAGONAL", vtkSurfaceMismatch::HALF_DIAGONAL,
      static_cast<int>(MismatchUnit::HalfDiagonal)),
    Same("NONE", vtkSurfaceMismatch::NONE, static_cast<int>(MismatchUnit::None)) };
}
}

Case SurfaceMismatch()
{
  Case all = CaseOf<F>("vtkSurfaceMismatch");
  Mode model = UnitMode("model", { Surface(Reads), Surface(Reads, "reference") }, F::MAX_RADIUS);
  model.Properties = { Integer("LengthUnit", &F::SetLengthUnit),
    Integer("NumberOfSamples", &F::SetNumberOfSamples), Integer("RandomSeed", &F::SetRandomSeed),
    Number("CurvatureRadius", &F::SetCurvatureRadius) };
  all.Modes = { model, UnitMode("half diagonal", { Good(), Good() }, F::HALF_DIAGONAL),
    UnitMode("no unit", { Good(), Variant(Reads, "reference, no unit") }, F::NONE) };
  for (int unit = F::MAX_RADIUS; unit <= F::NONE; ++unit)
  {
    for (const bool isCloud : { false, true })
    {
      all.Scaled.push_back(Measures(unit, isCloud));
    }
  }
  const auto fine = []() { return Head(120); };
  const auto coarse = []() { return Head(40); };
  all.Progress = { MeasuresOn(
                     "to a cloud", coarse, []() { return PointsOf(Head(120)); }, 0),
    MeasuresOn("to a mesh", coarse, fine, 0), MeasuresOn("of a fine mesh", fine, coarse, 0),
    MeasuresOn(
      "few samples", []() { return Head(150); }, coarse, 1000) };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
