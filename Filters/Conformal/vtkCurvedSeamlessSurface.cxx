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
#include "Mesh/VertexNormals.h"
#include "Sphere/Resampling.h"
#include "Surface/CurvedSeamlessSurface.h"
#include "vtkCurvedSeamlessMap.h"

#include "vtkCellData.h"
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
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

vtkStandardNewMacro(vtkCurvedSeamlessSurface);
vtkCxxSetObjectMacro(vtkCurvedSeamlessSurface, Controller, vtkMultiProcessController);

namespace
{
constexpr conformal::Index BlockSize = 4096;

double PointsOfFrequency(int frequency)
{
  return static_cast<double>(conformal::geodesicSphereSize(frequency));
}

// Into how many triangles along an edge those of the network are cut; 0 if the surface is sampled
// in other directions.
int SubdivisionsOf(const conformal::CurvedSeamlessSurface& surface, int sampling, bool hasSphere,
  int subdivisions, int frequency)
{
  if (sampling == vtkCurvedSeamlessSurface::DIRECTIONS ||
    (sampling == vtkCurvedSeamlessSurface::AUTOMATIC &&
      (hasSphere || conformal::isGeodesicSphere(surface.sphere(), surface.triangles()))))
  {
    return 0;
  }
  return subdivisions > 0
    ? subdivisions
    : conformal::subdivisionsFor(surface.sphere().rows(), PointsOfFrequency(frequency));
}

// Directions and triangles in which the surface is wanted.
conformal::Mesh DenseSphere(vtkPolyData* sphere, int frequency, const conformal::Run& run)
{
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

// Directions and triangles of the network, each cut into cuts * cuts, or else of the sphere.
conformal::Mesh DenseMesh(const conformal::CurvedSeamlessSurface& surface, int cuts,
  vtkPolyData* sphere, int frequency, const conformal::Run& run)
{
  return cuts > 0 ? conformal::subdividedNetwork(surface, cuts, run)
                  : DenseSphere(sphere, frequency, run);
}

// A new point array of 3 doubles.
vtkNew<vtkDoubleArray> Vectors(const char* name, conformal::Index size)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(size);
  return array;
}

using VectorMap = Eigen::Map<conformal::Points>;

VectorMap ViewOf(vtkDoubleArray* array)
{
  return VectorMap(array->GetPointer(0), array->GetNumberOfTuples(), 3);
}

// Where the surface has no normals that are continuous, those of its triangles around each point.
void SmoothNormals(
  const VectorMap& positions, const conformal::Triangles& triangles, VectorMap normals)
{
  const conformal::Points smooth = conformal::vertexNormals(positions, triangles);
  for (conformal::Index i = 0; i < normals.rows(); ++i)
  {
    if (!smooth.row(i).isZero(0.0))
    {
      normals.row(i) = smooth.row(i);
    }
  }
}

// Whether most of the area is wound against the normals, as where the map to the sphere mirrors.
bool IsWoundInward(
  const VectorMap& positions, const conformal::Triangles& triangles, const VectorMap& normals)
{
  double along = 0.0;
  for (conformal::Index r = 0; r < triangles.rows(); ++r)
  {
    const int a = triangles(r, 0), b = triangles(r, 1), c = triangles(r, 2);
    const conformal::Vector3 u = positions.row(b) - positions.row(a);
    const conformal::Vector3 v = positions.row(c) - positions.row(a);
    along += u.cross(v).dot(normals.row(a) + normals.row(b) + normals.row(c));
  }
  return along < 0.0;
}

void FillGaps(VectorMap normals, const VectorMap& directions)
{
  conformal::forBlocks(glue::SMPRun(), normals.rows(), BlockSize,
    [&](conformal::Index begin, conformal::Index end)
    {
      for (conformal::Index i = begin; i < end; ++i)
      {
        if (normals.row(i).isZero(0.0))
        {
          normals.row(i) = directions.row(i);
        }
      }
    });
}

constexpr const char* SupportName = "Supported";

// Isolated points are not part of the network; then nobody knows whose numbers are whose.
bool HasSupport(vtkPolyData* mesh, const conformal::CurvedSeamlessSurface& network)
{
  vtkDataArray* support = mesh->GetPointData()->GetArray(SupportName);
  return support && support->GetNumberOfComponents() == 1 &&
    support->GetNumberOfTuples() == network.sphere().rows();
}

// Which parts of the surface have points nearby, interpolated from the mesh.
std::vector<double> SupportAt(
  const VectorMap& directions, vtkPolyData* mesh, const conformal::CurvedSeamlessSurface& network)
{
  std::vector<double> shares(directions.rows());
  if (shares.empty())
  {
    return shares;
  }
  vtkDataArray* support = mesh->GetPointData()->GetArray(SupportName);
  conformal::Points values = conformal::Points::Zero(network.sphere().rows(), 3);
  for (conformal::Index i = 0; i < values.rows(); ++i)
  {
    const double value = support->GetComponent(i, 0);
    values(i, 0) = std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0;
  }
  const conformal::Points fine =
    conformal::resample(network.sphere(), values, network.triangles(), directions, glue::SMPRun());
  for (conformal::Index i = 0; i < fine.rows(); ++i)
  {
    shares[i] = std::clamp(fine(i, 0), 0.0, 1.0);
  }
  return shares;
}

// The triangles of which a test is true.
vtkNew<vtkUnsignedCharArray> DegenerateCells(
  conformal::Index size, const std::function<bool(conformal::Index)>& isDegenerate)
{
  vtkNew<vtkUnsignedCharArray> cells;
  cells->SetName("Degenerate");
  cells->SetNumberOfValues(size);
  unsigned char* degenerate = cells->GetPointer(0);
  conformal::forBlocks(glue::SMPRun(), size, BlockSize,
    [&](conformal::Index begin, conformal::Index end)
    {
      for (conformal::Index r = begin; r < end; ++r)
      {
        degenerate[r] = isDegenerate(r);
      }
    });
  return cells;
}

// Take the directions of a dense sphere as an array of unit vectors; what is left are triangles.
vtkNew<vtkDoubleArray> TakeDirections(conformal::Mesh& dense, bool areUnit)
{
  vtkNew<vtkDoubleArray> directions = Vectors(glue::SpherePositionName(), dense.Positions.rows());
  if (areUnit)
  {
    ViewOf(directions) = dense.Positions; // to the bit, so that vertices are found as such
  }
  else
  {
    conformal::copyUnitVectors(
      dense.Positions, "direction", directions->GetPointer(0), glue::SMPRun());
  }
  dense.Positions.resize(0, 3);
  return directions;
}

// Positions, normals and degenerate places of a surface in given directions.
struct DenseSurface
{
  explicit DenseSurface(conformal::Index size)
    : Positions(Vectors("Points", size))
    , Normals(Vectors("Normals", size))
    , Degenerate(size)
  {
  }

