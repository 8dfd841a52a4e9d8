#include "vtkCurvedSeamlessSurface.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/CurvedSurfaces.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Processes.h"
#include "Glue/Run.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/TriangleSubdivision.h"
#include "Surface/CurvedSeamlessSurface.h"
#include "Surface/SampledSurface.h"
#include "vtkCurvedSeamlessMap.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkCurvedSeamlessSurface);
vtkCxxSetObjectMacro(vtkCurvedSeamlessSurface, Controller, vtkMultiProcessController);

namespace
{
double PointsOfFrequency(int frequency)
{
  return static_cast<double>(conformal::geodesicSphereSize(frequency));
}

// Return the number of parts into which each edge of the network is divided. Return 0 if the
// surface is not sampled on the network.
int SubdivisionsOf(const conformal::CurvedSeamlessSurface& surface, int sampling, bool hasSphere,
  int subdivisions, int frequency)
{
  const bool needsDirections = sampling == vtkCurvedSeamlessSurface::DIRECTIONS ||
    (sampling == vtkCurvedSeamlessSurface::AUTOMATIC && hasSphere);
  if (surface.isSheet() && needsDirections)
  {
    throw std::invalid_argument("a surface with a border is sampled on its triangles only; set "
                                "Sampling to NETWORK and remove the sphere on input port 1");
  }
  if (sampling == vtkCurvedSeamlessSurface::DIRECTIONS ||
    (sampling == vtkCurvedSeamlessSurface::AUTOMATIC &&
      (hasSphere || conformal::isGeodesicSphere(surface.sphere(), surface.triangles()))))
  {
    return 0;
  }
  return subdivisions > 0
    ? subdivisions
    : conformal::subdivisionsFor(surface.numberOfVertices(), PointsOfFrequency(frequency));
}

// Return the mesh of the directions in which the surface is sampled: the subdivided network, the
// mesh on input port 1, or a geodesic sphere.
conformal::Mesh DenseMesh(const conformal::CurvedSeamlessSurface& surface, int subdivisions,
  vtkPolyData* sphere, int frequency, const conformal::Run& run)
{
  if (subdivisions > 0)
  {
    return conformal::subdividedNetwork(surface, subdivisions, run);
  }
  if (!sphere)
  {
    return conformal::makeGeodesicSphere(frequency, run);
  }
  conformal::Mesh dense;
  dense.Triangles = glue::ToTriangles(sphere);
  if (!glue::FindSpherePositions(sphere, dense.Positions))
  {
    dense.Positions = glue::ToPoints(sphere->GetPoints(), {}); // of any length
  }
  return dense;
}

// Make an array with 3 doubles per tuple.
vtkNew<vtkDoubleArray> Vectors(const char* name)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  return array;
}

Eigen::Map<conformal::Points> ViewOf(vtkDoubleArray* array)
{
  return { array->GetPointer(0), array->GetNumberOfTuples(), 3 };
}

// Triangles and arrays of the output, with one tuple for each direction. They are empty on ranks
// that do not own the surface.
struct Samples
{
  conformal::Triangles Triangles;
  vtkNew<vtkDoubleArray> Directions = Vectors(glue::SpherePositionName()),
                         Positions = Vectors("Points"), Normals = Vectors("Normals");
  std::vector<unsigned char> Degenerate;   // 1 per tuple
  vtkSmartPointer<vtkDoubleArray> Support; // in [0, 1]; null if the mesh has none
  std::vector<double> VertexSupport;       // of the vertices of the network
};

// Find the first rank with a surface to sample; warn and return -1 if there is none.
int FindOwner(vtkCurvedSeamlessSurface* self, vtkPolyData* surface, vtkPolyData* directions,
  glue::Processes& processes)
{
  const bool hasDirections = !directions || directions->GetNumberOfPoints() > 0;
  const int owner = processes.firstWith(surface->GetNumberOfPoints() > 0 && hasDirections);
  if (owner < 0)
  {
    glue::WarnOfEmptyInput(self, processes,
      surface->GetNumberOfPoints() == 0
        ? "the surface is empty; the output is empty"
        : "the sphere on input port 1 is empty; the output is empty");
  }
  return owner;
}

// Return measured relative costs of the steps: the map; the sphere, its triangles and its
// directions; the surface, its normals and the output.
std::vector<double> CostOf(conformal::DomeHeight domeHeight)
{
  return { domeHeight == conformal::DomeHeight::Fitted ? 4.0 : 0.5, 0.04, 0.02, 0.03, 0.9,
    domeHeight < conformal::DomeHeight::Curvature ? 0.15 : 0.01, 0.03 };
}

