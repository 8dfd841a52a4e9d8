#include "vtkSurfaceHarmonics.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Surfaces.h"
#include "vtkSurfaceHarmonicsSource.h"

#include "vtkPolyData.h"
#include "vtkTable.h"

namespace cases
{
namespace
{
using F = vtkSurfaceHarmonics;
constexpr unsigned int Reads = BadPoints | BadIds | BadMap;

std::function<void(F*)> Fits(int degree, int meshType, int alignment)
{
  return [=](F* harmonics)
  {
    harmonics->SetDegree(degree);
    harmonics->SetMeshType(meshType);
    harmonics->SetAlignment(alignment);
  };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> harmonics;
  harmonics->SetDegree(source.below(9));
  harmonics->SetReconstructionDegree(source.below(9));
  harmonics->SetMeshType(source.below(2));
  harmonics->SetFrequency(1 + source.below(5));
  harmonics->SetAlignment(source.below(3));
  if (source.flag())
  {
    harmonics->AddPointArray(source.flag() ? "Priority" : "Normals");
  }
  harmonics->SetInputDataObject(0, source.surface());
  fuzz::run(harmonics);

  // Its own table, or one of which a number is another.
  vtkNew<vtkTable> table;
  table->DeepCopy(harmonics->GetOutputDataObject(1));
  if (table->GetNumberOfRows() > 0 && source.flag())
  {
    table->SetValue(source.below(static_cast<int>(table->GetNumberOfRows())),
      source.below(static_cast<int>(table->GetNumberOfColumns())), source.number());
  }
  vtkNew<vtkSurfaceHarmonicsSource> surface;
  surface->SetFrequency(1 + source.below(5));
  surface->SetReconstructionDegree(source.below(9));
  surface->SetInputDataObject(0, table);
  fuzz::run(surface);

  vtkNew<F> alike;
  alike->SetDegree(source.below(5));
  alike->SetAlignment(source.below(3));
  alike->SetInputDataObject(0, source.surface());
  alike->SetInputDataObject(1, table);
  fuzz::run(alike);
}
}

Case SurfaceHarmonics()
{
  Case all = CaseOf<F>("vtkSurfaceHarmonics");
  // The output has the input's own polygons, as they are oriented.
  Mode own = { "Input", { Surface(Reads) }, Set<F>([](F* f) { f->SetDegree(4); }) };
  own.ResultOfMap = "SpherePosition";
  own.Properties = { Integer("Degree", &F::SetDegree), Integer("MeshType", &F::SetMeshType),
    Integer("Alignment", &F::SetAlignment) };
  Mode geodesic = { "Geodesic", { Surface(Reads) },
    Set<F>(
      [](F* f)
      {
        f->SetDegree(4);
        f->SetMeshTypeToGeodesic();
        f->SetFrequency(6);
        f->SetAlignmentToMapAndSurface();
        f->AddPointArray("Curvature");
      }),
    true };
  geodesic.Properties = { Integer("ReconstructionDegree", &F::SetReconstructionDegree),
    Integer("Frequency", &F::SetFrequency) };
  all.Modes = { own, geodesic };
  all.Scaled = { Scaled<F>("FitsHarmonics",
    [](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale, 9));
      f->SetDegree(6);
      f->SetAlignmentToMapAndSurface();
    },
    { { "X", 1 }, { "Y", 1 }, { "Z", 1 }, { "RootMeanSquareDistance", 1 }, { "SurfaceCenter", 1 },
      { "HarmonicPower", 2 } }) };
  all.Progress = { Run<F>(
                     "low degree", []() { return Head(120); }, Fits(8, F::INPUT, F::NONE)),
    Run<F>(
      "geodesic sphere", []() { return Limbs(60); }, Fits(40, F::GEODESIC, F::MAP)),
    Run<F>(
      "coarse mesh", []() { return Head(30); }, Fits(50, F::INPUT, F::MAP_AND_SURFACE)) };
  all.Fuzz = Fuzz;
  return all;
}
}
