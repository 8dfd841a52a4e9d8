#include "Glue/LayerMaps.h"

#include "Body/MapAreas.h"
#include "Glue/Arrays.h"
#include "Glue/MapImages.h"
#include "Glue/SphereImages.h"
#include "Mesh/GenusZeroCheck.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace glue
{
namespace
{
vtkFloatArray* AddFloats(
  vtkDataSetAttributes* data, const char* name, int components, vtkIdType size)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  array->FillValue(0.0F);
  data->AddArray(array);
  return array;
}

// Position, normal and limits at a point of the surface.
struct LayerPlace
{
  conformal::Vector3 Position = conformal::Vector3::Zero(), Normal = conformal::Vector3::Zero();
  double Inward = 0.0, Outward = 0.0;
};

LayerPlace Interpolated(const LayeredSurface& surface, const conformal::SurfacePlace& place)
{
  LayerPlace result;
  for (int k = 0; k < 3; ++k)
  {
    const int v = place.Ids[k];
    const double weight = place.Weights[k];
    result.Position += weight * surface.Mesh.Positions.row(v).transpose();
    result.Normal += weight * surface.Normals.row(v).transpose();
    result.Inward += weight * surface.Limits.Inward[v];
    result.Outward += weight * surface.Limits.Outward[v];
  }
  result.Normal.normalize(); // zero if it has no length
  return result;
}

// Give an image of the map its coordinates: those of a map of a sphere with the area of the
// surface, or of a capsule.
void PlaceImage(vtkImageData* image, const LayeredSurface& surface, const conformal::MapImage& map,
  const conformal::CoordinateFrame& frame)
{
  const double area = conformal::surfaceArea(surface.Mesh.Positions, surface.Mesh.Triangles);
  const bool isInDegrees = map.Projection == conformal::MapProjection::Equirectangular;
  const double areaOfMap = 4.0 * conformal::Pi * map.CapsuleAspect; // of the sphere or capsule
  double scale = std::sqrt(area / areaOfMap) * (isInDegrees ? conformal::Degree : 1);
  LengthsFromFrame(&scale, 1, frame, "the spacing of the map");
  const conformal::Vector2 half = scale * map.halfSize();
  const double across = 2.0 * half[0] / double(map.Grid.Width),
               up = 2.0 * half[1] / double(map.Grid.Height);
  const std::vector<double>& depths = surface.Depths;
  double z[2] = { depths.front(), depths.size() > 1 ? depths[1] - depths[0] : 0.0 };
  LengthsFromFrame(z, 2, frame, "the spacing of the layers");
  const bool isStack = image->GetDimensions()[2] > 1;
  image->SetOrigin(0.5 * across - half[0], 0.5 * up - half[1], isStack ? z[0] : 0.0);
  image->SetSpacing(across, up, isStack && z[1] > 0.0 ? z[1] : across);
}

// Return names of layers: their depths with 6 digits. A depth that is 0 except for rounding errors
// is 0.0.
std::vector<std::string> TextsOfDepths(
  const std::vector<double>& depths, const conformal::CoordinateFrame& frame)
{
  const double rounding = 1e-9 * (depths.back() - depths.front());
  std::vector<std::string> texts;
  for (const double depth : depths)
  {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << (std::abs(depth) > rounding ? depth * frame.Unit : 0.0);
    const bool isWhole = text.str().find_first_of(".e") == std::string::npos;
    texts.push_back(text.str() + (isWhole ? ".0" : ""));
  }
  return texts;
}
}

