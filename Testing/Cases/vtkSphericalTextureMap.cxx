#include "vtkSphericalTextureMap.h"

#include "FuzzFilter.h"
#include "Properties.h"
#include "Surfaces.h"
#include "Texture/SphericalTexture.h"
#include "vtkSphericalTextureBlend.h"
#include "vtkSphericalTextureImage.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace cases
{
namespace
{
using F = vtkSphericalTextureMap;
constexpr unsigned int Reads = BadPoints | BadIds | BadMap;

Mode ViewMode(const char* name, const Port& port, const std::function<void(F*)>& set)
{
  return { name, { port }, Set<F>(set) };
}

std::vector<Mode> Modes()
{
  Mode balanced = ViewMode("balanced", Good(),
    [](F* f)
    {
      f->SetAreaBalance(0.5);
      f->SetProjectionToOctahedral();
    });
  balanced.Properties = { Number("AreaBalance", &F::SetAreaBalance) };
  const std::vector<Property> view = { Vector3("ViewDirection", &F::SetViewDirection),
    Vector3("ViewUp", &F::SetViewUp), Number("FieldOfView", &F::SetFieldOfView),
    Number("Rotation", &F::SetRotation), Vector2<F, double>("Scale", &F::SetScale),
    Number("Margin", &F::SetMargin),
    Values<F, double>("ViewPoint", ExtremeValues(),
      [](F* f, double value)
      {
        f->UseViewPointOn();
        f->SetViewPoint(value, 1.0, 0.0);
      }) };
  Mode plain = ViewMode("Stereographic", Surface(Reads), [](F*) {});
  plain.ResultOfMap = "Texture Coordinates";
  plain.Properties = view;
  for (const Property& property :
    { Switch("UseViewPoint", &F::SetUseViewPoint), Integer("Projection", &F::SetProjection),
      Integer("Wrap", &F::SetWrap), Switch("SplitSeam", &F::SetSplitSeam) })
  {
    plain.Properties.push_back(property);
  }
  Mode viewed = ViewMode("view point", Surface(Reads), [](F* f) { f->UseViewPointOn(); });
  viewed.Properties = { Vector3("ViewPoint", &F::SetViewPoint) };
  Mode split = ViewMode("Octahedral, split", Surface(Reads),
    [](F* f)
    {
      f->SetProjectionToOctahedral();
      f->SplitSeamOn();
      f->SetWrapToMirror();
    });
  std::vector<Mode> modes = { plain, viewed, split,
    ViewMode("LongitudeLatitude, split", Surface(Reads),
      [](F* f)
      {
        f->SetProjectionToLongitudeLatitude();
        f->SplitSeamOn();
        f->SetWrapToRepeat();
      }),
    ViewMode("CubeMap, split", Surface(Reads),
      [](F* f)
      {
        f->SetProjectionToCubeMap();
        f->SplitSeamOn();
        f->SetMargin(0.01);
      }),
    ViewMode("Stereographic, split, mirrored", Surface(Reads),
      [](F* f)
      {
        f->SplitSeamOn();
        f->SetWrapToMirror();
        f->SetScale(0.3, 0.2);
      }),
    ViewMode("LongitudeLatitude", Good(), [](F* f) { f->SetProjectionToLongitudeLatitude(); }),
    ViewMode("Octahedral", Good(), [](F* f) { f->SetProjectionToOctahedral(); }),
    ViewMode("CubeMap", Good(), [](F* f) { f->SetProjectionToCubeMap(); }) };
  for (std::size_t i = 2; i < modes.size(); ++i) // every other projection, split and not
  {
    modes[i].Properties = view;
  }
  modes[5].ResultOfMap = "SphereUp";
  modes.push_back(balanced);
  return modes;
}

void SetVector(fuzz::FilterSource& source, const std::function<void(double, double, double)>& set)
{
  const double x = source.number(), y = source.number(), z = source.number();
  set(x, y, z);
}

// A map, and an image and a blend by it.
void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> map;
  map->SetProjection(source.below(4));
  map->SetWrap(source.below(3));
  map->SetSplitSeam(source.flag());
  map->SetUseViewPoint(source.flag());
  const int odd = source.byte();
  if (odd & 1)
  {
    SetVector(source, [&](double x, double y, double z) { map->SetViewDirection(x, y, z); });
    SetVector(source, [&](double x, double y, double z) { map->SetViewUp(x, y, z); });
    SetVector(source, [&](double x, double y, double z) { map->SetViewPoint(x, y, z); });
  }
  if (odd & 2)
  {
    map->SetFieldOfView(source.number());
    map->SetRotation(source.number());
    map->SetMargin(source.number());
    const double across = source.number();
    map->SetScale(across, source.number());
  }
  map->SetInputDataObject(0, source.surface());
  fuzz::run(map);

  vtkNew<vtkSphericalTextureImage> image;
  image->SetImageSize(1 + source.below(9), 1 + source.below(9));
  image->SetArrayName(odd & 4 ? "Colors" : "");
  image->SetInputDataObject(0, map->GetOutputDataObject(0));
  if (odd & 8)
  {
    image->SetInputDataObject(1, source.surface());
  }
  fuzz::run(image);

  vtkNew<vtkSphericalTextureBlend> blend;
  blend->SetImageSize(1 + source.below(9), 1 + source.below(9));
  if (odd & 16)
  {
    blend->SetFieldOfView(source.number());
    blend->SetBlendAngle(source.number());
    SetVector(source, [&](double x, double y, double z) { blend->SetBackViewDirection(x, y, z); });
    SetVector(source, [&](double x, double y, double z) { blend->SetBackViewUp(x, y, z); });
  }
  blend->SetInputDataObject(0, map->GetOutputDataObject(0));
  blend->SetInputDataObject(1, source.picture());
  blend->SetInputDataObject(2, source.picture());
  fuzz::run(blend);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::SphericalTextureOptions options;
  vtkNew<vtkSphericalTextureMap> filter;
  using Filter = vtkSphericalTextureMap;
  using conformal::SphereProjection;
  return { Same("ViewDirection", conformal::Vector3(filter->GetViewDirection()),
             options.ViewDirection),
    Same("ViewUp", conformal::Vector3(filter->GetViewUp()), options.ViewUp),
    Same("UseViewPoint", filter->GetUseViewPoint(), options.UseViewPoint),
    Same("ViewPoint", conformal::Vector3(filter->GetViewPoint()), options.ViewPoint),
    Same("Projection", filter->GetProjection(), static_cast<int>(options.Projection)),
    Same("FieldOfView", filter->GetFieldOfView(), options.FieldOfView),
    Same("Rotation", filter->GetRotation(), options.Rotation),
    Same("Scale", conformal::Vector2(filter->GetScale()), options.Scale),
    Same("Wrap", filter->GetWrap(), static_cast<int>(options.Wrap)),
    Same("SplitSeam", filter->GetSplitSeam(), options.SplitSeam),
    Same("Margin", filter->GetMargin(), options.Margin),
    Same("MarginMaxValue", filter->GetMarginMaxValue(), conformal::MaximumMargin),
    Same("STEREOGRAPHIC", Filter::STEREOGRAPHIC, static_cast<int>(SphereProjection::Stereographic)),
    Same("LONGITUDE_LATITUDE", Filter::LONGITUDE_LATITUDE,
      static_cast<int>(SphereProjection::LongitudeLatitude)),
    Same("OCTAHEDRAL", Filter::OCTAHEDRAL, static_cast<int>(SphereProjection::Octahedral)),
    Same("CUBE_MAP", Filter::CUBE_MAP, static_cast<int>(SphereProjection::CubeMap)),
    Same("DISK", Filter::DISK, static_cast<int>(SphereProjection::Disk)),
    Same("SQUARE", Filter::SQUARE, static_cast<int>(SphereProjection::Square)),
    Same("CLAMP", Filter::CLAMP, static_cast<int>(conformal::TextureWrap::Clamp)),
    Same("REPEAT", Filter::REPEAT, static_cast<int>(conformal::TextureWrap::Repeat)),
    Same("MIRROR", Filter::MIRROR, static_cast<int>(conformal::TextureWrap::Mirror)),
    Same("FieldOfViewMinValue", filter->GetFieldOfViewMinValue(), conformal::MinimumFieldOfView),
    Same("FieldOfViewMaxValue", filter->GetFieldOfViewMaxValue(), conformal::MaximumFieldOfView) };
}
}

