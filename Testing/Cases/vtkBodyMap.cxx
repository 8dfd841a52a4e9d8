#include "vtkBodyMap.h"

#include "../Cxx/MeshFixtures.h"
#include "Body/BodyCoordinates.h"
#include "FuzzFilter.h"
#include "Properties.h"
#include "Surfaces.h"
#include "vtkBodyMapImage.h"

#include "vtkImageData.h"

namespace cases
{
namespace
{
using F = vtkBodyMap;

// A body map and an image of a map.
void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> body;
  body->SetReference(source.below(2));
  body->SetUseMarkerPoint(source.flag());
  const int odd = source.byte();
  const auto vector = [&](auto set)
  {
    const double x = source.number(), y = source.number(), z = source.number();
    set(x, y, z);
  };
  if (odd & 1)
  {
    vector([&](double x, double y, double z) { body->SetCenter(x, y, z); });
    vector([&](double x, double y, double z) { body->SetRotationAxis(x, y, z); });
    vector([&](double x, double y, double z) { body->SetMarkerPoint(x, y, z); });
    body->SetGraticuleSpacing(source.number());
  }
  body->SetInputDataObject(0, source.surface());
  if (odd & 2)
  {
    body->SetInputDataObject(1, source.surface());
  }
  fuzz::run(body);

  vtkNew<vtkBodyMapImage> image;
  image->SetImageSize(1 + source.below(9), 1 + source.below(9));
  image->SetProjection(source.below(4));
  image->SetGeneratePositions(source.flag());
  image->SetArrayName(odd & 4 ? "Colors" : "");
  if (odd & 8)
  {
    image->SetCentralLongitude(source.number());
    image->SetGraticuleSpacing(source.number());
  }
  if (odd & 16)
  {
    image->SetInputDataObject(0, body->GetOutputDataObject(0));
  }
  else
  {
    image->SetInputDataObject(0, source.surface());
  }
  fuzz::run(image);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::BodyCoordinatesOptions options;
  vtkNew<vtkBodyMap> filter;
  return { Same("Center", conformal::Vector3(filter->GetCenter()), options.Center),
    Same("RotationAxis", conformal::Vector3(filter->GetRotationAxis()), options.RotationAxis),
    Same("UseMarkerPoint", filter->GetUseMarkerPoint(), options.UseMarkerPoint),
    Same("MarkerPoint", conformal::Vector3(filter->GetMarkerPoint()), options.MarkerPoint) };
}
}

Case BodyMap()
{
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  Case all = CaseOf<F>("vtkBodyMap");
  Mode map = { "", { Surface(reads) } };
  map.Properties = { Vector3("Center", &F::SetCenter), Vector3("RotationAxis", &F::SetRotationAxis),
    Switch("UseMarkerPoint", &F::SetUseMarkerPoint), Vector3("MarkerPoint", &F::SetMarkerPoint),
    Integer("Reference", &F::SetReference), Number("GraticuleSpacing", &F::SetGraticuleSpacing) };
  const Mode withPlaces = { "with places", { Variant(reads), Places(BadIds, "places") } };
  all.Modes = { map, withPlaces };
  all.Scaled = { Scaled<F>("MapsABody",
    [](F* f, double scale)
    {
      f->SetInputData(BumpyMesh(scale));
      f->SetPlacesData(BumpyMesh(1.0)); // degrees
    },
    { { "Height", 1 }, { "BodyNorthPole", 1 }, { "BodySouthPole", 1 }, { "BodyMarker", 1 },
      { "ReferenceCenter", 1 }, { "ReferenceRadii", 1 }, { "Radius", 1 }, { "BodyCenter", 1 } }) };
  all.Progress = { Run<F>(
    "two lobes", []() { return SurfacePointer(fixtures::TwoLobes(150).Get()); }) };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