// Prepare the array Supported of the result, if the owner's mesh has this array. The array is
// ignored if the mesh has isolated points, since its point ids then differ from the vertex ids of
// the network.
void AddSupport(Samples& samples, vtkPolyData* mesh,
  const conformal::CurvedSeamlessSurface& network, bool isOwner, glue::Processes& processes)
{
  constexpr const char* name = "Supported";
  vtkDataArray* array = isOwner ? mesh->GetPointData()->GetArray(name) : nullptr;
  const bool hasSupport = array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == network.numberOfVertices();
  if (processes.firstWith(hasSupport) >= 0)
  {
    std::vector<double> copy;
    samples.VertexSupport = conformal::clampedSupport(
      network, hasSupport ? glue::ViewNumbers(array, copy) : conformal::NumberView());
    samples.Support = vtkSmartPointer<vtkDoubleArray>::New();
    samples.Support->SetName(name);
    samples.Support->SetNumberOfTuples(samples.Directions->GetNumberOfTuples());
  }
}

// Move a mesh of directions into the output and the samples, in two steps.
void SetDirections(Samples& samples, conformal::Mesh dense, bool isNetwork, vtkPolyData* result,
  conformal::Steps& steps)
{
  steps.next();
  samples.Triangles = std::move(dense.Triangles);
  glue::SetTriangles(result, samples.Triangles);
  steps.next();
  samples.Directions->SetNumberOfTuples(dense.Positions.rows());
  if (isNetwork)
  {
    ViewOf(samples.Directions) = dense.Positions; // exact copies, so that vertices are recognized
  }
  else
  {
    conformal::copyUnitVectors(
      dense.Positions, "direction", samples.Directions->GetPointer(0), glue::SMPRun());
  }
}

// Evaluate a surface in the directions of the samples, in three steps. Orient the triangles by the
// normals, smooth normals of domes, and fill in missing ones.
void Evaluate(Samples& samples, const conformal::CurvedSeamlessSurface& surface,
  bool smoothsNormals, vtkPolyData* result, conformal::Steps& steps)
{
  const conformal::Index size = samples.Directions->GetNumberOfTuples();
  samples.Positions->SetNumberOfTuples(size);
  samples.Normals->SetNumberOfTuples(size);
  samples.Degenerate.resize(size);
  conformal::SurfaceSamples values;
  values.Positions = samples.Positions->GetPointer(0);
  values.Normals = samples.Normals->GetPointer(0);
  values.Degenerate = samples.Degenerate.data();
  values.Numbers = samples.Support ? samples.Support->GetPointer(0) : nullptr;
  values.VertexNumbers = samples.VertexSupport.data();
  conformal::evaluate(surface, { samples.Directions->GetPointer(0), size }, values, steps.next());
  steps.next();
  const auto positions = ViewOf(samples.Positions);
  auto normals = ViewOf(samples.Normals);
  if (conformal::isOrientedInward(positions, samples.Triangles, normals))
  {
    samples.Triangles.col(1).swap(samples.Triangles.col(2));
    glue::SetTriangles(result, samples.Triangles);
  }
  if (smoothsNormals)
  {
    conformal::smoothNormals(positions, samples.Triangles, normals);
  }
  steps.next();
  conformal::fillNormals(normals, ViewOf(samples.Directions), glue::SMPRun());
}

// Move positions, directions, normals and support into the output.
void SetPointData(vtkPolyData* result, Samples& samples, const conformal::CoordinateFrame& frame)
{
  glue::LengthsFromFrame(samples.Positions->GetPointer(0), samples.Positions->GetNumberOfValues(),
    frame, "coordinates of the result");
  vtkNew<vtkPoints> points;
  points->SetData(samples.Positions);
  result->SetPoints(points);
  result->GetPointData()->AddArray(samples.Directions);
  result->GetPointData()->SetNormals(samples.Normals);
  if (samples.Support)
  {
    result->GetPointData()->AddArray(samples.Support);
  }
}

// Add the marks of degenerate cells and the number of degenerate triangles of the network.
void AddDegenerate(vtkPolyData* result, const Samples& samples,
  const conformal::CurvedSeamlessSurface& network, int subdivisions)
{
  vtkNew<vtkUnsignedCharArray> cells;
  cells->SetName("Degenerate");
  cells->SetNumberOfValues(samples.Triangles.rows());
  conformal::markDegenerate(network, samples.Triangles, subdivisions, samples.Degenerate,
    cells->GetPointer(0), glue::SMPRun());
  result->GetCellData()->AddArray(cells);
  glue::AddNumber(result->GetFieldData(), "NumberOfDegeneratePatches",
    static_cast<long long>(network.numberOfDegeneratePatches()));
}

