#include "vtkSurfaceLayers.h"

#include "Base/Steps.h"
#include "Body/BodyCoordinates.h"
#include "Body/BodyRelief.h"
#include "Body/MapAreas.h"
#include "Glue/Arrays.h"
#include "Glue/LayerMaps.h"
#include "Glue/MapImages.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/SphereImages.h"
#include "Glue/Volumes.h"
#include "Mesh/VertexNormals.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

vtkStandardNewMacro(vtkSurfaceLayers);

namespace
{
using Range = std::array<double, 2>;

// Copy of the properties, since observers may change them during a run.
struct LayerProperties
{
  Range Depths, Summary;
  int NumberOfLayers;
  int Axis;
  conformal::MapImage Map;
};

bool IsAutomatic(const Range& range)
{
  return range[0] == 0.0 && range[1] == 0.0;
}

void RequireAscending(const Range& range, const char* name)
{
  if (!std::isfinite(range[0]) || !std::isfinite(range[1]) || range[0] > range[1])
  {
    throw std::invalid_argument(
      std::string(name) + " must be two finite depths, the lower depth first");
  }
}

// Check the properties, and convert depths to the frame.
void ToFrame(LayerProperties& properties, const conformal::VolumeImage& volume,
  const conformal::CoordinateFrame& frame)
{
  RequireAscending(properties.Depths, "DepthRange");
  RequireAscending(properties.Summary, "SummaryRange");
  glue::RequireMap(properties.Map);
  constexpr double voxels = 4.0, farthest = 1e6;
  const double size = voxels * volume.voxelSize();
  const bool isWhole = IsAutomatic(properties.Summary);
  if (IsAutomatic(properties.Depths))
  {
    properties.Depths = { -size * frame.Unit, size * frame.Unit };
  }
  properties.Summary = isWhole ? properties.Depths : properties.Summary;
  for (Range* range : { &properties.Depths, &properties.Summary })
  {
    for (double& depth : *range)
    {
      depth /= frame.Unit;
      if (range == &properties.Depths && !(std::abs(depth) <= farthest))
      {
        throw std::invalid_argument("DepthRange is much larger than the surface");
      }
    }
  }
}

// The surface, its map with the wanted axis, normals and limits. The points of `output` become the
// vertices.
glue::LayeredSurface MakeLayers(vtkSurfaceLayers* self, vtkPolyData* surface,
  const LayerProperties& properties, const conformal::CoordinateFrame& frame, vtkPolyData* output,
  const conformal::Run& run)
{
  conformal::Steps steps(run, { 0.1, 0.2, 0.7 }); // mesh, axis, limits
  glue::LayeredSurface layered;
  const glue::ClosedMesh closed = glue::ToClosedMesh(self, surface, frame, steps.next());
  static_cast<conformal::Mesh&>(layered.Mesh) = glue::Outward(closed);
  glue::PassClosedMesh(surface, closed, frame, output);
  layered.Mesh.SpherePositions = glue::ToSpherePositions(output);
  const conformal::Run axisRun = steps.next();
  if (properties.Axis != vtkSurfaceLayers::MAP_AXIS)
  {
    const conformal::ReferenceEllipsoid reference = conformal::referenceEllipsoid(layered.Mesh);
    conformal::BodyCoordinatesOptions axis;
    axis.Center = reference.Center;
    axis.RotationAxis = reference.Axes.col(0);
    axis.UseEnds = properties.Axis == vtkSurfaceLayers::ENDS;
    layered.Mesh.SpherePositions =
      conformal::findBodyCoordinates(layered.Mesh, axis, axisRun).SpherePositions;
    glue::ReplaceSpherePositions(output, layered.Mesh.SpherePositions);
    glue::RemoveAreaDistortions(output);
  }
  layered.Normals = conformal::vertexNormals(layered.Mesh.Positions, layered.Mesh.Triangles);
  layered.Depths =
    conformal::layerDepths(properties.Depths[0], properties.Depths[1], properties.NumberOfLayers);
  layered.Limits =
    conformal::limitLayers(layered.Mesh, layered.Normals, layered.Depths, steps.next());
  return layered;
}

void WarnOfCrossings(vtkObject* self, const glue::LayeredSurface& layered)
{
  if (layered.Limits.NumberOfFaults > 0)
  {
    vtkWarningWithObjectMacro(self, << layered.Limits.NumberOfFaults
                                    << " triangles of layers are inverted or cross others, since "
                                       "the surface does. Smooth the surface");
  }
}
}

