#include "vtkTorusTextureMap.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Surfaces.h"
#include "vtkGlobalConformalMap.h"

#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkTorusTextureMap;

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<vtkGlobalConformalMap> map;
  map->SetInputDataObject(0, source.surface());
  fuzz::run(map);
  vtkNew<F> texture;
  texture->SetRepeats(source.below(4), source.below(4));
  texture->SetInputDataObject(0, source.flag() ? map->GetOutput() : MappedRing(1.0, 1).Get());
  fuzz::run(texture);
}
}

Case TorusTextureMap()
{
  Case all = CaseOf<F>("vtkTorusTextureMap");
  // Its input must have a map to a torus, which the valid surfaces of other classes do not have.
  Mode texture = { "", { Good() }, Set<F>([](F* f) { f->SetInputData(MappedRing(1.0, 1)); }) };
  texture.Properties = { Vector2<F, int>("Repeats", &F::SetRepeats) };
  all.Modes = { texture };
  all.HasOwnInputs = true;
  all.Scaled = { Scaled<F>(
    "LaysAnImage", [](F* f, double scale) { f->SetInputData(MappedRing(scale)); }) };
  all.Progress = { Run<F>("ring", []() { return MappedRing(1.0, 90); }) };
  all.Fuzz = Fuzz;
  return all;
}
}
