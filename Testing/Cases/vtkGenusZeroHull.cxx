#include "vtkGenusZeroHull.h"

#include "FuzzFilter.h"
#include "Hull/GenusZeroHull.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkGenusZeroHull;

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> hull;
  hull->SetSpacing(source.between(0.08, 0.2)); // finer ones only take longer
  hull->SetOffset(source.between(0.9, 4.0));
  hull->SetPersistence(source.between(1.1, 3.0));
  hull->SetSmoothingPasses(source.below(20));
  hull->SetGenus(source.flag());
  hull->SetHandleWidth(source.between(0.0, 10.0));
  hull->SetDistributeOutput(source.flag());
  hull->SetInputDataObject(0, source.surface());
  hull->SetMethod(source.below(3));
  fuzz::run(hull, hull->GetGenus() == F::ZERO);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::GenusZeroHullOptions options;
  vtkNew<vtkGenusZeroHull> filter;
  using Limits = conformal::GenusZeroHullLimits;
  return { Same("Method", filter->GetMethod(), static_cast<int>(options.Method)),
    Same("DISTANCE", vtkGenusZeroHull::DISTANCE, static_cast<int>(conformal::HullMethod::Distance)),
    Same("WINDING_NUMBERS", vtkGenusZeroHull::WINDING_NUMBERS,
      static_cast<int>(conformal::HullMethod::WindingNumbers)),
    Same(
      "AUTOMATIC", vtkGenusZeroHull::AUTOMATIC, static_cast<int>(conformal::HullMethod::Automatic)),
    Same("Spacing", filter->GetSpacing(), options.Spacing),
    Same("Offset", filter->GetOffset(), options.Offset),
    Same("Persistence", filter->GetPersistence(), options.Persistence),
    Same("SmoothingPasses", filter->GetSmoothingPasses(), options.SmoothingPasses),
    Same("Genus", filter->GetGenus(), static_cast<int>(options.Genus)),
    Same("ZERO", vtkGenusZeroHull::ZERO, static_cast<int>(conformal::HullGenus::Zero)),
    Same("AS_FOUND", vtkGenusZeroHull::AS_FOUND, static_cast<int>(conformal::HullGenus::AsFound)),
    Same("HandleWidth", filter->GetHandleWidth(), options.HandleWidth),
    Same("HandleWidthMinValue", filter->GetHandleWidthMinValue(), Limits::MinimumHandleWidth),
    Same("HandleWidthMaxValue", filter->GetHandleWidthMaxValue(), Limits::MaximumHandleWidth),
    Same("SpacingMinValue", filter->GetSpacingMinValue(), Limits::MinimumSpacing),
    Same("SpacingMaxValue", filter->GetSpacingMaxValue(), Limits::MaximumSpacing),
    Same("OffsetMinValue", filter->GetOffsetMinValue(), Limits::MinimumOffset),
    Same("OffsetMaxValue", filter->GetOffsetMaxValue(), Limits::MaximumOffset),
    Same("PersistenceMinValue", filter->GetPersistenceMinValue(), Limits::MinimumPersistence),
    Same("PersistenceMaxValue", filter->GetPersistenceMaxValue(), Limits::MaximumPersistence),
    Same("SmoothingPassesMaxValue", filter->GetSmoothingPassesMaxValue(),
      Limits::MaximumSmoothingPasses) };
}
}

Case GenusZeroHull()
{
  Case all = CaseOf<F>("vtkGenusZeroHull");
  Mode hull = { "", { Surface(BadPoints) }, Set<F>([](F* f) { f->SetSpacing(0.08); }), true };
  hull.Properties = { Integer("Method", &F::SetMethod), Number("Spacing", &F::SetSpacing),
    Number("Offset", &F::SetOffset), Number("Persistence", &F::SetPersistence),
    Integer("SmoothingPasses", &F::SetSmoothingPasses), Integer("Genus", &F::SetGenus),
    Number("HandleWidth", &F::SetHandleWidth),
    Switch("DistributeOutput", &F::SetDistributeOutput) };
  // The smallest spacing is work without end, which Testing/Hostile stops.
  hull.Properties[1].IsNumber = false;
  const Mode wide = { "wide", { Variant(BadPoints) },
    Set<F>(
      [](F* f)
      {
        f->SetSpacing(0.05);
        f->SetOffset(3.0);
        f->SetPersistence(1.1);
        f->SetSmoothingPasses(0);
      }),
    true };
  const Mode handles = { "handles", { Variant(BadPoints) },
    Set<F>(
      [](F* f)
      {
        f->SetSpacing(0.08);
        f->SetGenusToAsFound();
      }) };
  const Mode winding = { "winding numbers", { Surface(BadPoints | BadIds) },
    Set<F>(
      [](F* f)
      {
        f->SetMethodToWindingNumbers();
        f->SetSpacing(0.08);
      }),
    true };
  all.Modes = { hull, wide, handles, winding };

  const auto wraps = [](F* f, double scale)
  {
    f->SetInputData(BumpyCloud(scale));
    f->SetSpacing(0.1);
  };
  all.Scaled = { Scaled<F>("Wraps", wraps),
    Scaled<F>("WrapsByWindingNumbers",
      [=](F* f, double scale)
      {
        wraps(f, scale);
        f->SetMethodToWindingNumbers();
      }) };

  const auto byWindingNumbers = [](F* f) { f->SetMethodToWindingNumbers(); };
  all.Progress = { Run<F>("head", []() { return Head(60); }),
    Run<F>("limbs", []() { return Limbs(60); }),
    Run<F>(
      "large head", []() { return Head(300); }, [](F* f) { f->SetSpacing(0.05); }),
    // Without triangles, so that normals must be found.
    Run<F>(
      "head, winding numbers", []() { return PointsOf(Head(60)); }, byWindingNumbers),
    Run<F>(
      "limbs, winding numbers and triangles", []() { return Limbs(60); }, byWindingNumbers) };
  all.Scans = { "igea-closed.ply", "stanford-bunny-closed.ply", "spot.ply", "armadillo.ply",
    "cortex.ply" };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
