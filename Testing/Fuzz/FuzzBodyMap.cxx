#include "vtkBodyMap.h"
#include "vtkBodyMapImage.h"

#include "FuzzFilter.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  vtkNew<vtkBodyMap> body;
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
  return 0;
}
