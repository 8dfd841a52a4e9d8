#include "Glue/SphereImages.h"

#include "Glue/Arrays.h"
#include "Glue/Points.h"
#include "Texture/SphericalTexture.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{
// Point arrays that are computed from "SpherePosition".
const char* const FromMap[] = { glue::TexturePositionName(), "DiskPosition", "Longitude",
  "Latitude", "TargetCellId", "TargetPointIds", "TargetBarycentric" };
// Field data of AddSphereImage(), and of the array "TexturePosition".
const char* const ImageFields[] = { "SpherePole", "SphereUp", "SphereRight", "TextureProjection",
  "TextureFieldOfView", "TextureScale", "TextureMargin", glue::TextureAreaBalanceName() };
const char* const DistortionArrays[] = { "AngleDistortion", "AreaDistortion",
  "QuasiConformalError" };
const char* const DistortionFields[] = { "MeanAngleDistortion", "MeanQuasiConformalError",
  "MaximumQuasiConformalError", "QuasiConformalError95", "AreaDistortionDeviation", "SphereDegree",
  "NumberOfFlippedTriangles", "NumberOfZeroAreaTriangles" };

constexpr double Turn = 360.0; // degrees

// Return the angle plus turns that is nearest to another angle, in degrees.
double nearestTurn(double angle, double other)
{
  return angle + Turn * std::round((other - angle) / Turn);
}

template <std::size_t Size>
void RemoveArrays(vtkFieldData* data, const char* const (&names)[Size])
{
  for (const char* name : names)
  {
    data->RemoveArray(name);
  }
}

const double* NumbersOf(vtkFieldData* data, const char* name, int components)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array || array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != 1)
  {
    throw std::invalid_argument(
      std::string("the surface has no field data ") + name + " of vtkSphericalTextureMap");
  }
  const double* numbers = array->GetTuple(0);
  for (int i = 0; i < components; ++i)
  {
    if (!std::isfinite(numbers[i]))
    {
      throw std::invalid_argument(std::string("the field data ") + name + " are not finite");
    }
  }
  return numbers;
}

// Check that the axes are orthogonal unit vectors, up to rounding to single precision or six
// digits. The axes may be left-handed, since maps may mirror the sphere.
void CheckAxes(const conformal::SphereView& view)
{
  constexpr double tolerance = 1e-5;
  Eigen::Matrix3d axes;
  axes << view.Right, view.Up, view.Pole;
  const Eigen::Matrix3d off = axes.transpose() * axes - Eigen::Matrix3d::Identity();
  if (!(off.cwiseAbs().maxCoeff() <= tolerance))
  {
    throw std::invalid_argument(
      "the field data SpherePole, SphereUp and SphereRight are not orthogonal unit "
      "vectors; run vtkSphericalTextureMap again");
  }
}

double NumberIn(vtkFieldData* data, const char* name, double minimum, double maximum)
{
  const double number = *NumbersOf(data, name, 1);
  if (number < minimum || number > maximum)
  {
    throw std::invalid_argument(std::string("the field data ") + name + " are out of range");
  }
  return number;
}
}

