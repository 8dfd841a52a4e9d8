#include "vtkGenusZeroRepair.h"

#include "../Cxx/MeshFixtures.h"
#include "FuzzFilter.h"
#include "Properties.h"
#include "Repair/GenusZeroRepair.h"
#include "Surfaces.h"

#include "vtkFieldData.h"

namespace cases
{
namespace
{
using F = vtkGenusZeroRepair;

// A sphere with a handle, and without two loops of equal length, between which rounding would
// choose.
SurfacePointer BumpyHandle(double scale)
{
  const auto surface = fixtures::SphereWithHandles(1, 20);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    const double size = 1.0 + 0.1 * std::sin(3.0 * p[0] + 1.0) * std::cos(2.0 * p[1] - p[2]);
    for (double& c : p)
    {
      c = std::round(0x1p20 * size * c) * 0x1p-20;
    }
    surface->GetPoints()->SetPoint(i, p);
  }
  Scale(surface, scale);
  return surface.Get();
}

// What is reported to be of genus zero must be so.
void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> repair;
  repair->SetMaximumHoleArea(source.flag() ? source.number() : 1.0);
  repair->SetInputDataObject(0, source.surface());
  fuzz::run(repair);
  vtkPolyData* repaired = repair->GetOutput();
  vtkDataArray* claim = repaired->GetFieldData()->GetArray("IsGenusZero");
  if (claim && claim->GetTuple1(0) == 1.0)
  {
    fuzz::require(
      { IsClosedSphere(repaired) ? Verdict::Fine : Verdict::Wrong, "IsGenusZero is wrong" },
      repair->GetClassName());
  }
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::GenusZeroRepairOptions options;
  vtkNew<vtkGenusZeroRepair> filter;
  using Type = conformal::RepairLoopType;
  return { Same("MaximumHoleArea", filter->GetMaximumHoleArea(), options.MaximumHoleArea),
    Same("FILLED_HOLE", vtkGenusZeroRepair::FILLED_HOLE, static_cast<int>(Type::FilledHole)),
    Same("OPEN_HOLE", vtkGenusZeroRepair::OPEN_HOLE, static_cast<int>(Type::OpenHole)),
    Same("CUT_HANDLE", vtkGenusZeroRepair::CUT_HANDLE, static_cast<int>(Type::CutHandle)),
    Same(
      "FILLED_TUNNEL", vtkGenusZeroRepair::FILLED_TUNNEL, static_cast<int>(Type::FilledTunnel)) };
}
}

Case GenusZeroRepair()
{
  Case all = CaseOf<F>("vtkGenusZeroRepair");
  Mode repair = { "", { Surface(BadPoints | BadIds) } };
  repair.Properties = { Number("MaximumHoleArea", &F::SetMaximumHoleArea) };
  all.Modes = { repair };
  all.Scaled = { Scaled<F>("Repairs",
    [](F* f, double scale) { f->SetInputData(BumpyHandle(scale)); }, { { "LoopLength", 1 } }) };
  all.Progress = { Run<F>("fine", []() { return Head(250); }),
    Run<F>("handles", []() { return SurfacePointer(fixtures::SphereWithHandles(20, 60).Get()); }) };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
