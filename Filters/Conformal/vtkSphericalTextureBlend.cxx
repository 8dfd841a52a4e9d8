#include "vtkSphericalTextureBlend.h"

#include "Base/Steps.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Glue/Volumes.h"
#include "Texture/SphereViewChoice.h"
#include "Texture/SphericalTextureBlend.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkSphericalTextureBlend);

namespace
{
vtkDataArray* PixelsOf(vtkImageData* picture)
{
  vtkDataArray* pixels = picture->GetPointData()->GetScalars();
  if (!pixels || picture->GetNumberOfPoints() == 0 || picture->GetDimensions()[2] != 1)
  {
    throw std::invalid_argument("a picture must be an image of one slice with point scalars");
  }
  return pixels;
}

conformal::PixelGrid GridOf(vtkImageData* picture)
{
  return { picture->GetDimensions()[0], picture->GetDimensions()[1] };
}

// Return a share of a mix of pixels. Pixels without weight do not count, whatever their value: a
// picture can have the value NaN where it has no data.
double ShareOf(double share, vtkDataArray* pixels, const conformal::PixelMix& mix, int component)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < mix.Pixels.size(); ++k)
  {
    if (share > 0.0 && mix.Weights[k] > 0.0)
    {
      sum += mix.Weights[k] * pixels->GetComponent(mix.Pixels[k], component);
    }
  }
  return share * sum;
}

conformal::BlendSink Painter(vtkDataArray* front, vtkDataArray* back, vtkDataArray* pixels)
{
  const bool isWhole = glue::HoldsWholeNumbers(pixels);
  return [=](conformal::Index first, const std::vector<conformal::BlendedPixel>& blended)
  {
    for (std::size_t i = 0; i < blended.size(); ++i)
    {
      const double share = blended[i].FrontShare;
      for (int c = 0; c < pixels->GetNumberOfComponents(); ++c)
      {
        const double value = ShareOf(share, front, blended[i].Front, c) +
          ShareOf(1.0 - share, back, blended[i].Back, c);
        pixels->SetComponent(
          first + static_cast<vtkIdType>(i), c, isWhole ? std::round(value) : value);
      }
    }
  };
}

conformal::SphereViewOptions BackViewOf(vtkSphericalTextureBlend* self)
{
  conformal::SphereViewOptions view;
  view.ViewDirection = conformal::Vector3(self->GetBackViewDirection());
  view.ViewUp = conformal::Vector3(self->GetBackViewUp());
  view.FieldOfView = self->GetFieldOfView();
  return view;
}

void RequireSameComponents(vtkImageData* front, vtkImageData* back)
{
  if (PixelsOf(front)->GetNumberOfComponents() != PixelsOf(back)->GetNumberOfComponents())
  {
    throw std::invalid_argument("the pictures must have the same number of components");
  }
}
}

//------------------------------------------------------------------------------
vtkSphericalTextureBlend::vtkSphericalTextureBlend()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
void vtkSphericalTextureBlend::SetFrontConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkSphericalTextureBlend::SetFrontData(vtkImageData* front)
{
  this->SetInputData(1, front);
}

//------------------------------------------------------------------------------
void vtkSphericalTextureBlend::SetBackConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(2, algOutput);
}

//------------------------------------------------------------------------------
void vtkSphericalTextureBlend::SetBackData(vtkImageData* back)
{
  this->SetInputData(2, back);
}

//------------------------------------------------------------------------------
int vtkSphericalTextureBlend::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTextureBlend::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return glue::RunRequest(this,
    [&]() { glue::SetImageInformation(outputVector->GetInformationObject(0), this->ImageSize); });
}

//------------------------------------------------------------------------------
// Request the whole pictures for any part of the output.
int vtkSphericalTextureBlend::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 1; port <= 2; ++port)
  {
    glue::RequestWholeImage(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTextureBlend::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto front = glue::Held(vtkImageData::GetData(inputVector[1]));
  const auto back = glue::Held(vtkImageData::GetData(inputVector[2]));
  vtkImageData* output = vtkImageData::GetData(outputVector);
  const conformal::SphereViewOptions backView = BackViewOf(this);
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the image is empty"))
      {
        return;
      }
      using namespace glue;
      RequireSameComponents(front, back);
      const conformal::SphereImage image = ToSphereImage(surface->GetFieldData());
      conformal::TwoPictures pictures;
      pictures.Front.View = image.View;
      pictures.Front.FieldOfView = pictures.Back.FieldOfView = this->FieldOfView;
      pictures.BlendAngle = this->BlendAngle;
      const vtkNew<vtkImageData> result;
      vtkDataArray* pixels =
        AllocatePixels(result, outputVector->GetInformationObject(0), PixelsOf(front));
      // Relative costs of reading, view and pixels.
      conformal::Steps steps(RunOf(this), { 0.1, 0.25, 0.65 });
      steps.next();
      conformal::Points copy;
      const conformal::PointView points =
        ViewPoints(surface->GetPoints(), FrameOf({ surface }), copy);
      const conformal::Triangles triangles = ToTriangles(surface);
      pictures.Back.View = conformal::chooseSphereView(
        points, triangles, ToTexturePositions(surface), backView, steps.next());
      pictures.FrontGrid = GridOf(front);
      pictures.BackGrid = GridOf(back);
      conformal::blendPictures(pictures, image, GridOf(result),
        Painter(PixelsOf(front), PixelsOf(back), pixels), steps.next());
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalTextureBlend::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BackViewDirection: (" << this->BackViewDirection[0] << ", "
     << this->BackViewDirection[1] << ", " << this->BackViewDirection[2] << ")\n";
  os << indent << "BackViewUp: (" << this->BackViewUp[0] << ", " << this->BackViewUp[1] << ", "
     << this->BackViewUp[2] << ")\n";
  os << indent << "FieldOfView: " << this->FieldOfView << "\n";
  os << indent << "BlendAngle: " << this->BlendAngle << "\n";
  os << indent << "ImageSize: (" << this->ImageSize[0] << ", " << this->ImageSize[1] << ")\n";
}
