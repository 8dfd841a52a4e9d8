#include "vtkSphericalTextureBlend.h"

#include "Properties.h"
#include "Surfaces.h"
#include "Texture/SphericalTexture.h"
#include "Texture/SphericalTextureBlend.h"
#include "vtkSphericalTextureMap.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace cases
{
namespace
{
using F = vtkSphericalTextureBlend;

void Blend(F* f, double scale)
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(4, 3, 1);
  picture->AllocateScalars(VTK_DOUBLE, 1);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    picture->GetPointData()->GetScalars()->SetTuple1(i, static_cast<double>(i * i));
  }
  f->SetInputConnection(Painted(scale)->GetOutputPort());
  f->SetInputData(1, picture);
  f->SetInputData(2, picture);
  f->SetImageSize(40, 20);
}

ProgressRun Blends(const char* name, int frequency, int width)
{
  return Run<F>(
    name, [=]() { return WithTexture(Head(frequency)); },
    [=](F* blend)
    {
      blend->SetInputDataObject(1, LargePicture());
      blend->SetInputDataObject(2, LargePicture());
      blend->SetImageSize(width, width / 2);
    });
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::TwoPictures options;
  vtkNew<vtkSphericalTextureBlend> filter;
  return { Same("BlendAngle", filter->GetBlendAngle(), options.BlendAngle),
    Same("FieldOfViewMaxValue", filter->GetFieldOfViewMaxValue(), conformal::MaximumFieldOfView) };
}
}

Case SphericalTextureBlend()
{
  Case all = CaseOf<F>("vtkSphericalTextureBlend");
  Mode blend = { "", { Surface(BadPoints | BadIds | BadMap), Picture("front"), Picture("back") },
    Set<F>([](F* f) { f->SetImageSize(24, 24); }) };
  blend.Properties = { Vector3("BackViewDirection", &F::SetBackViewDirection),
    Vector3("BackViewUp", &F::SetBackViewUp), Number("FieldOfView", &F::SetFieldOfView),
    Number("BlendAngle", &F::SetBlendAngle), Vector2<F, int>("ImageSize", &F::SetImageSize) };
  all.Modes = { blend };
  all.Scaled = { Scaled<F>("Blends", Blend) };
  all.Progress = { Blends("large image", 100, 1024), Blends("fine mesh", 200, 128) };
  all.Mirrors = Mirrors;
  return all;
}
}
