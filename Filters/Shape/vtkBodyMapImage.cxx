#include "vtkBodyMapImage.h"

#include "Base/Steps.h"
#include "Body/MapAreas.h"
#include "Body/MapImage.h"
#include "Body/Planetocentric.h"
#include "Glue/Arrays.h"
#include "Glue/MapImages.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkBodyMapImage);

namespace
{
void AddMarks(vtkImageData* image, const char* name, const std::vector<unsigned char>& marks)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(marks.size()));
  std::copy(marks.begin(), marks.end(), array->GetPointer(0));
  image->GetPointData()->AddArray(array);
}

void RequireFreeName(vtkDataArray* values)
{
  for (const char* ours :
    { "OutsideSurface", "OutsideMap", "Graticule", "BodyPosition", "AreaScale" })
  {
    if (values->GetName() && std::string(values->GetName()) == ours)
    {
      throw std::invalid_argument("the point array " + std::string(ours) +
        " has the name of an array that the image gets; rename it");
    }
  }
}

// What the image gets besides the values, if it is wanted: positions and areas of all pixels.
struct PixelExtras
{
  conformal::Points Positions;
  std::vector<double> Areas;
};

// Return a sink that passes surface points on to the painter, and stores the wanted extras.
conformal::PixelSink ExtrasPainter(conformal::PixelSink painter, const conformal::MappedMesh& body,
  const conformal::MapImage& map, PixelExtras& extras)
{
  return [painter = std::move(painter), &body, &map, &extras](
           conformal::Index first, const std::vector<conformal::SurfacePlace>& places)
  {
    painter(first, places);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const conformal::Index pixel = first + static_cast<conformal::Index>(i);
      if (extras.Positions.rows() > 0)
      {
        conformal::Vector3 position = conformal::Vector3::Zero();
        for (int k = 0; k < 3 && places[i].Ids[0] >= 0; ++k)
        {
          position += places[i].Weights[k] * body.Positions.row(places[i].Ids[k]).transpose();
        }
        extras.Positions.row(pixel) = position;
      }
      if (!extras.Areas.empty())
      {
        extras.Areas[pixel] = conformal::areaOfPixel(body, map, pixel, places[i]);
      }
    }
  };
}

void AddMapMarks(
  vtkImageData* image, const conformal::MapImage& map, double spacing, const conformal::Run& run)
{
  const conformal::MapMarks marks = conformal::markMap(map, spacing, run);
  AddMarks(image, "OutsideMap", marks.OutsideMap);
  if (spacing > 0.0)
  {
    AddMarks(image, "Graticule", marks.Graticule);
  }
}

// Return the numbers of a field array, or none without the array. They are `count` finite numbers.
std::vector<double> FieldNumbers(vtkPolyData* surface, const char* name, int count)
{
  std::vector<double> numbers;
  vtkDataArray* array = surface->GetFieldData()->GetArray(name);
  if (array && array->GetNumberOfValues() != count)
  {
    throw std::invalid_argument(
      std::string("the field array ") + name + " must have " + std::to_string(count) + " numbers");
  }
  for (int i = 0; array && i < count; ++i)
  {
    numbers.push_back(array->GetVariantValue(i).ToDouble());
    if (!std::isfinite(numbers.back()))
    {
      throw std::invalid_argument(std::string("the field array ") + name + " must be finite");
    }
  }
  return numbers;
}

conformal::PlanetocentricFrame PlanetocentricFrameOf(
  vtkPolyData* surface, const conformal::CoordinateFrame& frame)
{
  conformal::PlanetocentricFrame result;
  conformal::Vector3 center = conformal::Vector3::Zero();
  const std::vector<double> stored = FieldNumbers(surface, "BodyCenter", 3);
  std::copy(stored.begin(), stored.end(), center.data());
  result.Center = frame.toFrameFromAfar(center);
  const std::vector<double> axes = FieldNumbers(surface, "BodyAxes", 9);
  std::copy(axes.begin(), axes.end(), result.Axes.data());
  if (!(result.Axes.transpose() * result.Axes).isIdentity(1e-6))
  {
    throw std::invalid_argument(
      "the field array BodyAxes must have three perpendicular unit vectors");
  }
  return result;
}

// Paint in planetocentric coordinates, whose frame the surface has, or without a surface in those
// of the body's map to the sphere.
void PaintMap(const conformal::MappedMesh& body, const conformal::MapImage& map,
  const conformal::PixelSink& painter, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  if (surface)
  {
    conformal::paintPlanetocentricMap(
      body, PlanetocentricFrameOf(surface, frame), map, painter, run);
  }
  else
  {
    conformal::paintMap(body, map, painter, run);
  }
}

