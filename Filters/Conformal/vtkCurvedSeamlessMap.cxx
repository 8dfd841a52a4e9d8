#include "vtkCurvedSeamlessMap.h"

#include "Base/AcrossProcesses.h"
#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/GeodesicSphere.h"
#include "Surface/CurvedSeamlessSurface.h"
#include "vtkConformalConversions.h"
#include "vtkInputChecks.h"
#include "vtkMeshConversions.h"
#include "vtkProcessConversions.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkCurvedSeamlessMap);

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

// With a warning where neither the property nor the mesh tells, and a learned mesh is likely.
bool IsPolished(vtkCurvedSeamlessMap* map, vtkObject* self, vtkPolyData* surface,
  const vtkConformalConversions::ClosedMesh& mesh)
{
  int polished = map->GetPolished();
  if (polished == vtkCurvedSeamlessMap::AUTOMATIC)
  {
    polished = PolishedOf(surface->GetFieldData());
  }
  const bool isUsed =
    map->GetDomeHeight() >= vtkCurvedSeamlessMap::CURVATURE && map->GetVertexShift() > 0.0;
  if (polished == vtkCurvedSeamlessMap::AUTOMATIC && isUsed &&
    conformal::hasGeodesicConnectivity(mesh.Triangles, mesh.Positions.rows()))
  {
    vtkWarningWithObjectMacro(self,
      << "the surface has the connectivity of a mesh of vtkConformalSOM, but no field array "
         "\"Polished\"; it is taken as not polished. Set Polished to On if it was learned in batch "
         "training, or to Off if it was not.");
  }
  return polished == vtkCurvedSeamlessMap::ON;
}

conformal::CurvedSeamlessSurfaceOptions OptionsOf(vtkCurvedSeamlessMap* self)
{
  conformal::CurvedSeamlessSurfaceOptions options;
  options.SeamMode = static_cast<conformal::SeamMode>(self->GetSeamMode());
  options.DomeHeight = static_cast<conformal::DomeHeight>(self->GetDomeHeight());
  options.VertexShift = self->GetVertexShift();
  options.Fit.NumberOfFitRounds = self->GetNumberOfFitRounds();
  options.Fit.FitSmoothness = self->GetFitSmoothness();
  return options;
}

