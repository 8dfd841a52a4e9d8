#include "vtkSphericalTextureImage.h"

#include "SphericalTextureImage.h"
#include "vtkConformalConversions.h"
#include "vtkMeshConversions.h"
#include "vtkSphereImageConversions.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkSphericalTextureImage);

namespace
{
vtkDataArray* ArrayOf(vtkPointSet* data, const std::string& name)
{
  vtkDataArray* array = name.empty() ? data->GetPointData()->GetScalars()
                                     : data->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw std::invalid_argument(
      name.empty() ? "no active scalars to bake" : "no point array " + name + " to bake");
  }
  return array;
}

// Writes what each pixel shows.
conformal::PixelSink Painter(
  vtkDataArray* values, vtkDataArray* pixels, vtkUnsignedCharArray* holes)
{
  const bool isWhole = vtkConformalConversions::HoldsWholeNumbers(values);
  return [=](conformal::Index first, const std::vector<conformal::SurfacePlace>& places)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const conformal::SurfacePlace& place = places[i];
      const vtkIdType pixel = first + static_cast<vtkIdType>(i);
      const bool isHole = place.Ids[0] < 0;
      holes->SetValue(pixel, isHole);
      for (int c = 0; c < values->GetNumberOfComponents(); ++c)
      {
        double sum = 0.0;
        for (int k = 0; k < 3 && !isHole; ++k)
        {
          sum += place.Weights[k] * values->GetComponent(place.Ids[k], c);
        }
        pixels->SetComponent(pixel, c, isWhole ? std::round(sum) : sum);
      }
    }
  };
}
}

//------------------------------------------------------------------------------
vtkSphericalTextureImage::vtkSphericalTextureImage()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSphericalTextureImage::SetSourceConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkSphericalTextureImage::SetSourceData(vtkPointSet* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
int vtkSphericalTextureImage::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkPointSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTextureImage::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return vtkConformalConversions::RunRequest(this,
    [&]()
    {
      vtkConformalConversions::SetImageInformation(
        outputVector->GetInformationObject(0), this->ImageSize);
    });
}

//------------------------------------------------------------------------------
int vtkSphericalTextureImage::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
  vtkPointSet* source = vtkPointSet::GetData(inputVector[1]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  return vtkConformalConversions::RunCore(this,
    [&]()
    {
      if (surface->GetNumberOfPoints() == 0)
      {
        vtkConformalConversions::WarnOfEmptyInput(
          this, "the surface is empty, there is nothing to bake");
        return;
      }
      using namespace vtkConformalConversions;
      vtkDataArray* values = ArrayOf(source ? source : surface, this->ArrayName);
      vtkDataArray* pixels = AllocatePixels(output, outputVector->GetInformationObject(0), values);
      vtkNew<vtkUnsignedCharArray> holes;
      holes->SetName("OutsideSurface");
      holes->SetNumberOfValues(output->GetNumberOfPoints());

      conformal::Points copy, sourceCopy;
      const conformal::SphereMappedSurface mapped = { ViewPoints(surface->GetPoints(), copy),
        ToTriangles(surface), ToSpherePositions(surface) };
      const conformal::SphereImage image = ToSphereImage(surface->GetFieldData());
      const conformal::PixelGrid grid = { this->ImageSize[0], this->ImageSize[1] };
      const conformal::PixelSink sink = Painter(values, pixels, holes);
      if (source)
      {
        auto* sourceSurface = vtkPolyData::SafeDownCast(source);
        conformal::paintSphericalTexture(mapped, ViewPoints(source->GetPoints(), sourceCopy),
          sourceSurface ? ToTriangles(sourceSurface) : conformal::Triangles(0, 3), image, grid,
          sink, SMPFor(), ProgressOf(this));
      }
      else
      {
        conformal::paintSphericalTexture(mapped, image, grid, sink, SMPFor(), ProgressOf(this));
      }
      output->GetPointData()->AddArray(holes);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalTextureImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "ImageSize: (" << this->ImageSize[0] << ", " << this->ImageSize[1] << ")\n";
}
