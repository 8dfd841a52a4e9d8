#include "vtkCurvedSeamlessConversions.h"

#include "Base/AcrossProcesses.h"
#include "Base/Steps.h"
#include "Cloud/TrainingSamples.h"
#include "Glue/CloudInput.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Mesh/EvenTriangles.h"
#include "Mesh/GeodesicSphere.h"
#include "vtkCurvedSeamlessMap.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <utility>
#include <vector>

namespace
{
int PolishedOf(vtkFieldData* data)
{
  vtkAbstractArray* array = data->GetAbstractArray("Polished");
  if (!array)
  {
    return vtkCurvedSeamlessMap::AUTOMATIC;
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers || numbers->GetNumberOfTuples() == 0)
  {
    throw std::invalid_argument("the field array Polished of the surface holds no number. Give it "
                                "one, or remove it, or set Polished to Off or On.");
  }
  return numbers->GetComponent(0, 0) != 0.0 ? vtkCurvedSeamlessMap::ON : vtkCurvedSeamlessMap::OFF;
}

double VertexShiftOf(const glue::CurvedSeamlessProperties& properties, vtkFieldData* data)
{
  if (!(properties.VertexShift < 0.0))
  {
    return properties.VertexShift;
  }
  vtkAbstractArray* array = data->GetAbstractArray("VertexShift");
  if (!array)
  {
    return conformal::UsualVertexShift;
  }
  auto* numbers = vtkDataArray::SafeDownCast(array);
  const double shift =
    numbers && numbers->GetNumberOfTuples() > 0 ? numbers->GetComponent(0, 0) : -1.0;
  if (!(shift >= 0.0 && shift <= conformal::MaximumVertexShift))
  {
    throw std::invalid_argument("the field array VertexShift of the surface holds no number from 0 "
                                "to 2. Give it one, or remove it, or set VertexShift.");
  }
  return shift;
}

// With a warning where neither the property nor the mesh tells, and a learned mesh is likely.
bool IsPolished(const glue::CurvedSeamlessProperties& properties, vtkObject* self,
  vtkPolyData* surface, const glue::ClosedMesh& mesh)
{
  int polished = properties.Polished;
  if (polished == vtkCurvedSeamlessMap::AUTOMATIC)
  {
    polished = PolishedOf(surface->GetFieldData());
  }
  const bool isUsed = properties.Options.DomeHeight >= conformal::DomeHeight::Curvature &&
    properties.VertexShift != 0.0;
  if (polished == vtkCurvedSeamlessMap::AUTOMATIC && isUsed &&
    (conformal::hasGeodesicConnectivity(mesh.Triangles, mesh.Positions.rows()) ||
      conformal::hasEvenTriangles(mesh)))
  {
    vtkWarningWithObjectMacro(self,
      << "the surface has triangles like those of a mesh of vtkConformalSOM, but no field array "
         "\"Polished\"; it is taken as not polished. Set Polished to On if it was learned in batch "
         "training, or to Off if it was not.");
  }
  return polished == vtkCurvedSeamlessMap::ON;
}

conformal::Points MapOf(vtkPolyData* surface, const std::vector<vtkIdType>& pointIds)
{
  conformal::Points all;
  if (!glue::FindSpherePositions(surface, all))
  {
    throw std::invalid_argument("the surface has no point array SpherePosition; vtkConformalSOM "
                                "and vtkGlobalConformalMap write it");
  }
  conformal::Points positions(static_cast<conformal::Index>(pointIds.size()), 3);
  for (conformal::Index v = 0; v < positions.rows(); ++v)
  {
    positions.row(v) = all.row(pointIds[v]);
  }
  return positions;
}

// What a map is built of.
struct Model : conformal::MappedMesh
{
  conformal::CurvedSeamlessSurfaceOptions Options;
};

// That of the first process that has a surface, on all of them.
Model ModelOf(const glue::CurvedSeamlessProperties& properties, vtkObject* self,
  vtkPolyData* surface, const conformal::CoordinateFrame& frame, glue::Processes& processes,
  const conformal::Run& run)
{
  const bool isAlone = processes.size() == 1;
  Model model;
  model.Options = properties.Options;
  const bool tells =
    isAlone || processes.firstWith(surface->GetNumberOfPoints() > 0) == processes.rank();
  if (tells)
  {
    auto mesh = glue::ToClosedMesh(self, surface, frame, run);
    model.Options.Polished = IsPolished(properties, self, surface, mesh);
    model.Options.VertexShift = VertexShiftOf(properties, surface->GetFieldData());
    model.SpherePositions = MapOf(surface, mesh.PointIds);
    model.Positions = std::move(mesh.Positions);
    model.Triangles = std::move(mesh.Triangles);
  }
  if (!isAlone)
  {
    static_cast<conformal::MappedMesh&>(model) = glue::GatherMesh(processes.reduce(), model);
    model.Options.Polished = processes.firstWith(model.Options.Polished) >= 0;
    const std::vector<double> own(tells ? 1 : 0, model.Options.VertexShift);
    const std::vector<double> shift = conformal::gather(processes.reduce(), own);
    model.Options.VertexShift = shift.empty() ? conformal::UsualVertexShift : shift.front();
  }
  return model;
}

conformal::TrainingSamples SamplesOf(vtkObject* self, const glue::CloudInput& cloud,
  glue::Processes& processes, const conformal::Run& run)
{
  conformal::TrainingSamples samples(cloud.View, {}, cloud.Skip, processes.reduce(), run);
  if (samples.numberOfNonFinite() > 0 && processes.isFirst())
  {
    vtkWarningWithObjectMacro(
      self, << samples.numberOfNonFinite() << " points of the cloud are not finite and left out");
  }
  if (processes.isFirst())
  {
    glue::WarnOfFarPoints(self, cloud.Far);
  }
  return samples;
}
}