namespace glue
{
//------------------------------------------------------------------------------
void AddSphereImage(vtkFieldData* data, const conformal::SphereImage& image)
{
  AddVectors(data, "SpherePole", image.View.Pole.transpose());
  AddVectors(data, "SphereUp", image.View.Up.transpose());
  AddVectors(data, "SphereRight", image.View.Right.transpose());
  AddNumber(data, "TextureProjection", static_cast<long long>(image.Projection));
  AddNumber(data, "TextureFieldOfView", image.FieldOfView);
  AddTuple(data, "TextureScale", image.Scale.data(), 2);
  AddNumber(data, "TextureMargin", image.Margin);
}

//------------------------------------------------------------------------------
conformal::SphereImage ToSphereImage(vtkFieldData* data)
{
  conformal::SphereImage image;
  image.View.Pole = conformal::Vector3(NumbersOf(data, "SpherePole", 3));
  image.View.Up = conformal::Vector3(NumbersOf(data, "SphereUp", 3));
  image.View.Right = conformal::Vector3(NumbersOf(data, "SphereRight", 3));
  CheckAxes(image.View);
  const double projection = NumberIn(
    data, "TextureProjection", 0.0, static_cast<double>(conformal::SphereProjection::Square));
  if (projection != std::floor(projection))
  {
    throw std::invalid_argument("the field data TextureProjection must be a whole number");
  }
  image.Projection = static_cast<conformal::SphereProjection>(static_cast<int>(projection));
  image.FieldOfView = NumberIn(
    data, "TextureFieldOfView", conformal::MinimumFieldOfView, conformal::MaximumFieldOfView);
  image.Scale = conformal::Vector2(NumbersOf(data, "TextureScale", 2));
  if (image.Scale.minCoeff() < conformal::MinimumScale ||
    image.Scale.maxCoeff() > conformal::MaximumScale)
  {
    throw std::invalid_argument("the field data TextureScale are out of range");
  }
  image.Margin = NumberIn(data, "TextureMargin", 0.0, conformal::MaximumMargin);
  return image;
}

//------------------------------------------------------------------------------
bool HoldsPlaces(const std::string& name)
{
  return name == SpherePositionName() || name == TorusPositionName() || HoldsLongitudes(name) ||
    name == "OriginalPointIds" || name == "OutsideImage" ||
    std::find(std::begin(FromMap), std::end(FromMap), name) != std::end(FromMap);
}

//------------------------------------------------------------------------------
void ReplaceSpherePositions(vtkPolyData* surface, const conformal::Points& positions)
{
  AddVectors(surface->GetPointData(), SpherePositionName(), positions);
  RemoveArrays(surface->GetPointData(), FromMap);
  RemoveArrays(surface->GetFieldData(), ImageFields);
}

//------------------------------------------------------------------------------
void RemoveDistortions(vtkPolyData* surface)
{
  RemoveArrays(surface->GetCellData(), DistortionArrays);
  RemoveArrays(surface->GetFieldData(), DistortionFields);
}

//------------------------------------------------------------------------------
void RemoveAreaDistortions(vtkPolyData* surface)
{
  surface->GetCellData()->RemoveArray("AreaDistortion");
  surface->GetFieldData()->RemoveArray("AreaDistortionDeviation");
}

//------------------------------------------------------------------------------
conformal::Points ToTexturePositions(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(TexturePositionName());
  if (!array)
  {
    return ToSpherePositions(surface);
  }
  conformal::Points positions;
  if (!ToVectors(array, positions) || conformal::normalizeRows(positions) > 0)
  {
    throw std::invalid_argument(
      "TexturePosition must have 3 components, and no vector that is zero or not finite; run "
      "vtkSphericalTextureMap again");
  }
  return positions;
}

//------------------------------------------------------------------------------
void SetImageInformation(vtkInformation* info, const int size[2])
{
  SetImageInformation(info, size, 0.0, 0.0, 1.0, 1.0);
}

//------------------------------------------------------------------------------
void SetImageInformation(
  vtkInformation* info, const int size[2], double x, double y, double width, double height)
{
  if (size[0] < 1 || size[1] < 1 || size[1] > std::numeric_limits<int>::max() / size[0])
  {
    throw std::invalid_argument(
      "ImageSize must be at least (1, 1), with at most 2147483647 pixels");
  }
  const int extent[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, 0 };
  const double spacing[3] = { width / size[0], height / size[1], 1.0 };
  const double origin[3] = { x + 0.5 * width / size[0], y + 0.5 * height / size[1], 0.0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
}

//------------------------------------------------------------------------------
vtkDataArray* AllocatePixels(vtkImageData* image, vtkInformation* info, vtkDataArray* like)
{
  image->SetExtent(info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  image->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  image->SetSpacing(info->Get(vtkDataObject::SPACING()));
  const auto pixels = vtkSmartPointer<vtkDataArray>::Take(like->NewInstance());
  pixels->SetName(like->GetName());
  pixels->SetNumberOfComponents(like->GetNumberOfComponents());
  pixels->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->SetScalars(pixels);
  return pixels;
}

//------------------------------------------------------------------------------
bool HoldsWholeNumbers(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

//------------------------------------------------------------------------------
bool HoldsLongitudes(const std::string& name)
{
  return name == "Longitude" || name == "PlanetocentricLongitude";
}

//------------------------------------------------------------------------------
bool HoldsLabels(vtkDataArray* array)
{
  return array->GetNumberOfComponents() == 1 && HoldsWholeNumbers(array);
}

//------------------------------------------------------------------------------
vtkDataArray* ArrayToBake(vtkPointSet* data, const std::string& name)
{
  vtkDataArray* array = name.empty() ? data->GetPointData()->GetScalars()
                                     : data->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw std::invalid_argument(name.empty()
        ? "the source has no active scalars to bake; set ArrayName"
        : "no point array " + name + " to bake");
  }
  return array;
}

//------------------------------------------------------------------------------
conformal::PixelSink PixelPainter(
  vtkDataArray* values, vtkDataArray* pixels, vtkUnsignedCharArray* holes)
{
  const bool isWhole = HoldsWholeNumbers(values), isOfLabels = HoldsLabels(values),
             isOfLongitudes = values->GetName() && HoldsLongitudes(values->GetName());
  return [=](conformal::Index first, const std::vector<conformal::SurfacePlace>& places)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const conformal::SurfacePlace& place = places[i];
      const vtkIdType pixel = first + static_cast<vtkIdType>(i);
      const bool isHole = place.Ids[0] < 0;
      holes->SetValue(pixel, isHole);
      conformal::Index largest = 0;
      // A copy keeps integers of 64 bits.
      if (!isHole && (place.Weights.maxCoeff(&largest) == 1.0 || isOfLabels))
      {
        pixels->SetTuple(pixel, place.Ids[largest], values);
        continue;
      }
      for (int c = 0; c < values->GetNumberOfComponents(); ++c)
      {
        double sum = 0.0;
        for (int k = 0; k < 3 && !isHole; ++k)
        {
          const double weight = place.Weights[k]; // 0 for values that can be infinite
          double value = values->GetComponent(place.Ids[k], c);
          if (isOfLongitudes)
          {
            value = nearestTurn(value, values->GetComponent(place.Ids[largest], c));
          }
          sum += weight != 0.0 ? weight * value : 0.0;
        }
        sum = isOfLongitudes ? sum - Turn * std::floor(sum / Turn) : sum;
        pixels->SetComponent(pixel, c, isWhole ? std::round(sum) : sum);
      }
    }
  };
}

//------------------------------------------------------------------------------
conformal::Picture ToPicture(vtkImageData* image, vtkDataArray* pixels)
{
  conformal::Picture picture;
  picture.Grid = { image->GetDimensions()[0], image->GetDimensions()[1] };
  picture.NumberOfComponents = pixels->GetNumberOfComponents();
  picture.Values.resize(pixels->GetNumberOfValues());
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
  {
    picture.Values[i] = pixels->GetComponent(
      i / picture.NumberOfComponents, static_cast<int>(i % picture.NumberOfComponents));
  }
  return picture;
}

//------------------------------------------------------------------------------
vtkNew<vtkUnsignedCharArray> MakeHoles(vtkImageData* image)
{
  vtkNew<vtkUnsignedCharArray> holes;
  holes->SetName("OutsideSurface");
  holes->SetNumberOfValues(image->GetNumberOfPoints());
  return holes;
}
}