//------------------------------------------------------------------------------
void AddLayers(vtkPolyData* output, const LayeredSurface& surface,
  const conformal::LayerSampler& sampler, const conformal::CoordinateFrame& frame,
  const conformal::Run& run)
{
  const conformal::Index size = surface.Normals.rows();
  const int layers = sampler.numberOfLayers();
  vtkPointData* data = output->GetPointData();
  vtkFloatArray* values = AddFloats(data, "Layers", layers, size);
  std::vector<double> maxima(size), means(size), depthsOfMaxima(size);
  constexpr conformal::Index blockSize = 256;
  float* const first = values->GetPointer(0);
  conformal::forBlocksReporting(run, size, blockSize,
    [&](conformal::Index begin, conformal::Index end)
    {
      for (conformal::Index v = begin; v < end; ++v)
      {
        const double inward = surface.Limits.Inward[v], outward = surface.Limits.Outward[v];
        float* const own = first + v * layers;
        sampler.sample(surface.Mesh.Positions.row(v), surface.Normals.row(v), inward, outward, own);
        const conformal::LayerSummary summary = sampler.summarize(own, inward, outward);
        maxima[v] = summary.Maximum;
        means[v] = summary.Mean;
        depthsOfMaxima[v] = summary.DepthOfMaximum;
      }
    });
  AddNumbers(data, "LayerMaximum", maxima);
  AddNumbers(data, "LayerMean", means);
  AddLengths(data, "DepthOfMaximum", depthsOfMaxima, frame);
  AddLengths(data, "InwardLimit", surface.Limits.Inward, frame);
  AddLengths(data, "OutwardLimit", surface.Limits.Outward, frame);
  AddLengths(output->GetFieldData(), "LayerDepths", surface.Depths, frame);
  AddNumber(
    output->GetFieldData(), "LayerFaults", static_cast<long long>(surface.Limits.NumberOfFaults));
  const std::vector<std::string> names = TextsOfDepths(surface.Depths, frame);
  for (int i = 0; i < layers; ++i)
  {
    values->SetComponentName(i, names[i].c_str());
  }
}

//------------------------------------------------------------------------------
void PaintLayers(vtkImageData* stack, vtkImageData* summary, const LayeredSurface& surface,
  const conformal::LayerSampler& sampler, const conformal::MapImage& map,
  const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  const int layers = sampler.numberOfLayers();
  const conformal::Index size = map.Grid.size();
  if (size > std::numeric_limits<int>::max() / layers)
  {
    throw std::length_error("ImageSize times NumberOfLayers exceeds 2147483647 pixels");
  }
  const int width = static_cast<int>(map.Grid.Width), height = static_cast<int>(map.Grid.Height);
  stack->SetDimensions(width, height, layers);
  summary->SetDimensions(width, height, 1);
  vtkFloatArray* slices = AddFloats(stack->GetPointData(), "Intensity", 1, size * layers);
  stack->GetPointData()->SetActiveScalars("Intensity");
  vtkFloatArray* maxima = AddFloats(summary->GetPointData(), "LayerMaximum", 1, size);
  vtkFloatArray* means = AddFloats(summary->GetPointData(), "LayerMean", 1, size);
  std::vector<double> depths(size, 0.0), areas(size, 0.0);
  summary->GetPointData()->SetActiveScalars("LayerMaximum");
  const auto outside = MakeHoles(summary);
  const conformal::PixelSink sink =
    [&](conformal::Index firstPixel, const std::vector<conformal::SurfacePlace>& places)
  {
    std::vector<float> values(layers);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const vtkIdType pixel = firstPixel + static_cast<vtkIdType>(i);
      const bool isOutside = places[i].Ids[0] < 0;
      outside->SetValue(pixel, isOutside);
      if (isOutside)
      {
        continue;
      }
      const LayerPlace place = Interpolated(surface, places[i]);
      sampler.sample(place.Position, place.Normal, place.Inward, place.Outward, values.data());
      for (int k = 0; k < layers; ++k)
      {
        slices->SetValue(k * size + pixel, values[k]);
      }
      const conformal::LayerSummary summed =
        sampler.summarize(values.data(), place.Inward, place.Outward);
      maxima->SetValue(pixel, static_cast<float>(summed.Maximum));
      means->SetValue(pixel, static_cast<float>(summed.Mean));
      depths[pixel] = summed.DepthOfMaximum;
      areas[pixel] = conformal::areaOfPixel(surface.Mesh, map, pixel, places[i]);
    }
  };
  conformal::paintMap(surface.Mesh, map, sink, run);
  AddLengths(summary->GetPointData(), "DepthOfMaximum", std::move(depths), frame);
  summary->GetPointData()->AddArray(outside);
  AddAreaScales(summary, std::move(areas));
  for (vtkImageData* image : { stack, summary })
  {
    AddCapsule(image, map);
    PlaceImage(image, surface, map, frame);
  }
}
}