conformal::Points MapOf(vtkPolyData* surface, const std::vector<vtkIdType>& pointIds)
{
  conformal::Points all;
  if (!vtkConformalConversions::FindSpherePositions(surface, all))
  {
    throw std::invalid_argument(
      "the surface needs a point array SpherePosition: its map to the sphere");
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
Model ModelOf(vtkCurvedSeamlessMap* map, vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, vtkConformalConversions::Processes& processes,
  const conformal::Progress& progress)
{
  const bool isAlone = processes.size() == 1;
  Model model;
  model.Options = OptionsOf(map);
  if (isAlone || processes.firstWith(surface->GetNumberOfPoints() > 0) == processes.rank())
  {
    auto mesh = vtkConformalConversions::ToClosedMesh(self, surface, frame, progress);
    model.Options.Polished = IsPolished(map, self, surface, mesh);
    model.SpherePositions = MapOf(surface, mesh.PointIds);
    model.Positions = std::move(mesh.Positions);
    model.Triangles = std::move(mesh.Triangles);
  }
  if (!isAlone)
  {
    const conformal::Reduce reduce = processes.reduce();
    model.Positions = conformal::gatherRows(reduce, model.Positions);
    model.Triangles = conformal::gatherRows(reduce, model.Triangles);
    model.SpherePositions = conformal::gatherRows(reduce, model.SpherePositions);
    model.Options.Polished = processes.firstWith(model.Options.Polished) >= 0;
  }
  return model;
}

conformal::TrainingSamples SamplesOf(vtkObject* self, vtkPointSet* cloud,
  const conformal::CoordinateFrame& frame, conformal::Points& copy,
  vtkConformalConversions::Processes& processes, const conformal::Progress& progress)
{
  conformal::TrainingSamples samples(
    vtkConformalConversions::ViewPoints(cloud->GetPoints(), frame, copy), {},
    vtkConformalConversions::GhostTest(cloud), vtkConformalConversions::SMPFor(),
    processes.reduce(), progress);
  if (samples.numberOfNonFinite() > 0 && processes.isFirst())
  {
    vtkWarningWithObjectMacro(
      self, << samples.numberOfNonFinite() << " points of the cloud are not finite and left out");
  }
  return samples;
}

// An array's memory for so many tuples; none for no array.
double* Sized(vtkDoubleArray* array, int components, conformal::Index tuples)
{
  if (!array)
  {
    return nullptr;
  }
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array->GetPointer(0);
}

// Results of their own, none of them the array they are made from.
void RequireDifferent(vtkDataArray* from, std::initializer_list<vtkDoubleArray*> arrays)
{
  for (auto array = arrays.begin(); array != arrays.end(); ++array)
  {
    if (*array && (*array == from || std::find(arrays.begin(), array, *array) != array))
    {
      throw std::invalid_argument("an array is given twice. Pass a new one for each result.");
    }
  }
}

void Empty(std::initializer_list<vtkDoubleArray*> arrays)
{
  for (vtkDoubleArray* array : arrays)
  {
    if (array)
    {
      array->SetNumberOfTuples(0);
    }
  }
}

// What fails leaves nothing behind.
bool FillOrEmpty(vtkObject* self, vtkDataArray* from, std::initializer_list<vtkDoubleArray*> arrays,
  const std::function<void()>& fill)
{
  return vtkConformalConversions::ReportErrors(self,
    [&]()
    {
      RequireDifferent(from, arrays);
      Empty(arrays);
      try
      {
        fill();
      }
      catch (...)
      {
        Empty(arrays);
        throw;
      }
    });
}

// None for no array.
void LengthsFromFrame(
  vtkDoubleArray* array, const conformal::CoordinateFrame& frame, const char* what)
{
  if (array)
  {
    vtkConformalConversions::LengthsFromFrame(
      array->GetPointer(0), array->GetNumberOfValues(), frame, what);
  }
}

void AreasFromFrame(
  vtkDoubleArray* array, const conformal::CoordinateFrame& frame, const char* what)
{
  if (array)
  {
    vtkConformalConversions::AreasFromFrame(
      array->GetPointer(0), array->GetNumberOfValues(), frame, what);
  }
}

conformal::Points UnitDirections(vtkDataArray* directions)
{
  conformal::Points copy;
  return conformal::unitVectors(
    vtkConformalConversions::ViewVectors(directions, "directions", copy), "direction",
    vtkConformalConversions::SMPFor());
}
}

//------------------------------------------------------------------------------
vtkCurvedSeamlessMap::vtkCurvedSeamlessMap() = default;
vtkCurvedSeamlessMap::~vtkCurvedSeamlessMap() = default;

//------------------------------------------------------------------------------
const conformal::CurvedSeamlessSurface& vtkCurvedSeamlessMap::Built() const
{
  if (!this->Surface)
  {
    throw std::logic_error("there is no map: Build() it first");
  }
  return *this->Surface;
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessMap::BuildCore(vtkObject* self, vtkPolyData* surface, vtkPointSet* cloud,
  const std::function<bool(double)>& progress, vtkConformalConversions::Processes& processes)
{
  this->Surface.reset();
  const conformal::CurvedSeamlessSurfaceOptions options = OptionsOf(this);
  const bool fits = cloud && options.DomeHeight == conformal::DomeHeight::Fitted;
  this->Frame = std::make_unique<conformal::CoordinateFrame>(
    vtkConformalConversions::FrameOf({ surface, fits ? cloud : nullptr }, processes.reduce()));
  const auto size = static_cast<double>(surface->GetNumberOfPoints());
  const double cloudSize = fits ? static_cast<double>(cloud->GetNumberOfPoints()) : 0.0;
  const double rounds = 1.0 + options.Fit.NumberOfFitRounds;
  conformal::Steps steps(progress,
    { 750.0 * size, 80.0 * cloudSize,
      (options.SeamMode == conformal::SeamMode::EdgeMatched ? 4500.0 : 2500.0) * size +
        (fits ? rounds * (2500.0 * cloudSize + 10000.0 * size) : 0.0) });
  const Model model = ModelOf(this, self, surface, *this->Frame, processes, steps.next());
  conformal::Points copy;
  const conformal::Progress reading = steps.next();
  const conformal::TrainingSamples samples = fits
    ? SamplesOf(self, cloud, *this->Frame, copy, processes, reading)
    : conformal::TrainingSamples(conformal::PointView());
  this->Surface = std::make_unique<conformal::CurvedSeamlessSurface>(model, model.Options,
    fits ? &samples : nullptr, vtkConformalConversions::SMPFor(), steps.next());
  const conformal::Index degenerate = this->Surface->numberOfDegeneratePatches();
  if (degenerate > 0 && processes.isFirst())
  {
    vtkWarningWithObjectMacro(
      self, << degenerate
            << " triangles of the surface are degenerate: they have no shape and are mapped "
               "affinely, or would turn over and are flattened");
  }
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessMap::TakeProperties(const vtkCurvedSeamlessMap& other)
{
  this->SeamMode = other.SeamMode;
  this->DomeHeight = other.DomeHeight;
  this->Polished = other.Polished;
  this->VertexShift = other.VertexShift;
  this->NumberOfFitRounds = other.NumberOfFitRounds;
  this->FitSmoothness = other.FitSmoothness;
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessMap::TakeMap(vtkCurvedSeamlessMap& other)
{
  this->Surface = std::move(other.Surface);
  this->Frame = std::move(other.Frame);
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::Build(vtkPolyData* surface, vtkPointSet* cloud)
{
  return vtkConformalConversions::ReportErrors(this,
    [&]()
    {
      this->Surface.reset();
      if (!surface || surface->GetNumberOfPoints() == 0)
      {
        throw std::invalid_argument("there is no surface to build a map of");
      }
      vtkInputChecks::RequireConsistentData(surface, "surface");
      vtkInputChecks::RequireConsistentData(cloud, "cloud");
      vtkConformalConversions::Processes alone;
      this->BuildCore(this, surface, cloud, {}, alone);
    });
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::ToSurface(
  vtkDataArray* directions, vtkDoubleArray* positions, vtkDoubleArray* normals)
{
  return FillOrEmpty(this, directions, { positions, normals },
    [&]()
    {
      const conformal::CurvedSeamlessSurface& surface = this->Built();
      const conformal::Points units = UnitDirections(directions);
      conformal::SurfaceSamples samples;
      samples.Positions = Sized(positions, 3, units.rows());
      samples.Normals = Sized(normals, 3, units.rows());
      conformal::evaluate(surface, units, samples, vtkConformalConversions::SMPFor());
      LengthsFromFrame(positions, *this->Frame, "positions");
    });
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::Differentiate(vtkDataArray* directions, vtkDoubleArray* derivatives,
  vtkDoubleArray* metrics, vtkDoubleArray* areaElements)
{
  return FillOrEmpty(this, directions, { derivatives, metrics, areaElements },
    [&]()
    {
      const conformal::CurvedSeamlessSurface& surface = this->Built();
      const conformal::Points units = UnitDirections(directions);
      conformal::SurfaceSamples samples;
      samples.Derivatives = Sized(derivatives, 9, units.rows());
      samples.Metrics = Sized(metrics, 9, units.rows());
      samples.AreaElements = Sized(areaElements, 1, units.rows());
      conformal::evaluate(surface, units, samples, vtkConformalConversions::SMPFor());
      LengthsFromFrame(derivatives, *this->Frame, "derivatives");
      AreasFromFrame(metrics, *this->Frame, "metrics");
      AreasFromFrame(areaElements, *this->Frame, "area elements");
    });
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessMap::ToSphere(
  vtkDataArray* points, vtkDoubleArray* directions, vtkDoubleArray* closestPoints)
{
  return FillOrEmpty(this, points, { directions, closestPoints },
    [&]()
    {
      if (!directions)
      {
        throw std::invalid_argument("there is no array to put the directions in");
      }
      const conformal::CurvedSeamlessSurface& surface = this->Built();
      conformal::Points inFrame;
      if (!vtkConformalConversions::ToVectors(points, inFrame))
      {
        throw std::invalid_argument("points must be an array of 3 components");
      }
      for (conformal::Index i = 0; i < inFrame.rows(); ++i)
      {
        inFrame.row(i) = this->Frame->toFrameFromAfar(inFrame.row(i));
      }
      conformal::invert(surface, inFrame, Sized(directions, 3, inFrame.rows()),
        Sized(closestPoints, 3, inFrame.rows()), vtkConformalConversions::SMPFor());
      LengthsFromFrame(closestPoints, *this->Frame, "closest points");
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkCurvedSeamlessMap::GetNumberOfDegeneratePatches()
{
  return this->Surface ? this->Surface->numberOfDegeneratePatches() : 0;
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessMap::GetNormalJumps(double jumps[2])
{
  jumps[0] = jumps[1] = 0.0;
  if (this->Surface && this->Surface->differentiable())
  {
    const conformal::NormalJumps measured =
      conformal::measureNormalJumps(this->Surface->curvedTriangles(), this->Surface->neighbors(),
        vtkConformalConversions::SMPFor());
    jumps[0] = measured.Mean;
    jumps[1] = measured.Largest;
  }
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessMap::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const domeHeights[] = { "None", "Published", "Scaled", "Curvature", "Fitted" };
  static const char* const polishedModes[] = { "Automatic", "Off", "On" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SeamMode: " << (this->SeamMode == PER_TRIANGLE ? "PerTriangle" : "EdgeMatched")
     << "\n";
  os << indent << "DomeHeight: " << domeHeights[this->DomeHeight] << "\n";
  os << indent << "Polished: " << polishedModes[this->Polished] << "\n";
  os << indent << "VertexShift: " << this->VertexShift << "\n";
  os << indent << "NumberOfFitRounds: " << this->NumberOfFitRounds << "\n";
  os << indent << "FitSmoothness: " << this->FitSmoothness << "\n";
  os << indent << "IsBuilt: " << (this->IsBuilt() ? "Yes" : "No") << "\n";
}
