#include "vtkSphericalTextureBlend.h"
#include "vtkSphericalTextureImage.h"
#include "vtkSphericalTextureMap.h"

#include "FuzzFilter.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkSphericalTextureMap> map;
  map->SetProjection(source.below(4));
  map->SetWrap(source.below(3));
  map->SetSplitSeam(source.flag());
  map->SetUseViewPoint(source.flag());
  const int odd = source.byte();
  const auto vector = [&](auto set)
  {
    const double x = source.number(), y = source.number(), z = source.number();
    set(x, y, z);
  };
  if (odd & 1)
  {
    vector([&](double x, double y, double z) { map->SetViewDirection(x, y, z); });
    vector([&](double x, double y, double z) { map->SetViewUp(x, y, z); });
    vector([&](double x, double y, double z) { map->SetViewPoint(x, y, z); });
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
    vector([&](double x, double y, double z) { blend->SetBackViewDirection(x, y, z); });
    vector([&](double x, double y, double z) { blend->SetBackViewUp(x, y, z); });
  }
  blend->SetInputDataObject(0, map->GetOutputDataObject(0));
  blend->SetInputDataObject(1, source.picture());
  blend->SetInputDataObject(2, source.picture());
  fuzz::run(blend);
  return 0;
}
