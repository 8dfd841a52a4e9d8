#include "vtkSphericalTextureImage.h"

#include "Base/AcrossProcesses.h"
#include "Base/Steps.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Texture/AveragedTexture.h"
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
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkSphericalTextureImage);
vtkCxxSetObjectMacro(vtkSphericalTextureImage, Controller, vtkMultiProcessController);

namespace
{
// Return this process's piece of the array to bake. A piece without points may lack the array; an
// empty array of the same type is then returned.
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

vtkSmartPointer<vtkDataArray> ValuesOf(
  vtkPointSet* source, const std::string& name, glue::Processes& processes)
{
  return processes.size() > 1 ? OwnPart(source, name, processes)
                              : vtkSmartPointer<vtkDataArray>(glue::ArrayToBake(source, name));
}

// Bit pattern of a component, so that also integers of 64 bits are kept exactly.
std::int64_t BitsOf(vtkDataArray* array, vtkIdType tuple, int component)
{
  std::int64_t bits = 0;
  if (array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT)
  {
    const vtkIdType value = tuple * array->GetNumberOfComponents() + component;
    std::memcpy(&bits, array->GetVoidPointer(value), array->GetDataTypeSize());
  }
  else
  {
    const double value = array->GetComponent(tuple, component);
    std::memcpy(&bits, &value, sizeof(value));
  }
  return bits;
}

void SetBits(vtkDataArray* array, vtkIdType tuple, int component, std::int64_t bits)
{
  if (array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT)
  {
    const vtkIdType value = tuple * array->GetNumberOfComponents() + component;
    std::memcpy(array->GetVoidPointer(value), &bits, array->GetDataTypeSize());
  }
  else
  {
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    array->SetComponent(tuple, component, value);
  }
}

// Combine the pixels of all processes on each process. A pixel was painted only by the process that
// has the closest point.
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
        // The bit pattern of a pixel is added to zeros of the other processes.
        *sum = holes->GetValue(i) ? 0 : BitsOf(pixels, i, c);
      }
    }
    reduce.sum(sums.data(), static_cast<conformal::Index>(sums.size()));
    sum = sums.data();
    for (vtkIdType i = first; i < first + size; ++i)
    {
      holes->SetValue(i, *sum++ == 0);
      for (int c = 0; c < components; ++c, ++sum)
      {
        SetBits(pixels, i, c, *sum);
      }
    }
  }
}

// Require the same size of the image on all processes, since pixels are summed over them.
void RequireEqualSizes(vtkImageData* image, const conformal::Reduce& reduce)
{
  const int* size = image->GetDimensions();
  const std::vector<double> own(size, size + 2), all = conformal::gather(reduce, own);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i] != own[i % 2])
    {
      throw std::invalid_argument("ImageSize differs between processes; set the same on all");
    }
  }
}

// Surface, and placement of the image on its sphere. Both are empty on processes without the
// surface.
struct ImageOfSurface
{
  conformal::MappedMesh Mesh;
  conformal::SphereImage Image;
};

ImageOfSurface ReadImage(vtkPolyData* surface, const conformal::CoordinateFrame& frame)
{
  ImageOfSurface read;
  read.Mesh = { { glue::ToPoints(surface->GetPoints(), frame), glue::ToTriangles(surface) },
    glue::ToTexturePositions(surface) };
  read.Image = glue::ToSphereImage(surface->GetFieldData());
  return read;
}

// Source of averages: the points, triangles and values of all processes.
struct AveragedSource
{
  conformal::Points Positions;
  conformal::Triangles Triangles;
  std::vector<double> Values;
  int NumberOfComponents = 1;
};

AveragedSource GatherSource(vtkPointSet* source, vtkDataArray* values,
  const conformal::CoordinateFrame& frame, const conformal::Reduce& reduce)
{
  AveragedSource all;
  const conformal::Points own = glue::ToPoints(source->GetPoints(), frame);
  auto* surface = vtkPolyData::SafeDownCast(source);
  all.Triangles = conformal::gatherTriangles(
    reduce, surface ? glue::ToTriangles(surface) : conformal::Triangles(0, 3), own.rows());
  all.Positions = conformal::gatherRows(reduce, own);
  all.NumberOfComponents = values->GetNumberOfComponents();
  all.Values.resize(values->GetNumberOfValues());
  for (std::size_t i = 0; i < all.Values.size(); ++i)
  {
    all.Values[i] = values->GetComponent(static_cast<vtkIdType>(i) / all.NumberOfComponents,
      static_cast<int>(i % all.NumberOfComponents));
  }
  if (reduce.NumberOfRanks > 1)
  {
    all.Values = conformal::gather(reduce, all.Values);
  }
  return all;
}

