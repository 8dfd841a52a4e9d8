#include "vtkGlobalConformalMap.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "SphereMap/GlobalConformalMap.h"
#include "Surfaces.h"

#include "vtkCubeSource.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkGlobalConformalMap;

// A box of six polygons, so that they have to be cut up; bent, so that rounding does not decide
// where.
SurfacePointer Cube(double scale)
{
  vtkNew<vtkCubeSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetBounds(-0.5, 0.75, -0.25, 0.25, 0.0, 0.375);
  source->Update();
  const auto cube = SurfacePointer::New();
  cube->SetPoints(source->GetOutput()->GetPoints());
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    double p[3];
    cube->GetPoint(i, p);
    cube->GetPoints()->SetPoint(i, p[0] + p[1] * p[2], p[1] + 0.25 * p[0] * p[0], p[2]);
  }
  cube->SetPolys(source->GetOutput()->GetPolys());
  Scale(cube, scale);
  return cube;
}

std::function<void(F*)> Published(int iterations)
{
  return [=](F* f)
  {
    f->SetMethodToGuYau();
    f->SetMaximumNumberOfIterations(iterations);
  };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> map;
  map->SetMethod(source.below(2));
  map->SetAreaBalance(source.flag() ? source.number() : 0.0);
  map->SetMaximumNumberOfIterations(source.below(50));
  map->SetTolerance(source.flag() ? source.number() : 1e-7);
  map->SetInputDataObject(0, source.surface());
  fuzz::run(map, true);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::GlobalConformalMapOptions options;
  vtkNew<vtkGlobalConformalMap> filter;
  using conformal::GlobalConformalMethod;
  return { Same("Method", filter->GetMethod(), static_cast<int>(options.Method)),
    Same("AreaBalance", filter->GetAreaBalance(), options.AreaBalance),
    Same("MaximumNumberOfIterations", filter->GetMaximumNumberOfIterations(),
      options.MaximumNumberOfIterations),
    Same("Tolerance", filter->GetTolerance(), options.Tolerance),
    Same("ROBUST", vtkGlobalConformalMap::ROBUST, static_cast<int>(GlobalConformalMethod::Robust)),
    Same("GUYAU", vtkGlobalConformalMap::GUYAU, static_cast<int>(GlobalConformalMethod::GuYau)) };
}
}

Case GlobalConformalMap()
{
  constexpr unsigned int reads = BadPoints | BadIds;
  Case all = CaseOf<F>("vtkGlobalConformalMap");
  Mode robust = { "Robust", { Surface(reads) }, {}, true };
  robust.Properties = { Integer("Method", &F::SetMethod), Number("AreaBalance", &F::SetAreaBalance),
    Number("Tolerance", &F::SetTolerance) };
  Mode guYau = { "GuYau", { Surface(reads) }, Set<F>(Published(200)), true };
  guYau.Properties = { Integer("MaximumNumberOfIterations", &F::SetMaximumNumberOfIterations),
    Number("Tolerance", &F::SetTolerance), Number("AreaBalance", &F::SetAreaBalance) };
  const Mode equal = { "equal areas", { Variant(reads) },
    Set<F>([](F* f) { f->SetAreaBalance(1.0); }), true };
  all.Modes = { robust, guYau, equal };

  const auto maps = [](F* f, double scale) { f->SetInputData(BumpyMesh(scale)); };
  all.Scaled = { Scaled<F>("Robust", maps),
    Scaled<F>("GuYau",
      [=](F* f, double scale)
      {
        maps(f, scale);
        f->SetMethodToGuYau();
      }),
    Scaled<F>("Ring", [](F* f, double scale) { f->SetInputData(Ring(scale)); }),
    // The tolerance is that of where its iterations end.
    Scaled<F>(
      "PolygonsThatDoNotShareCorners", [](F* f, double scale) { f->SetInputData(Cube(scale)); }, {},
      1e-3) };

  const auto head = []() { return Head(30); };
  const auto balanced = [](F* f) { f->SetAreaBalance(0.3); };
  all.Progress = { Run<F>("head", []() { return Head(90); }),
    Run<F>("limbs", []() { return Limbs(60); }), Run<F>("head, AreaBalance", head, balanced),
    Run<F>(
      "limbs, AreaBalance", []() { return Limbs(30); }, balanced),
    Run<F>("head, GuYau", head, Published(5000)),
    Run<F>(
      "limbs, GuYau", []() { return Limbs(25); }, Published(5000)),
    Run<F>("head, GuYau cut short", head, Published(500)),
    Run<F>("ring", []() { return Ring(1.0, 35); }) };
  all.Scans = { "igea-closed.ply", "stanford-bunny-closed.ply" };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