void RequireValid(const conformal::MapImage& map, double spacing, bool hasAreasOfRays)
{
  if (hasAreasOfRays)
  {
    throw std::invalid_argument("GenerateAreaScale needs Coordinates MAP");
  }
  if (!std::isfinite(map.CentralLongitude) || !std::isfinite(spacing))
  {
    throw std::invalid_argument("CentralLongitude and GraticuleSpacing must be finite");
  }
}

void AddExtras(vtkImageData* image, PixelExtras& extras, const conformal::CoordinateFrame& frame)
{
  if (extras.Positions.rows() > 0)
  {
    glue::LengthsFromFrame(extras.Positions.data(), extras.Positions.size(), frame, "BodyPosition");
    glue::AddVectors(image->GetPointData(), "BodyPosition", extras.Positions);
  }
  if (!extras.Areas.empty())
  {
    glue::AddAreaScales(image, std::move(extras.Areas));
  }
}
}

//------------------------------------------------------------------------------
int vtkBodyMapImage::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBodyMapImage::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return glue::RunRequest(this,
    [&]()
    {
      // If the aspect of a capsule is found from the surface, RequestData() sets the coordinates.
      const conformal::Vector2 half =
        conformal::MapImage{ static_cast<conformal::MapProjection>(this->Projection), 0.0,
          { this->ImageSize[0], this->ImageSize[1] }, std::max(this->CapsuleAspect, 1.0) }
          .halfSize();
      glue::SetImageInformation(outputVector->GetInformationObject(0), this->ImageSize, -half[0],
        -half[1], 2.0 * half[0], 2.0 * half[1]);
    });
}

//------------------------------------------------------------------------------
int vtkBodyMapImage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // the whole surface is requested for any part of the image
}

//------------------------------------------------------------------------------
int vtkBodyMapImage::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  vtkImageData* output = vtkImageData::GetData(outputVector);
  const std::string arrayName = this->ArrayName;
  conformal::MapImage map{ static_cast<conformal::MapProjection>(this->Projection),
    this->CentralLongitude, {}, this->CapsuleAspect };
  const double spacing = this->GraticuleSpacing >= 1.0 ? this->GraticuleSpacing : 0.0;
  const bool withPositions = this->GeneratePositions, withAreas = this->GenerateAreaScale;
  const bool isPlanetocentric = this->Coordinates == PLANETOCENTRIC;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the image is empty"))
      {
        return;
      }
      RequireValid(map, spacing, withAreas && isPlanetocentric);
      vtkDataArray* values = glue::ArrayToBake(surface, arrayName);
      RequireFreeName(values);
      const vtkNew<vtkImageData> result;
      vtkDataArray* pixels =
        glue::AllocatePixels(result, outputVector->GetInformationObject(0), values);
      map.Grid = { result->GetDimensions()[0], result->GetDimensions()[1] };
      const auto holes = glue::MakeHoles(result);
      conformal::Steps steps(glue::RunOf(this), { 0.02, 0.7, 0.28 }); // reading, map, graticule
      steps.next();
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface });
      const conformal::MappedMesh body = glue::CopyMapped(surface, frame);
      map.CapsuleAspect = conformal::capsuleAspectOf(body, map.Projection, map.CapsuleAspect);
      PixelExtras extras = { conformal::Points(withPositions ? map.Grid.size() : 0, 3),
        std::vector<double>(withAreas ? map.Grid.size() : 0) };
      const conformal::PixelSink painter =
        ExtrasPainter(glue::PixelPainter(values, pixels, holes), body, map, extras);
      PaintMap(body, map, painter, isPlanetocentric ? surface.Get() : nullptr, frame, steps.next());
      result->GetPointData()->AddArray(holes);
      AddMapMarks(result, map, spacing, steps.next());
      AddExtras(result, extras, frame);
      glue::AddCapsule(result, map);
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkBodyMapImage::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const projections[] = { "Equirectangular", "LambertAzimuthal", "Mollweide",
    "PeirceQuincuncial", "Mercator", "Capsule" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Projection: " << projections[this->Projection] << "\n";
  os << indent << "Coordinates: " << (this->Coordinates == MAP ? "Map" : "Planetocentric") << "\n";
  os << indent << "CentralLongitude: " << this->CentralLongitude << "\n";
  os << indent << "CapsuleAspect: " << this->CapsuleAspect << "\n";
  os << indent << "ImageSize: (" << this->ImageSize[0] << ", " << this->ImageSize[1] << ")\n";
  os << indent << "GraticuleSpacing: " << this->GraticuleSpacing << "\n";
  os << indent << "GeneratePositions: " << (this->GeneratePositions ? "On" : "Off") << "\n";
  os << indent << "GenerateAreaScale: " << (this->GenerateAreaScale ? "On" : "Off") << "\n";
}
