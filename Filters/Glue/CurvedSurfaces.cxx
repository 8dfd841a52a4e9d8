#include "Glue/CurvedSurfaces.h"

#include "Base/AcrossProcesses.h"
#include "Base/Steps.h"
#include "Cloud/TrainingSamples.h"
#include "Glue/CloudInput.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Mesh/EvenTriangles.h"
#include "Mesh/GeodesicSphere.h"
#include "Sphere/SheetCaps.h"

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
// Return VertexShift: the property or, if it is negative, the field array of the mesh. If both are
// missing and the mesh was probably fitted by vtkConformalSOM, issue a warning.
double VertexShiftOf(const glue::CurvedSeamlessProperties& properties, vtkObject* self,
  vtkPolyData* surface, const glue::ClosedMesh& mesh)
{
  if (!(properties.VertexShift < 0.0))
  {
    return properties.VertexShift;
  }
  if (vtkAbstractArray* array = surface->GetFieldData()->GetAbstractArray("VertexShift"))
  {
    auto* numbers = vtkDataArray::SafeDownCast(array);
    const double shift =
      numbers && numbers->GetNumberOfTuples() > 0 ? numbers->GetComponent(0, 0) : -1.0;
    if (!(shift >= 0.0 && shift <= conformal::MaximumVertexShift))
    {
      throw std::invalid_argument("the field array VertexShift of the surface has no number in [0, "
                                  "2]. Correct it, remove it, or set VertexShift.");
    }
    return shift;
  }
  if (properties.Options.DomeHeight >= conformal::DomeHeight::Curvature &&
    (conformal::hasGeodesicConnectivity(mesh.Triangles, mesh.Positions.rows()) ||
      conformal::hasEvenTriangles(mesh)))
  {
    vtkWarningWithObjectMacro(self,
      << "the surface has triangles like those of a mesh of vtkConformalSOM, but no field array "
         "\"VertexShift\"; its vertices are not moved. Set VertexShift to 1 if it was learned in "
         "batch training, or to 0 if it was not.");
  }
  return 0.0;
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

// Mesh and options from which a curved seamless surface is built.
struct Model : conformal::CappedSheet
{
  conformal::CurvedSeamlessSurfaceOptions Options;
};

// Return on all processes the model of the first process that has a surface.
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
    auto mesh = glue::ToClosedMesh(self, surface, frame, run, glue::Topology::ClosedOrSheet);
    model.Options.VertexShift = VertexShiftOf(properties, self, surface, mesh);
    model.SpherePositions = MapOf(surface, mesh.PointIds);
    model.Positions = std::move(mesh.Positions);
    model.Triangles = std::move(mesh.Triangles);
    if (mesh.NumberOfBorders > 0)
    {
      static_cast<conformal::CappedSheet&>(model) = conformal::withCaps(model);
    }
  }
  if (!isAlone)
  {
    static_cast<conformal::MappedMesh&>(model) = glue::GatherMesh(processes.reduce(), model);
    std::vector<double> own;
    if (tells)
    {
      own = { model.Options.VertexShift, static_cast<double>(model.NumberOfCapVertices),
        static_cast<double>(model.NumberOfCapTriangles) };
    }
    const std::vector<double> all = conformal::gather(processes.reduce(), own);
    if (!all.empty())
    {
      model.Options.VertexShift = all[0];
      model.NumberOfCapVertices = static_cast<conformal::Index>(all[1]);
      model.NumberOfCapTriangles = static_cast<conformal::Index>(all[2]);
    }
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
std::shared_ptr<const BuiltSurface> BuildSurface(const CurvedSeamlessProperties& properties,
  vtkObject* self, vtkPolyData* surface, vtkPointSet* cloud, const conformal::Run& run,
  Processes& processes)
{
  const conformal::CurvedSeamlessSurfaceOptions& options = properties.Options;
  const bool fits =
    options.DomeHeight == conformal::DomeHeight::Fitted && processes.firstWith(cloud) >= 0;
  const vtkNew<vtkPolyData> nothing;                       // on processes without a cloud
  conformal::Steps steps(run, { 0.02, 0.12, 0.03, 0.83 }); // progress: copies, mesh, cloud, surface
  const conformal::Run copying = steps.next();
  CloudInput points;
  if (fits)
  {
    ReadCloud(cloud ? cloud : nothing.Get(), {}, surface, processes.reduce(), points);
    SkipCopies({}, processes.reduce(), copying, points);
  }
  const conformal::CoordinateFrame frame =
    fits ? points.Frame : FrameOf({ surface }, processes.reduce());
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
      self, << degenerate << " of " << built->Surface.triangles().rows()
            << " triangles of the mesh have no shape, or would turn over. The surface is flat "
               "there, see array Degenerate");
  }
  return built;
}
}
