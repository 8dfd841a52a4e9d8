#include "vtkSurfaceNormalMap.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Mesh/VertexNormals.h"
#include "Texture/NormalMap.h"
#include "Texture/SurfaceTangents.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
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

vtkStandardNewMacro(vtkSurfaceNormalMap);

namespace
{
const char* const MapName = "NormalMap";

// Copy the active point normals as unit vectors. Return false without normals.
bool FindNormals(vtkPolyData* surface, conformal::Points& normals)
{
  if (!glue::ToVectors(surface->GetPointData()->GetNormals(), normals))
  {
    return false;
  }
  for (conformal::Index i = 0; i < normals.rows(); ++i)
  {
    const double length = normals.row(i).stableNorm();
    if (!std::isfinite(length))
    {
      throw std::invalid_argument("the normals of a surface are not finite");
    }
    normals.row(i) =
      length > 0.0 ? conformal::Vector3(normals.row(i) / length) : conformal::Vector3::UnitZ();
  }
  return true;
}

conformal::TextureCoordinates ToTextureCoordinates(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetPointData()->GetTCoords();
  if (!array || array->GetNumberOfComponents() < 2)
  {
    throw std::invalid_argument(
      "the surface has no texture coordinates; compute them by vtkSphericalTextureMap");
  }
  conformal::TextureCoordinates coordinates(array->GetNumberOfTuples(), 2);
  for (conformal::Index i = 0; i < coordinates.size(); ++i)
  {
    coordinates(i / 2, i % 2) = array->GetComponent(i / 2, static_cast<int>(i % 2));
  }
  if (!coordinates.allFinite())
  {
    throw std::invalid_argument("texture coordinates of the surface are not finite");
  }
  return coordinates;
}

// Convert the points of a surface to a frame. Throw if a coordinate is not finite.
conformal::Points FinitePoints(vtkPolyData* data, const conformal::CoordinateFrame& frame)
{
  conformal::Points points = glue::ToPoints(data->GetPoints(), frame);
  if (!points.allFinite())
  {
    throw std::invalid_argument("some points of the surface are not finite");
  }
  return points;
}

conformal::TangentSurface ToTangentSurface(
  vtkPolyData* data, const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  conformal::TangentSurface surface;
  surface.Positions = FinitePoints(data, frame);
  surface.Triangles = glue::ToTriangles(data);
  surface.SpherePositions = glue::ToTexturePositions(data);
  if (!FindNormals(data, surface.Normals))
  {
    throw std::invalid_argument(
      "the surface has no point normals; compute them before the seams are cut");
  }
  surface.Tangents =
    conformal::surfaceTangents(surface, surface.Normals, ToTextureCoordinates(data), run);
  return surface;
}

conformal::SurfaceWithNormals ToDetail(vtkPolyData* data, const conformal::CoordinateFrame& frame)
{
  conformal::SurfaceWithNormals detail;
  detail.Positions = FinitePoints(data, frame);
  detail.Triangles = glue::ToTriangles(data);
  if (!FindNormals(data, detail.Normals))
  {
    detail.Normals = conformal::vertexNormals(detail.Positions, detail.Triangles);
  }
  return detail;
}

void PaintNormals(const conformal::Points& normals, vtkDataArray* pixels)
{
  for (conformal::Index i = 0; i < normals.size(); ++i)
  {
    pixels->SetComponent(
      i / 3, static_cast<int>(i % 3), std::round(127.5 * (normals.data()[i] + 1.0)));
  }
}

void PassSurface(vtkPolyData* surface, const conformal::Points& tangents, vtkPolyData* output)
{
  const vtkNew<vtkFloatArray> array;
  array->SetName("Tangents");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(tangents.rows());
  for (conformal::Index i = 0; i < tangents.size(); ++i)
  {
    array->SetValue(i, static_cast<float>(tangents.data()[i]));
  }
  output->ShallowCopy(surface);
  output->GetPointData()->SetTangents(array);
}
}

//------------------------------------------------------------------------------
vtkSurfaceNormalMap::vtkSurfaceNormalMap()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSurfaceNormalMap::SetDetailConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkSurfaceNormalMap::SetDetailData(vtkPolyData* detail)
{
  this->SetInputData(1, detail);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSurfaceNormalMap::GetSurface()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkSurfaceNormalMap::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceNormalMap::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceNormalMap::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return glue::RunRequest(this,
    [&]() { glue::SetImageInformation(outputVector->GetInformationObject(0), this->ImageSize); });
}

//------------------------------------------------------------------------------
int vtkSurfaceNormalMap::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // the whole surfaces are requested for any part of the image
}

//------------------------------------------------------------------------------
int vtkSurfaceNormalMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto detail = glue::Held(vtkPolyData::GetData(inputVector[1]));
  vtkImageData* output = vtkImageData::GetData(outputVector, 0);
  vtkPolyData* outputSurface = vtkPolyData::GetData(outputVector, 1);
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the image is empty"))
      {
        return;
      }
      const conformal::SphereImage image = glue::ToSphereImage(surface->GetFieldData());
      const vtkNew<vtkUnsignedCharArray> like;
      like->SetName(MapName);
      like->SetNumberOfComponents(3);
      const vtkNew<vtkImageData> result;
      vtkDataArray* pixels =
        glue::AllocatePixels(result, outputVector->GetInformationObject(0), like);
      conformal::Steps steps(glue::RunOf(this), { 0.1, 0.9 }); // tangents, pixels
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface, detail });
      const conformal::TangentSurface drawn = ToTangentSurface(surface, frame, steps.next());
      const conformal::PixelGrid grid = { result->GetDimensions()[0], result->GetDimensions()[1] };
      PaintNormals(
        conformal::normalMap(drawn, image, grid, ToDetail(detail, frame), steps.next()), pixels);
      PassSurface(surface, drawn.Tangents, outputSurface);
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceNormalMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImageSize: (" << this->ImageSize[0] << ", " << this->ImageSize[1] << ")\n";
}
