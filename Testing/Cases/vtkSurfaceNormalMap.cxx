#include "vtkSurfaceNormalMap.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Surfaces.h"
#include "vtkSphericalTextureMap.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSurfaceNormalMap;

SurfacePointer Textured(const SurfacePointer& surface)
{
  vtkNew<vtkDoubleArray> normals;
  normals->DeepCopy(surface->GetPointData()->GetArray("SpherePosition"));
  normals->SetName("Normals");
  surface->GetPointData()->SetNormals(normals);
  vtkNew<vtkSphericalTextureMap> map;
  map->SetInputData(surface);
  map->SetProjectionToOctahedral();
  map->SetMargin(0.02);
  map->SplitSeamOn();
  map->Update();
  return map->GetOutput();
}

void Bake(F* f, double scale)
{
  const SurfacePointer surface = Textured(BumpyMesh(1.0)); // cuts depend on rounding
  Scale(surface, scale);
  f->SetInputData(surface);
  f->SetDetailData(BumpyMesh(scale, 9));
  f->SetImageSize(32, 32);
}

ProgressRun Bakes(const char* name, int frequency, int width)
{
  return { name,
    [=]() -> Maker
    {
      const SurfacePointer surface = Textured(Head(frequency)), detail = Head(2 * frequency);
      return [=]() -> Algorithm
      {
        const auto map = vtkSmartPointer<F>::New();
        map->SetInputData(surface);
        map->SetDetailData(detail);
        map->SetImageSize(width, width);
        return map;
      };
    } };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> map;
  const int width = 1 + source.below(24);
  map->SetImageSize(width, 1 + source.below(24));
  const SurfacePointer surface = source.surface();
  map->SetInputData(source.flag() ? Textured(BumpyMesh(1.0, 2)) : surface);
  map->SetDetailData(source.flag() ? surface : source.surface());
  fuzz::run(map);
}
}

Case SurfaceNormalMap()
{
  Case all = CaseOf<F>("vtkSurfaceNormalMap");
  Mode map = { "", { Surface(BadPoints | BadIds | BadMap), Surface(BadPoints | BadIds, "detail") },
    Set<F>([](F* f) { f->SetImageSize(24, 24); }) };
  map.MixesUnits = true;
  map.Properties = { Vector2<F, int>("ImageSize", &F::SetImageSize) };
  all.Modes = { map };
  // Pixels are rounded: they may differ by 1 of 255.
  all.Scaled = { Scaled<F>("Bakes", Bake, {}, 0.005) };
  all.Progress = { Bakes("large image", 40, 1024), Bakes("fine mesh", 100, 512) };
  all.Fuzz = Fuzz;
  return all;
}
}
