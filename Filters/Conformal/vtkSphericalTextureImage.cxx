#include "vtkSphericalTextureImage.h"

#include "Base/Steps.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Texture/SphericalTextureImage.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkSphericalTextureImage);
vtkCxxSetObjectMacro(vtkSphericalTextureImage, Controller, vtkMultiProcessController);

namespace
{
// This process's part of an array that a part without points does not have.
vtkSmartPointer<vtkDataArray> OwnPart(
  vtkPointSet* source, const std::string& name, glue::Processes& processes)
{
  const bool hasPoints = source->GetNumberOfPoints() > 0;
  const int first = processes.firstWith(hasPoints);
  if (first < 0)
  {
    throw std::invalid_argument("the source has no points");
  }
  vtkSmartPointer<vtkDataArray> own;
  const auto shapeOf = [](vtkDataArray* array)
  {
    return std::to_string(array->GetDataType()) + " " +
      std::to_string(array->GetNumberOfComponents()) + " " +
      (array->GetName() ? array->GetName() : "");
  };
  std::string shape;
  if (hasPoints)
  {
    own = glue::ArrayToBake(source, name);
    shape = shapeOf(own);
  }
  const std::string expected = processes.textOf(first, shape);
  if (!hasPoints)
  {
    std::istringstream words(expected);
    int type = 0, components = 0;
    std::string itsName;
    words >> type >> components;
    words.get();
    std::getline(words, itsName);
    own.TakeReference(vtkDataArray::CreateDataArray(type));
    own->SetNumberOfComponents(components);
    own->SetName(itsName.c_str());
  }
  else if (shape != expected)
  {
    throw std::invalid_argument("the array to bake must have the same name, type and components "
                                "on all processes");
  }
  return own;
}

// Pixels that each process has painted where it is the closest, on all of them.
void SumPixels(vtkDataArray* pixels, vtkUnsignedCharArray* holes, const conformal::Reduce& reduce)
{
  constexpr vtkIdType chunkSize = 1 << 18;
  const int components = pixels->GetNumberOfComponents();
  std::vector<std::int64_t> sums;
  for (vtkIdType first = 0; first < pixels->GetNumberOfTuples(); first += chunkSize)
  {
    const vtkIdType size = std::min(chunkSize, pixels->GetNumberOfTuples() - first);
    sums.assign(size * (components + 1), 0);
    std::int64_t* sum = sums.data();
    for (vtkIdType i = first; i < first + size; ++i)
    {
      *sum++ = holes->GetValue(i) == 0;
      for (int c = 0; c < components; ++c, ++sum)
      {
        // Bit patterns, each added to zeros.
        const double value = holes->GetValue(i) ? 0.0 : pixels->GetComponent(i, c);
        std::memcpy(sum, &value, sizeof(value));
      }
    }
    reduce.sum(sums.data(), static_cast<conformal::Index>(sums.size()));
    sum = sums.data();
    for (vtkIdType i = first; i < first + size; ++i)
    {
      holes->SetValue(i, *sum++ == 0);
      for (int c = 0; c < components; ++c, ++sum)
      {
        double value = 0.0;
        std::memcpy(&value, sum, sizeof(value));
        pixels->SetComponent(i, c, value);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSphericalTextureImage::vtkSphericalTextureImage()
{
  this->SetNumberOfInputPorts(2);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkSphericalTextureImage::~vtkSphericalTextureImage()
{
  this->SetController(nullptr);
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
  return glue::RunRequest(this,
    [&]() { glue::SetImageInformation(outputVector->GetInformationObject(0), this->ImageSize); });
}

//------------------------------------------------------------------------------
int vtkSphericalTextureImage::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    glue::RequestOwnPieces(this, this->Controller, inputs);
  }
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkSphericalTextureImage::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto source = glue::Held(vtkPointSet::GetData(inputVector[1]));
  vtkImageData* output = vtkImageData::GetData(outputVector);
  const std::string arrayName = this->ArrayName;
  return glue::RunCore(this, source ? this->Controller : nullptr,
    [&](glue::Processes& processes)
    {
      using namespace glue;
      const int owner = processes.firstWith(surface->GetNumberOfPoints() > 0);
      if (owner < 0)
      {
        WarnOfEmptyInput(this, "the surface is empty; the image is empty");
        return;
      }
      const bool isShared = processes.size() > 1;
      const vtkSmartPointer<vtkDataArray> values = isShared
        ? OwnPart(source, arrayName, processes)
        : vtkSmartPointer<vtkDataArray>(
            source ? ArrayToBake(source, arrayName) : ArrayToBake(surface, arrayName));
      const vtkNew<vtkImageData> result;
      vtkDataArray* pixels = AllocatePixels(result, outputVector->GetInformationObject(0), values);
      vtkNew<vtkUnsignedCharArray> holes;
      holes->SetName("OutsideSurface");
      holes->SetNumberOfValues(result->GetNumberOfPoints());

      const conformal::CoordinateFrame frame = FrameOf({ surface, source }, processes.reduce());
      conformal::Points copy, sourceCopy;
      auto* sourceSurface = vtkPolyData::SafeDownCast(source.Get());
      const auto sourceSize = source ? static_cast<double>(source->GetNumberOfPoints()) : 0.0;
      conformal::Steps steps(processes.run(),
        { 100.0 * static_cast<double>(surface->GetNumberOfPoints()) +
            (sourceSurface ? 100.0 : 10.0) * sourceSize,
          900.0 * static_cast<double>(surface->GetNumberOfPoints()) +
            (sourceSurface ? 600.0 : 250.0) * sourceSize +
            (source ? 1000.0 : 350.0) * static_cast<double>(result->GetNumberOfPoints()) });
      steps.next();
      conformal::MappedMesh mapped;
      conformal::SphereImage image;
      if (processes.rank() == owner)
      {
        mapped = { { ToPoints(surface->GetPoints(), frame), ToTriangles(surface) },
          ToSpherePositions(surface) };
        image = ToSphereImage(surface->GetFieldData());
      }
      const conformal::PixelGrid grid = { result->GetDimensions()[0], result->GetDimensions()[1] };
      const conformal::PixelSink sink = PixelPainter(values, pixels, holes);
      if (source)
      {
        const conformal::PointView points = ViewPoints(source->GetPoints(), frame, sourceCopy);
        const conformal::Triangles triangles =
          sourceSurface ? ToTriangles(sourceSurface) : conformal::Triangles(0, 3);
        conformal::paintSphericalTexture(
          mapped, points, triangles, image, grid, sink, processes.reduce(), steps.next());
      }
      else
      {
        conformal::paintSphericalTexture(mapped, image, grid, sink, steps.next());
      }
      if (isShared)
      {
        SumPixels(pixels, holes, processes.reduce());
      }
      result->GetPointData()->AddArray(holes);
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalTextureImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "ImageSize: (" << this->ImageSize[0] << ", " << this->ImageSize[1] << ")\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
