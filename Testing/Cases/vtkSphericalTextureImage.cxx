#include "vtkSphericalTextureImage.h"

#include "Properties.h"
#include "Surfaces.h"
#include "vtkSphericalTextureMap.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSphericalTextureImage;

void Bake(F* f, double scale)
{
  f->SetInputConnection(Painted(scale)->GetOutputPort());
  f->SetArrayName("SpherePosition");
  f->SetImageSize(40, 20);
}

ProgressRun Bakes(const char* name, int frequency, int width)
{
  return Run<F>(
    name, [=]() { return Colored(WithTexture(Head(frequency))); },
    [=](F* image)
    {
      image->SetImageSize(width, width / 2);
      image->SetArrayName("Heights");
    });
}

ProgressRun BakesFrom(const char* name, bool isCloud)
{
  return { name,
    [=]() -> Maker
    {
      const SurfacePointer surface = WithTexture(Head(100)), source = Colored(Head(150));
      if (isCloud)
      {
        source->SetPolys(nullptr);
      }
      return [=]() -> Algorithm
      {
        const auto image = vtkSmartPointer<F>::New();
        image->SetInputDataObject(0, surface);
        image->SetInputDataObject(1, source);
        image->SetImageSize(512, 256);
        image->SetArrayName("Heights");
        return image;
      };
    } };
}
}

Case SphericalTextureImage()
{
  // Without a source the image is made of the map alone.
  constexpr unsigned int reads = BadIds | BadMap;
  Case all = CaseOf<F>("vtkSphericalTextureImage");
  Mode own = { "", { Surface(reads) }, Set<F>([](F* f) { f->SetImageSize(24, 24); }) };
  own.Properties = { Name("ArrayName", &F::SetArrayName),
    Vector2<F, int>("ImageSize", &F::SetImageSize) };
  const Mode array = { "array", { Surface(reads) },
    Set<F>(
      [](F* f)
      {
        f->SetImageSize(16, 16);
        f->SetArrayName("Curvature");
      }) };
  Mode source = { "good source", { Variant(reads), Surface(BadPoints | BadIds, "source") },
    Set<F>([](F* f) { f->SetImageSize(24, 24); }) };
  source.MixesUnits = true;
  Mode average = { "average", { Variant(reads), Surface(BadPoints | BadIds, "source") },
    Set<F>(
      [](F* f)
      {
        f->SetImageSize(24, 24);
        f->SetSamplingToAverage();
      }) };
  average.MixesUnits = true;
  average.Properties = { Integer("Sampling", &F::SetSampling) };
  all.Modes = { own, array, source, average };

  all.Scaled = { Scaled<F>("Bakes", Bake) };
  for (const bool isCloud : { false, true })
  {
    all.Scaled.push_back(Scaled<F>(isCloud ? "BakesFromACloud" : "BakesFromAMesh",
      [=](F* f, double scale)
      {
        Bake(f, scale);
        const SurfacePointer from = BumpyMesh(scale, 7);
        if (isCloud)
        {
          from->SetPolys(nullptr);
        }
        f->SetInputData(1, from);
      }));
  }
  all.Progress = { Bakes("large image", 100, 1024), Bakes("fine mesh", 200, 256),
    BakesFrom("from a mesh", false), BakesFrom("from a cloud", true) };
  return all;
}
}
