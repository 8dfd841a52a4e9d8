#include "vtkTexturedSurfaceWriter.h"

#include "Glue/FileErrors.h"
#include "Glue/SurfaceConversions.h"
#include "Texture/SurfaceTangents.h"
#include "Textured/GLBFile.h"
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

// Compute the tangents of a surface from its normals and texture coordinates.
std::vector<float> TangentsOf(const conformal::TexturedSurface& surface)
{
  const auto count = static_cast<conformal::Index>(surface.Positions.size() / 3);
  conformal::Mesh mesh;
  mesh.Positions = Eigen::Map<const conformal::Points>(surface.Positions.data(), count, 3);
  mesh.Triangles =
    Eigen::Map<const Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>>(
      surface.Corners.data(), static_cast<conformal::Index>(surface.Corners.size() / 3), 3)
      .cast<int>();
  using Floats3 = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
  using Floats2 = Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor>;
  const conformal::Points normals =
    Eigen::Map<const Floats3>(surface.Normals.data(), count, 3).cast<double>();
  const conformal::TextureCoordinates coordinates =
    Eigen::Map<const Floats2>(surface.TexCoords.data(), count, 2).cast<double>();
  const conformal::Points tangents = conformal::surfaceTangents(mesh, normals, coordinates);
  return { tangents.data(), tangents.data() + tangents.size() };
}

// Add the tangents that a normal map requires.
void AddTangents(conformal::TexturedSurface& surface, vtkPolyData* input)
{
  Require(!surface.Normals.empty(), "a surface with a normal map needs active point normals");
  vtkDataArray* tangents = input->GetPointData()->GetTangents();
  surface.Tangents = tangents && tangents->GetNumberOfComponents() == 3 ? ToUnitVectors(tangents)
                                                                        : TangentsOf(surface);
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
  constexpr int quality = 85, largest = 65500;
  if (PixelsOf(texture)->GetNumberOfComponents() == 4)
  {
    return ToPNG(texture);
  }
  Require(std::max(texture->GetDimensions()[0], texture->GetDimensions()[1]) <= largest,
    "a JPEG picture has at most 65500 pixels in a row or column; set TextureFormat to PNG");
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
  this->SetNumberOfInputPorts(4);
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
void vtkTexturedSurfaceWriter::SetNormalMapConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(2, algOutput);
}

//------------------------------------------------------------------------------
void vtkTexturedSurfaceWriter::SetNormalMapData(vtkImageData* normalMap)
{
  this->SetInputData(2, normalMap);
}

//------------------------------------------------------------------------------
void vtkTexturedSurfaceWriter::AddLevelConnection(vtkAlgorithmOutput* algOutput)
{
  this->AddInputConnection(3, algOutput);
}

//------------------------------------------------------------------------------
void vtkTexturedSurfaceWriter::AddLevelData(vtkPolyData* level)
{
  this->AddInputDataInternal(3, level);
}

//------------------------------------------------------------------------------
bool vtkTexturedSurfaceWriter::GetHasMeshopt()
{
  return conformal::hasMeshopt();
}

//------------------------------------------------------------------------------
int vtkTexturedSurfaceWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  const bool isImage = port == 1 || port == 2;
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), isImage ? "vtkImageData" : "vtkPolyData");
  if (port >= 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  if (port == 3)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
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
  if (extension == ".glb")
  {
    this->WriteTogether({ { name, this->MakeGLB(surface, picture, run) } });
    return;
  }
  const std::string png = ToPNG(picture);
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
std::string vtkTexturedSurfaceWriter::MakeGLB(
  const conformal::TexturedSurface& surface, vtkImageData* picture, const conformal::Run& run)
{
  Require(this->Compression != MESHOPT || GetHasMeshopt(),
    "Compression MESHOPT is not available, because this build has not found the library "
    "meshoptimizer; use QUANTIZED");
  Require(std::isfinite(this->MetersPerUnit) && this->MetersPerUnit > 0.0,
    "MetersPerUnit is not a finite number above 0");
  const auto toFile = [this](vtkImageData* image)
  { return this->TextureFormat == JPEG ? ToJPEG(image) : ToPNG(image); };
  conformal::GLBContents contents;
  contents.Compression = static_cast<conformal::GLBCompression>(this->Compression);
  contents.Picture = toFile(picture);
  contents.Levels = { surface };
  for (int i = 0; i < this->GetNumberOfInputConnections(3); ++i)
  {
    contents.Levels.push_back(
      ToTexturedSurface(vtkPolyData::SafeDownCast(this->GetInputDataObject(3, i))));
  }
  if (auto* normalMap = vtkImageData::SafeDownCast(this->GetInput(2)))
  {
    Require(PixelsOf(normalMap)->GetNumberOfComponents() == 3,
      "the normal map does not have 3 components");
    contents.NormalMap = toFile(normalMap);
    AddTangents(contents.Levels[0], vtkPolyData::SafeDownCast(this->GetInput(0)));
    for (std::size_t i = 1; i < contents.Levels.size(); ++i)
    {
      AddTangents(contents.Levels[i],
        vtkPolyData::SafeDownCast(this->GetInputDataObject(3, static_cast<int>(i) - 1)));
    }
  }
  return conformal::makeGLB(contents, run);
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
