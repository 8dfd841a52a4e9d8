#include "vtkSurfaceLayers.h"

#include "FuzzFilter.h"
#include "Projections.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSurfaceLayers;

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> layers;
  FuzzProjection(layers.Get(), source);
  layers->SetAxis(source.below(3));
  layers->SetNumberOfLayers(1 + source.below(8));
  layers->SetComponent(source.below(2));
  const int width = 1 + source.below(24);
  layers->SetImageSize(width, 1 + source.below(24));
  const int odd = source.byte();
  if (odd & 1)
  {
    const double low = source.number();
    layers->SetDepthRange(low, source.number());
  }
  if (odd & 2)
  {
    const double low = source.number();
    layers->SetSummaryRange(low, source.number());
  }
  layers->SetInputDataObject(0, source.surface());
  layers->SetInputDataObject(1, source.volume());
  fuzz::run(layers);
}
}

Case SurfaceLayers()
{
  Case all = CaseOf<F>("vtkSurfaceLayers");
  Mode layers = { "", { Surface(BadPoints | BadIds | BadMap), Picture("vtkSurfaceLayers volume") },
    Set<F>(
      [](F* f)
      {
        f->SetImageSize(24, 12);
        f->SetNumberOfLayers(5);
        f->SetDepthRange(-0.1, 0.1);
      }),
    true };
  layers.Properties = { Name("ArrayName", &F::SetArrayName), Integer("Component", &F::SetComponent),
    Vector2<F, double>("DepthRange", &F::SetDepthRange),
    Integer("NumberOfLayers", &F::SetNumberOfLayers),
    Vector2<F, double>("SummaryRange", &F::SetSummaryRange), Integer("Axis", &F::SetAxis),
    Integer("Projection", &F::SetProjection), Number("CentralLongitude", &F::SetCentralLongitude),
    Number("CapsuleAspect", &F::SetCapsuleAspect), Vector2<F, int>("ImageSize", &F::SetImageSize) };
  all.Modes = { layers };
  ScaledRun samples = Scaled<F>(
    "SamplesLayers",
    [](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale));
      f->SetVolumeData(BallVolume(16, 0.8 * scale));
      f->SetImageSize(24, 12);
    },
    { { "InwardLimit", 1 }, { "OutwardLimit", 1 }, { "LayerDepths", 1 } }, 1e-5);
  // Between equal values, and between samples inside and outside of the volume, rounding chooses.
  samples.Ignored = { "DepthOfMaximum", "LayerMean" };
  all.Scaled = { samples };
  all.Progress = { Run<F>(
    "ball", []() { return BumpyMesh(1.0, 30); }, [](F* f) { f->SetVolumeData(BallVolume(30)); }) };
  all.Fuzz = Fuzz;
  all.Mirrors = ProjectionMirrors<F>;
  return all;
}
}