Case SphericalTextureMap()
{
  Case all = CaseOf<F>("vtkSphericalTextureMap");
  all.Modes = Modes();
  // The map of Painted(), so that image and blend are tried on the same.
  const auto lays = [](F* f, double scale)
  {
    f->SetInputData(BumpyMesh(scale));
    f->SetViewDirection(0.3, 0.2, 1.0);
  };
  all.Scaled = { Scaled<F>("LaysAPicture", lays),
    Scaled<F>(
      "LaysAPictureWithoutASeam",
      [=](F* f, double scale)
      {
        lays(f, scale);
        f->SplitSeamOn();
      },
      {}, HUGE_VAL), // of two ways around a vertex rounding takes one
    Scaled<F>("LaysAPictureAtAPoint",
      [=](F* f, double scale)
      {
        lays(f, scale);
        f->UseViewPointOn();
        f->SetViewPoint(0.25 * scale, 0.5 * scale, -0.25 * scale);
      }) };
  const auto fine = []() { return Head(200); };
  all.Progress = { Run<F>("fine", fine),
    Run<F>("of a chosen point", fine,
      [](F* map)
      {
        map->UseViewPointOn();
        map->SetViewPoint(11.0, 0.0, 0.0);
      }) };
  for (int projection = F::STEREOGRAPHIC; projection <= F::SQUARE; ++projection)
  {
    all.Progress.push_back(Run<F>("SplitSeam " + std::to_string(projection), fine,
      [=](F* map)
      {
        map->SetProjection(projection);
        map->SplitSeamOn();
      }));
  }
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
