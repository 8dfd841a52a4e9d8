#include "vtkTexturedSurfaceWriter.h"

#include "Glue/FileErrors.h"
#include "Glue/SurfaceConversions.h"
#include "Textured/TexturedSurface.h"
#include "Textured/VertexPacking.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkTexturedSurfaceWriter);

namespace
{
using glue::OnlyTriangles;
using glue::PixelsOf;
using glue::WriteError;

void Require(bool condition, const char* message)
{
  if (!condition)
  {
    throw WriteError(vtkErrorCode::UserError, message);
  }
}

std::vector<float> ToUnitVectors(vtkDataArray* array)
{
  std::vector<float> vectors;
  vectors.reserve(3 * array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double n[3];
    array->GetTuple(i, n);
    const double length = std::hypot(n[0], n[1], n[2]);
    const bool hasDirection = std::isfinite(length) && length > 0.0;
    for (int c = 0; c < 3; ++c) // formats have no zero normals
    {
      vectors.push_back(static_cast<float>(hasDirection ? n[c] / length : (c == 2 ? 1.0 : 0.0)));
    }
  }
  return vectors;
}

std::vector<float> ToTexCoords(vtkDataArray* array)
{
  std::vector<float> coordinates;
  coordinates.reserve(2 * array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 2; ++c)
    {
      const auto value = static_cast<float>(array->GetComponent(i, c));
      Require(std::isfinite(value), "a texture coordinate is not finite");
      coordinates.push_back(value);
    }
  }
  return coordinates;
}

conformal::TexturedSurface ToTexturedSurface(vtkPolyData* input)
{
  const vtkSmartPointer<vtkPolyData> surface = OnlyTriangles(input);
  const vtkIdType count = surface->GetNumberOfPoints();
  Require(count > 0 && surface->GetNumberOfPolys() > 0, "the surface has no polygons");
  Require(static_cast<vtkTypeUInt64>(count) < std::numeric_limits<vtkTypeUInt32>::max(),
    "the surface has too many points for 32-bit ids");
  vtkDataArray* texCoords = surface->GetPointData()->GetTCoords();
  Require(
    texCoords && texCoords->GetNumberOfComponents() >= 2, "the surface has no texture coordinates");

  conformal::TexturedSurface result;
  result.TexCoords = ToTexCoords(texCoords);
  if (vtkDataArray* normals = surface->GetPointData()->GetNormals())
  {
    result.Normals = ToUnitVectors(normals);
  }
  result.Positions.resize(3 * count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    surface->GetPoint(i, &result.Positions[3 * i]);
  }
  const bool areFloats = std::all_of(result.Positions.begin(), result.Positions.end(),
    [](double p) { return std::abs(p) <= std::numeric_limits<float>::max(); });
  Require(areFloats, "a coordinate is not finite as a 32-bit float");
  result.Corners.reserve(3 * surface->GetNumberOfPolys());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    for (const vtkIdType id : *ids)
    {
      result.Corners.push_back(static_cast<std::uint32_t>(id));
    }
  }
  return result;
}

template <typename Writer>
std::string ToPicture(Writer* writer, vtkImageData* texture)
{
  writer->SetInputData(texture);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  Require(bytes && bytes->GetNumberOfValues() > 0, "the texture cannot be written");
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) };
}

std::string ToPNG(vtkImageData* texture)
{
  PixelsOf(texture);
  const vtkNew<vtkPNGWriter> writer;
  return ToPicture(writer.Get(), texture);
}

std::string ToJPEG(vtkImageData* texture)
{
  constexpr int quality = 85;
  if (PixelsOf(texture)->GetNumberOfComponents() == 4)
  {
    return ToPNG(texture);
  }
  const vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(quality);
  writer->ProgressiveOff();
  return ToPicture(writer.Get(), texture);
}

std::string LowerCaseExtension(const std::filesystem::path& path)
{
  std::string extension = path.extension().u8string();
  for (char& c : extension)
  {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return extension;
}
}

//------------------------------------------------------------------------------
vtkTexturedSurfaceWriter::vtkTexturedSurfaceWriter()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkTexturedSurfaceWriter::SetTextureConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkTexturedSurfaceWriter::SetTextureData(vtkImageData* picture)
{
  this->SetInputData(1, picture);
}

//------------------------------------------------------------------------------
bool vtkTexturedSurfaceWriter::GetHasMeshopt()
{
  return conformal::hasMeshopt();
}

//------------------------------------------------------------------------------
int vtkTexturedSurfaceWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkTexturedSurfaceWriter::WriteFiles(const conformal::Run& run)
{
  const std::string name = this->FileName; // a copy: observers may change it
  const std::filesystem::path path = std::filesystem::u8path(name);
  const std::string extension = LowerCaseExtension(path);
  if (extension != ".glb" && extension != ".obj" && extension != ".ply")
  {
    throw WriteError(
      vtkErrorCode::UnrecognizedFileTypeError, name + " does not end in .glb, .obj or .ply");
  }
  conformal::TexturedSurface surface =
    ToTexturedSurface(vtkPolyData::SafeDownCast(this->GetInput(0)));
  surface.RepeatsTexture = this->RepeatTexture;
  surface.Name = path.stem().u8string();
  surface.MetersPerUnit = this->MetersPerUnit;
  auto* picture = vtkImageData::SafeDownCast(this->GetInput(1));
  const bool isJPEG = extension == ".glb" && this->TextureFormat == JPEG;
  const std::string png = isJPEG ? ToJPEG(picture) : ToPNG(picture);
  if (extension == ".glb")
  {
    Require(this->Compression != MESHOPT || GetHasMeshopt(),
      "Compression MESHOPT is not available, because this build has not found the library "
      "meshoptimizer; use QUANTIZED");
    Require(std::isfinite(this->MetersPerUnit) && this->MetersPerUnit > 0.0,
      "MetersPerUnit is not a finite number above 0");
    const std::string glb = conformal::makeGLB(
      surface, png, run, static_cast<conformal::GLBCompression>(this->Compression));
    this->WriteTogether({ { name, glb } });
    return;
  }
  const std::filesystem::path texture = std::filesystem::path(path).replace_extension(".png");
  const std::filesystem::path material = std::filesystem::path(path).replace_extension(".mtl");
  if (extension == ".ply")
  {
    const std::string ply = conformal::makePLY(surface, texture.filename().u8string(), run);
    this->WriteTogether({ { texture.u8string(), png }, { name, ply } });
    return;
  }
  const std::string obj = conformal::makeOBJ(surface, material.filename().u8string(), run);
  const std::string mtl = conformal::makeMTL(texture.filename().u8string());
  this->WriteTogether({ { texture.u8string(), png }, { material.u8string(), mtl }, { name, obj } });
}

//------------------------------------------------------------------------------
void vtkTexturedSurfaceWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RepeatTexture: " << (this->RepeatTexture ? "On" : "Off") << "\n";
  static const char* const compressions[] = { "None", "Quantized", "Meshopt" };
  os << indent << "MetersPerUnit: " << this->MetersPerUnit << "\n";
  os << indent << "Compression: " << compressions[this->Compression] << "\n";
  os << indent << "TextureFormat: " << (this->TextureFormat == JPEG ? "JPEG" : "PNG") << "\n";
}