//------------------------------------------------------------------------------
vtkSurfaceLayers::vtkSurfaceLayers()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
void vtkSurfaceLayers::SetVolumeConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkSurfaceLayers::SetVolumeData(vtkImageData* volume)
{
  this->SetInputData(1, volume);
}

//------------------------------------------------------------------------------
int vtkSurfaceLayers::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceLayers::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceLayers::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  for (int port = 1; port <= 2; ++port)
  {
    const int extent[6] = { 0, this->ImageSize[0] - 1, 0, this->ImageSize[1] - 1, 0,
      port == 1 ? this->NumberOfLayers - 1 : 0 };
    outputVector->GetInformationObject(port)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceLayers::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  glue::RequestWholeImage(inputVector[1]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceLayers::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto image = glue::Held(vtkImageData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkImageData* stack = vtkImageData::GetData(outputVector, 1);
  vtkImageData* summary = vtkImageData::GetData(outputVector, 2);
  LayerProperties properties = { { this->DepthRange[0], this->DepthRange[1] },
    { this->SummaryRange[0], this->SummaryRange[1] }, this->NumberOfLayers, this->Axis,
    { static_cast<conformal::MapProjection>(this->Projection), this->CentralLongitude,
      { this->ImageSize[0], this->ImageSize[1] }, this->CapsuleAspect } };
  const std::string name = this->ArrayName;
  const int component = this->Component;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the output is empty"))
      {
        return;
      }
      conformal::Steps steps(glue::RunOf(this), { 0.05, 0.55, 0.05, 0.35 });
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface });
      const conformal::VolumeImage volume =
        glue::ToVolume(image, name, component, frame, steps.next());
      ToFrame(properties, volume, frame);
      const vtkNew<vtkPolyData> result;
      const glue::LayeredSurface layered =
        MakeLayers(this, surface, properties, frame, result, steps.next());
      properties.Map.CapsuleAspect = conformal::capsuleAspectOf(
        layered.Mesh, properties.Map.Projection, properties.Map.CapsuleAspect);
      const conformal::LayerSampler sampler(
        volume, layered.Depths, properties.Summary[0], properties.Summary[1]);
      glue::AddLayers(result, layered, sampler, frame, steps.next());
      const vtkNew<vtkImageData> maps[2];
      glue::PaintLayers(maps[0], maps[1], layered, sampler, properties.Map, frame, steps.next());
      WarnOfCrossings(this, layered);
      output->ShallowCopy(result);
      stack->ShallowCopy(maps[0]);
      summary->ShallowCopy(maps[1]);
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceLayers::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const projections[] = { "Equirectangular", "LambertAzimuthal", "Mollweide",
    "PeirceQuincuncial", "Mercator", "Capsule" };
  const auto print = [&](const char* name, const auto* values)
  { os << indent << name << ": (" << values[0] << ", " << values[1] << ")\n"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Component: " << this->Component << "\n";
  print("DepthRange", this->DepthRange);
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
  print("SummaryRange", this->SummaryRange);
  static const char* const axes[] = { "MapAxis", "LongAxis", "Ends" };
  os << indent << "Axis: " << axes[this->Axis] << "\n";
  os << indent << "Projection: " << projections[this->Projection] << "\n";
  os << indent << "CentralLongitude: " << this->CentralLongitude << "\n";
  os << indent << "CapsuleAspect: " << this->CapsuleAspect << "\n";
  print("ImageSize", this->ImageSize);
}
