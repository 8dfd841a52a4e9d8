#include "vtkBodyMapImage.h"

#include "Body/MapImage.h"
#include "Projections.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkPolyData.h"

namespace cases
{
namespace
{
// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::MapImage image;
  vtkNew<vtkBodyMapImage> filter;
  std::vector<Mirror> mirrors = ProjectionMirrors<vtkBodyMapImage>();
  mirrors.push_back(
    Same("CentralLongitude", filter->GetCentralLongitude(), image.CentralLongitude));
  return mirrors;
}
}

Case BodyMapImage()
{
  using F = vtkBodyMapImage;
  Case all = CaseOf<F>("vtkBodyMapImage");
  Mode image = { "", { Surface(BadIds | BadMap) },
    Set<F>(
      [](F* f)
      {
        f->SetImageSize(24, 12);
        f->SetArrayName("SpherePosition");
        f->GeneratePositionsOn();
      }) };
  image.Properties = { Name("ArrayName", &F::SetArrayName),
    Integer("Projection", &F::SetProjection), Integer("Coordinates", &F::SetCoordinates),
    Number("CentralLongitude", &F::SetCentralLongitude),
    Number("CapsuleAspect", &F::SetCapsuleAspect), Vector2<F, int>("ImageSize", &F::SetImageSize),
    Number("GraticuleSpacing", &F::SetGraticuleSpacing),
    Switch("GeneratePositions", &F::SetGeneratePositions),
    Switch("GenerateAreaScale", &F::SetGenerateAreaScale) };
  all.Modes = { image };
  all.Progress = { Run<F>(
    "Peirce", []() { return Colored(Head(60)); },
    [](F* f) { f->SetProjectionToPeirceQuincuncial(); }) };
  all.Mirrors = Mirrors;
  return all;
}
}