namespace glue
{
//------------------------------------------------------------------------------
CurvedSeamlessProperties PropertiesOf(vtkCurvedSeamlessMap* map)
{
  CurvedSeamlessProperties properties;
  conformal::CurvedSeamlessSurfaceOptions& options = properties.Options;
  options.SeamMode = static_cast<conformal::SeamMode>(map->GetSeamMode());
  options.DomeHeight = static_cast<conformal::DomeHeight>(map->GetDomeHeight());
  options.Fit.NumberOfFitRounds = map->GetNumberOfFitRounds();
  options.Fit.FitSmoothness = map->GetFitSmoothness();
  properties.Polished = map->GetPolished();
  properties.VertexShift = map->GetVertexShift();
  return properties;
}

//------------------------------------------------------------------------------
std::shared_ptr<const BuiltSurface> BuildSurface(const CurvedSeamlessProperties& properties,
  vtkObject* self, vtkPolyData* surface, vtkPointSet* cloud, const conformal::Run& run,
  Processes& processes)
{
  const conformal::CurvedSeamlessSurfaceOptions& options = properties.Options;
  const bool fits = cloud && options.DomeHeight == conformal::DomeHeight::Fitted;
  CloudInput points;
  if (fits)
  {
    ReadCloud(cloud, {}, surface, processes.reduce(), points);
  }
  const conformal::CoordinateFrame frame =
    fits ? points.Frame : FrameOf({ surface }, processes.reduce());
  const auto size = static_cast<double>(surface->GetNumberOfPoints());
  const double cloudSize = fits ? static_cast<double>(cloud->GetNumberOfPoints()) : 0.0;
  const double rounds = 1.0 + options.Fit.NumberOfFitRounds;
  conformal::Steps steps(run,
    { 750.0 * size, 80.0 * cloudSize,
      (options.SeamMode == conformal::SeamMode::EdgeMatched ? 4500.0 : 2500.0) * size +
        (fits ? rounds * (2500.0 * cloudSize + 10000.0 * size) : 0.0) });
  const Model model = ModelOf(properties, self, surface, frame, processes, steps.next());
  const conformal::Run reading = steps.next();
  const conformal::TrainingSamples samples = fits
    ? SamplesOf(self, points, processes, reading)
    : conformal::TrainingSamples(conformal::PointView());
  std::shared_ptr<const BuiltSurface> built(new BuiltSurface{
    conformal::CurvedSeamlessSurface(model, model.Options, fits ? &samples : nullptr, steps.next()),
    frame });
  const conformal::Index degenerate = built->Surface.numberOfDegeneratePatches();
  if (degenerate > 0 && processes.isFirst())
  {
    vtkWarningWithObjectMacro(
      self, << degenerate
            << " triangles of the surface are degenerate: they have no shape and are mapped "
               "affinely, or would turn over and are flattened");
  }
  return built;
}
}