  conformal::SurfaceSamples samples()
  {
    conformal::SurfaceSamples samples;
    samples.Positions = this->Positions->GetPointer(0);
    samples.Normals = this->Normals->GetPointer(0);
    samples.Degenerate = this->Degenerate.data();
    return samples;
  }

  void passTo(vtkPolyData* surface) const
  {
    vtkNew<vtkPoints> points;
    points->SetData(this->Positions);
    surface->SetPoints(points);
    surface->GetPointData()->SetNormals(this->Normals);
  }

  // Mark the triangles in degenerate patches of the map, which is cut, or at degenerate places.
  vtkNew<vtkUnsignedCharArray> degenerateCells(const conformal::Triangles& triangles,
    const conformal::CurvedSeamlessSurface& map, conformal::Index cuts) const
  {
    return DegenerateCells(triangles.rows(),
      [&](conformal::Index r) -> bool
      {
        const auto ids = triangles.row(r);
        return cuts > 0
          ? map.degenerate()[r / (cuts * cuts)]
          : this->Degenerate[ids[0]] | this->Degenerate[ids[1]] | this->Degenerate[ids[2]];
      });
  }

  vtkNew<vtkDoubleArray> Positions, Normals;
  std::vector<unsigned char> Degenerate;
};

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
  // Observers may change properties meanwhile.
  const glue::CurvedSeamlessProperties properties = PropertiesOf(this);
  const bool fits = properties.Options.DomeHeight == conformal::DomeHeight::Fitted;
  return glue::RunCore(this, fits ? this->Controller : nullptr,
    [&](glue::Processes& processes)
    {
      const bool takesSphere = sphere && sampling != NETWORK;
      const int owner = processes.firstWith(
        surface->GetNumberOfPoints() > 0 && !(takesSphere && sphere->GetNumberOfPoints() == 0));
      if (owner < 0)
      {
        glue::WarnOfEmptyInput(this,
          surface->GetNumberOfPoints() == 0
            ? "the surface is empty; the output is empty"
            : "the sphere on input port 1 is empty; the output is empty");
        return;
      }
      const bool domes = properties.Options.DomeHeight < conformal::DomeHeight::Curvature;
      // Shares of the time, measured: the map; then the sphere, its triangles, its directions, the
      // surface, its normals, and what is left.
      conformal::Steps steps(
        processes.run(), { fits ? 4.0 : 0.5, 0.04, 0.02, 0.03, 0.9, domes ? 0.15 : 0.01, 0.03 });
      this->Map->Take(nullptr);
      const auto map =
        glue::BuildSurface(properties, this, surface, cloud, steps.next(), processes);
      const int cuts =
        SubdivisionsOf(map->Surface, sampling, sphere != nullptr, subdivisions, frequency);
      // What is large is let go as soon as the output has it.
      const conformal::Run making = steps.next();
      const bool isOwner = processes.rank() == owner;
      conformal::Mesh dense =
        isOwner ? DenseMesh(map->Surface, cuts, sphere, frequency, making) : conformal::Mesh();
      steps.next();
      const vtkNew<vtkPolyData> result;
      glue::SetTriangles(result, dense.Triangles);
      steps.next();
      const auto directions = TakeDirections(dense, cuts > 0);
      const conformal::Index size = directions->GetNumberOfTuples();
      DenseSurface made(size);
      conformal::evaluate(
        map->Surface, { directions->GetPointer(0), size }, made.samples(), steps.next());
      steps.next();
      if (IsWoundInward(ViewOf(made.Positions), dense.Triangles, ViewOf(made.Normals)))
      {
        dense.Triangles.col(1).swap(dense.Triangles.col(2));
        glue::SetTriangles(result, dense.Triangles);
      }
      if (domes)
      {
        SmoothNormals(ViewOf(made.Positions), dense.Triangles, ViewOf(made.Normals));
      }
      steps.next();
      FillGaps(ViewOf(made.Normals), ViewOf(directions));
      glue::LengthsFromFrame(
        made.Positions->GetPointer(0), 3 * size, map->Frame, "coordinates of the result");

      result->GetPointData()->AddArray(directions);
      made.passTo(result);
      if (processes.firstWith(isOwner && HasSupport(surface, map->Surface)) >= 0)
      {
        glue::AddNumbers(result->GetPointData(), SupportName,
          SupportAt(ViewOf(directions), surface, map->Surface));
      }
      result->GetCellData()->AddArray(made.degenerateCells(dense.Triangles, map->Surface, cuts));
      glue::AddNumber(result->GetFieldData(), "NumberOfDegeneratePatches",
        static_cast<long long>(map->Surface.numberOfDegeneratePatches()));
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
