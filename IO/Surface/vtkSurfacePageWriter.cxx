#include "vtkSurfacePageWriter.h"

#include "Base/CoordinateFrame.h"
#include "Bytes/SurfaceWalk.h"
#include "Glue/FileErrors.h"
#include "Glue/SurfaceConversions.h"
#include "Page/PagePicture.h"
#include "Page/SurfacePage.h"
#include "Page/ThreeJS.h"
#include "Texture/SphereViewChoice.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <filesystem>

vtkStandardNewMacro(vtkSurfacePageWriter);

namespace
{
using glue::WriteError;

// Return the picture as JPEG. The result is empty if there is no picture.
std::string ToJPEG(vtkImageData* picture, int maximumSize, int quality)
{
  if (!picture)
  {
    return {};
  }
  vtkUnsignedCharArray* pixels = glue::PixelsOf(picture);
  const int* size = picture->GetDimensions();
  const conformal::PagePicture shrunk =
    conformal::shrunkPicture(pixels->GetPointer(0), static_cast<std::size_t>(size[0]),
      static_cast<std::size_t>(size[1]), static_cast<std::size_t>(pixels->GetNumberOfComponents()),
      static_cast<std::size_t>(maximumSize));
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(shrunk.Width), static_cast<int>(shrunk.Height), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(shrunk.Pixels.begin(), shrunk.Pixels.end(),
    static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkJPEGWriter> writer;
  writer->SetInputData(image);
  writer->SetQuality(quality);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (!bytes || bytes->GetNumberOfValues() == 0)
  {
    throw WriteError(vtkErrorCode::UserError, "the texture cannot be written as JPEG");
  }
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) };
}

conformal::Points ToPageRows(const conformal::NamedArray& array)
{
  conformal::Points rows(static_cast<conformal::Index>(array.numberOfTuples()), 3);
  for (conformal::Index i = 0; i < rows.size(); ++i)
  {
    rows.data()[i] = conformal::valueOf(array, static_cast<std::size_t>(i));
  }
  return rows;
}

std::array<double, 9> ToRows(const conformal::SphereView& view)
{
  std::array<double, 9> rows;
  std::copy_n(view.Right.data(), 3, rows.begin());
  std::copy_n(view.Up.data(), 3, rows.begin() + 3);
  std::copy_n(view.Pole.data(), 3, rows.begin() + 6);
  return rows;
}

// Set the orientation of surface and sphere when the page is opened.
void SetAxes(conformal::SurfacePageOptions& page, const conformal::SurfaceData& surface,
  const conformal::Vector3& direction, const conformal::Vector3& up)
{
  conformal::Points sphere = ToPageRows(conformal::requirePageSurface(surface));
  conformal::normalizeRows(sphere);
  conformal::Points points = ToPageRows(surface.Points);
  points /= conformal::frameOf({ points }).Unit;
  conformal::Triangles triangles(
    static_cast<conformal::Index>(conformal::numberOfPolygons(surface)), 3);
  std::transform(surface.PolygonIds.data(), surface.PolygonIds.data() + surface.PolygonIds.size(),
    triangles.data(), [](std::int64_t id) { return static_cast<int>(id); });
  conformal::SphereViewOptions options;
  options.ViewDirection = direction;
  options.ViewUp = up;
  page.SphereAxes =
    ToRows(conformal::chooseSphereView(points, triangles, sphere, options)); // checks directions
  conformal::SphereView view;
  view.Pole = conformal::unitVector(direction);
  view.Right = conformal::unitVector(conformal::unitVector(up).cross(view.Pole));
  view.Up = view.Pole.cross(view.Right);
  page.SurfaceAxes = ToRows(view);
}
}

//------------------------------------------------------------------------------
vtkSurfacePageWriter::vtkSurfacePageWriter()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSurfacePageWriter::SetTextureConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkSurfacePageWriter::SetTextureData(vtkImageData* picture)
{
  this->SetInputData(1, picture);
}

//------------------------------------------------------------------------------
int vtkSurfacePageWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfacePageWriter::WriteFiles(const conformal::Run& run)
{
  const std::string name = this->FileName; // a copy: observers may change it
  const conformal::SurfaceData surface =
    glue::ToSurfaceData(glue::OnlyTriangles(vtkPolyData::SafeDownCast(this->GetInput(0))));
  conformal::SurfacePageOptions options;
  options.Title = std::filesystem::u8path(name).stem().u8string();
  options.ColorArrayName = this->ColorArrayName;
  options.RepeatsTexture = this->RepeatTexture;
  SetAxes(
    options, surface, conformal::Vector3(this->ViewDirection), conformal::Vector3(this->ViewUp));
  vtkImageData* picture = this->GetNumberOfInputConnections(1) > 0
    ? vtkImageData::SafeDownCast(this->GetInputDataObject(1, 0))
    : nullptr;
  const std::string jpeg = ToJPEG(picture, this->MaximumTextureSize, this->TextureQuality);
  const std::string page = conformal::makeSurfacePage(
    surface, jpeg, conformal::readThreeJS(this->ThreeJSFileName), options, run);
  this->WriteTogether({ { name, page } });
}

//------------------------------------------------------------------------------
void vtkSurfacePageWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double* v)
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  os << indent << "ColorArrayName: " << this->ColorArrayName << "\n";
  vector("ViewDirection", this->ViewDirection);
  vector("ViewUp", this->ViewUp);
  os << indent << "RepeatTexture: " << (this->RepeatTexture ? "On" : "Off") << "\n";
  os << indent << "MaximumTextureSize: " << this->MaximumTextureSize << "\n";
  os << indent << "TextureQuality: " << this->TextureQuality << "\n";
  os << indent << "ThreeJSFileName: " << this->ThreeJSFileName << "\n";
}