// Paint the means of the source's values. Processes without the surface paint nothing.
void PaintAverages(const ImageOfSurface& read, const AveragedSource& source, vtkDataArray* pixels,
  vtkUnsignedCharArray* holes, const conformal::PixelGrid& grid, const conformal::Run& run)
{
  if (read.Mesh.Triangles.rows() == 0)
  {
    holes->FillValue(1);
    return;
  }
  const bool isWhole = glue::HoldsWholeNumbers(pixels);
  const conformal::MixtureSink sink =
    [&](conformal::Index first, const std::vector<conformal::PointMixture>& mixtures)
  {
    for (std::size_t i = 0; i < mixtures.size(); ++i)
    {
      const vtkIdType pixel = first + static_cast<vtkIdType>(i);
      holes->SetValue(pixel, mixtures[i].empty());
      for (int c = 0; c < source.NumberOfComponents; ++c)
      {
        double sum = 0.0;
        for (const auto& [id, weight] : mixtures[i])
        {
          sum += weight * source.Values[std::size_t(id) * source.NumberOfComponents + c];
        }
        pixels->SetComponent(pixel, c, isWhole ? std::round(sum) : sum);
      }
    }
  };
  conformal::averageSphericalTexture(
    read.Mesh, source.Positions, source.Triangles, read.Image, grid, sink, run);
}

// Paint the values of the source. If there is no source, paint the values of the surface.
void Paint(const ImageOfSurface& read, vtkPointSet* source, const conformal::CoordinateFrame& frame,
  const conformal::PixelGrid& grid, const conformal::PixelSink& sink,
  const conformal::Reduce& reduce, const conformal::Run& run)
{
  if (!source)
  {
    conformal::paintSphericalTexture(read.Mesh, read.Image, grid, sink, run);
    return;
  }
  conformal::Points copy;
  auto* surface = vtkPolyData::SafeDownCast(source);
  conformal::paintSphericalTexture(read.Mesh, glue::ViewPoints(source->GetPoints(), frame, copy),
    surface ? glue::ToTriangles(surface) : conformal::Triangles(0, 3), read.Image, grid, sink,
    reduce, run);
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
void vtkSphericalTextureImage::FitImageSize(double pixelsPerPoint)
{
  const bool isShared = this->Controller && this->GetNumberOfInputConnections(1) > 0;
  for (int port = 0; port < 2; ++port)
  {
    if (this->GetNumberOfInputConnections(port) > 0)
    {
      this->GetInputAlgorithm(port, 0)->UpdatePiece(
        isShared ? this->Controller->GetLocalProcessId() : 0,
        isShared ? this->Controller->GetNumberOfProcesses() : 1, 0);
    }
  }
  auto* surface = vtkPolyData::SafeDownCast(this->GetInputDataObject(0, 0));
  auto* source = this->GetNumberOfInputConnections(1) > 0
    ? vtkPointSet::SafeDownCast(this->GetInputDataObject(1, 0))
    : surface;
  glue::RunCore(this, isShared ? this->Controller : nullptr,
    [&](glue::Processes& processes)
    {
      if (!surface || !source)
      {
        throw std::invalid_argument("there is no surface or no source");
      }
      const conformal::Reduce reduce = processes.reduce();
      const int owner = std::max(processes.firstWith(surface->GetNumberOfPoints() > 0), 0);
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface, source }, reduce);
      const conformal::Points points =
        conformal::gatherRows(reduce, glue::ToPoints(source->GetPoints(), frame));
      std::int64_t size[] = { 0, 0 }; // width and height, found by the owner of the surface
      if (processes.rank() == owner)
      {
        const ImageOfSurface read = ReadImage(surface, frame);
        size[1] =
          conformal::imageHeightFor(read.Mesh, points, read.Image, pixelsPerPoint, processes.run());
        size[0] = std::lround(std::clamp(
          static_cast<double>(size[1]) * conformal::widthPerHeight(read.Image), 1.0, 16384.0));
      }
      reduce.sum(size, 2);
      this->SetImageSize(static_cast<int>(size[0]), static_cast<int>(size[1]));
    });
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
  const bool averages = this->Sampling == AVERAGE;
  return glue::RunCore(this, source ? this->Controller : nullptr,
    [&](glue::Processes& processes)
    {
      const int owner = processes.firstWith(surface->GetNumberOfPoints() > 0);
      if (owner < 0)
      {
        glue::WarnOfEmptyInput(this, processes, "the surface is empty; the image is empty");
        return;
      }
      vtkPointSet* valued = source ? source.Get() : surface.Get();
      const auto values = ValuesOf(valued, arrayName, processes);
      const vtkNew<vtkImageData> result;
      vtkDataArray* pixels =
        glue::AllocatePixels(result, outputVector->GetInformationObject(0), values);
      RequireEqualSizes(result, processes.reduce());
      const auto holes = glue::MakeHoles(result);
      const conformal::CoordinateFrame frame =
        glue::FrameOf({ surface, source }, processes.reduce());
      // Relative costs of reading and pixels.
      conformal::Steps steps(processes.run(), { 0.05, 0.95 });
      steps.next();
      const ImageOfSurface read =
        processes.rank() == owner ? ReadImage(surface, frame) : ImageOfSurface();
      const conformal::PixelGrid grid = { result->GetDimensions()[0], result->GetDimensions()[1] };
      averages ? PaintAverages(read, GatherSource(valued, values, frame, processes.reduce()),
                   pixels, holes, grid, steps.next())
               : Paint(read, source, frame, grid, glue::PixelPainter(values, pixels, holes),
                   processes.reduce(), steps.next());
      if (processes.size() > 1)
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
  static const char* const samplings[] = { "Closest", "Average" };
  os << indent << "Sampling: " << samplings[this->Sampling] << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "ImageSize: (" << this->ImageSize[0] << ", " << this->ImageSize[1] << ")\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