glue::CurvedSeamlessProperties PropertiesOf(vtkCurvedSeamlessSurface* filter)
{
  glue::CurvedSeamlessProperties properties;
  conformal::CurvedSeamlessSurfaceOptions& options = properties.Options;
  options.SeamMode = static_cast<conformal::SeamMode>(filter->GetSeamMode());
  options.DomeHeight = static_cast<conformal::DomeHeight>(filter->GetDomeHeight());
  options.Fit.NumberOfFitRounds = filter->GetNumberOfFitRounds();
  options.Fit.FitSmoothness = filter->GetFitSmoothness();
  properties.VertexShift = filter->GetVertexShift();
  return properties;
}
}

//------------------------------------------------------------------------------
vtkCurvedSeamlessSurface::vtkCurvedSeamlessSurface()
{
  this->SetNumberOfInputPorts(3);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkCurvedSeamlessSurface::~vtkCurvedSeamlessSurface()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessSurface::SetSphereConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessSurface::SetSphereData(vtkPolyData* sphere)
{
  this->SetInputData(1, sphere);
}

//------------------------------------------------------------------------------
bool vtkCurvedSeamlessSurface::BuildMap(
  vtkPolyData* surface, vtkPointSet* cloud, vtkCurvedSeamlessMap* map)
{
  return map->Build(PropertiesOf(this), surface, cloud);
}

//------------------------------------------------------------------------------
int vtkCurvedSeamlessSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkPointSet" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkCurvedSeamlessSurface::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->DomeHeight == FITTED)
  {
    glue::RequestOwnPieces(this, this->Controller, inputs);
  }
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

//------------------------------------------------------------------------------
int vtkCurvedSeamlessSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto sphere = glue::Held(vtkPolyData::GetData(inputVector[1]));
  const auto cloud = glue::Held(vtkPointSet::GetData(inputVector[2]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const int frequency = this->Frequency, sampling = this->Sampling,
            subdivisions = this->Subdivisions;
  // Copied, since observers of the progress may change properties during the run.
  const glue::CurvedSeamlessProperties properties = PropertiesOf(this);
  const conformal::DomeHeight domeHeight = properties.Options.DomeHeight;
  const bool fits = domeHeight == conformal::DomeHeight::Fitted;
  return glue::RunCore(this, fits ? this->Controller : nullptr,
    [&](glue::Processes& processes)
    {
      this->Map->Take(nullptr);
      const int owner =
        FindOwner(this, surface, sampling == NETWORK ? nullptr : sphere.Get(), processes);
      if (owner < 0)
      {
        return;
      }
      conformal::Steps steps(processes.run(), CostOf(domeHeight));
      const auto map =
        glue::BuildSurface(properties, this, surface, cloud, steps.next(), processes);
      const int cuts =
        SubdivisionsOf(map->Surface, sampling, sphere != nullptr, subdivisions, frequency);
      const bool isOwner = processes.rank() == owner;
      const conformal::Run making = steps.next();
      const vtkNew<vtkPolyData> result;
      Samples samples;
      SetDirections(samples,
        isOwner ? DenseMesh(map->Surface, cuts, sphere, frequency, making) : conformal::Mesh(),
        cuts > 0, result, steps);
      AddSupport(samples, surface, map->Surface, isOwner, processes);
      Evaluate(samples, map->Surface, domeHeight < conformal::DomeHeight::Curvature, result, steps);
      SetPointData(result, samples, map->Frame);
      AddDegenerate(result, samples, map->Surface, cuts);
      output->ShallowCopy(result);
      this->Map->Take(map);
    });
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessSurface::SetCloudConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessSurface::SetCloudData(vtkPointSet* cloud)
{
  this->SetInputData(2, cloud);
}

//------------------------------------------------------------------------------
vtkCurvedSeamlessMap* vtkCurvedSeamlessSurface::GetMap()
{
  return this->Map;
}

//------------------------------------------------------------------------------
void vtkCurvedSeamlessSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const samplings[] = { "Automatic", "Directions", "Network" };
  os << indent << "Sampling: " << samplings[this->Sampling] << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "Subdivisions: " << this->Subdivisions << "\n";
  static const char* const domeHeights[] = { "None", "Published", "Scaled", "Curvature", "Fitted" };
  os << indent << "SeamMode: " << (this->SeamMode == PER_TRIANGLE ? "PerTriangle" : "EdgeMatched")
     << "\n";
  os << indent << "DomeHeight: " << domeHeights[this->DomeHeight] << "\n";
  os << indent << "VertexShift: " << this->VertexShift << "\n";
  os << indent << "NumberOfFitRounds: " << this->NumberOfFitRounds << "\n";
  os << indent << "FitSmoothness: " << this->FitSmoothness << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "Map:\n";
  this->Map->PrintSelf(os, indent.GetNextIndent());
}
