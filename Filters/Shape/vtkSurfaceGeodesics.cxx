#include "vtkSurfaceGeodesics.h"

#include "Base/AllColumns.h"
#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Geodesics/ExactDistances.h"
#include "Geodesics/GeodesicPath.h"
#include "Geodesics/HeatDistances.h"
#include "Glue/Arrays.h"
#include "Glue/Checks.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Mesh/MeshTopology.h"
#include "Search/PointTree.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

vtkStandardNewMacro(vtkSurfaceGeodesics);

namespace
{
// Surface whose vertices are its points.
conformal::Mesh ToMesh(vtkPolyData* surface, const conformal::CoordinateFrame& frame)
{
  conformal::Mesh mesh;
  mesh.Positions = glue::ToPoints(surface->GetPoints(), frame);
  if (!mesh.Positions.allFinite())
  {
    throw std::invalid_argument("the surface has points that are not finite; remove them");
  }
  const conformal::Triangles all = glue::ToTriangles(surface);
  mesh.Triangles.resize(all.rows(), 3);
  conformal::Index kept = 0;
  for (conformal::Index t = 0; t < all.rows(); ++t)
  {
    if (all(t, 0) != all(t, 1) && all(t, 1) != all(t, 2) && all(t, 2) != all(t, 0))
    {
      mesh.Triangles.row(kept++) = all.row(t);
    }
  }
  mesh.Triangles.conservativeResize(kept, 3);
  if (kept == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  return mesh;
}

// List of distinct vertices, in the sequence in which they are added.
class VertexList
{
public:
  /// @param used  vertices that belong to triangles
  VertexList(const conformal::Mesh& mesh, const std::vector<int>& used)
    : Mesh(mesh)
    , Used(used)
    , IsListed(mesh.Positions.rows(), 0)
  {
  }

  void AddNearest(vtkPointSet* picked, const conformal::CoordinateFrame& frame, int port)
  {
    if (!picked || picked->GetNumberOfPoints() == 0)
    {
      return;
    }
    const conformal::Points positions = glue::ToPoints(picked->GetPoints(), frame);
    const conformal::Points used = this->Mesh.Positions(this->Used, conformal::AllColumns);
    const conformal::PointTree tree(used);
    for (conformal::Index i = 0; i < positions.rows(); ++i)
    {
      if (!positions.row(i).allFinite())
      {
        throw std::invalid_argument("point " + std::to_string(i) + " of input port " +
          std::to_string(port) + " is not finite; remove it");
      }
      this->Add(this->Used[tree.nearest(positions.row(i)).Id]);
    }
  }

  void AddIds(const std::vector<vtkIdType>& ids)
  {
    for (const vtkIdType id : ids)
    {
      if (!std::binary_search(this->Used.begin(), this->Used.end(), id))
      {
        throw std::invalid_argument(
          "source " + std::to_string(id) + " is not the id of a point of the surface's triangles");
      }
      this->Add(static_cast<int>(id));
    }
  }

  void AddMarked(vtkPolyData* surface, const std::string& name)
  {
    if (name.empty())
    {
      return;
    }
    vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
    if (!array || array->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument(
        "the surface has no point array " + name + " with 1 component; set SourceArrayName");
    }
    for (const int v : this->Used)
    {
      const double value = array->GetComponent(v, 0);
      if (value != 0.0 && !std::isnan(value))
      {
        this->Add(v);
      }
    }
  }

  // Add the point that is farthest from the center.
  void AddOuter()
  {
    const conformal::Points used = this->Mesh.Positions(this->Used, conformal::AllColumns);
    const Eigen::RowVector3d center = used.colwise().mean();
    conformal::Index farthest = 0;
    (used.rowwise() - center).rowwise().squaredNorm().maxCoeff(&farthest);
    this->Add(this->Used[farthest]);
  }

  const std::vector<int>& Ids() const { return this->List; }

private:
  void Add(int vertex)
  {
    if (!this->IsListed[vertex])
    {
      this->IsListed[vertex] = 1;
      this->List.push_back(vertex);
    }
  }

  const conformal::Mesh& Mesh;
  const std::vector<int>& Used;
  std::vector<char> IsListed;
  std::vector<int> List;
};

// If there are no sources, add the first of the farthest points, and decrease the number of missing
// ones.
void RequireSources(VertexList& list, int& missing)
{
  if (list.Ids().empty() && missing > 0)
  {
    list.AddOuter();
    --missing;
  }
  if (list.Ids().empty())
  {
    throw std::invalid_argument("there are no sources; add points at input port 1, or set "
                                "SourceArrayName or NumberOfFarthestPoints");
  }
}

void AddDistances(vtkPointData* data, const conformal::NearestSources& nearest,
  const std::vector<int>& sources, const conformal::CoordinateFrame& frame)
{
  const conformal::Index size = nearest.Distances.size();
  std::vector<double> lengths(nearest.Distances.begin(), nearest.Distances.end());
  glue::LengthsFromFrame(lengths.data(), size, frame, "the distances");
  const vtkNew<vtkIdTypeArray> ids;
  ids->SetName("NearestSource");
  ids->SetNumberOfValues(size);
  for (conformal::Index v = 0; v < size; ++v)
  {
    const int position = nearest.Positions[v];
    lengths[v] = position >= 0 ? lengths[v] : -1.0;
    ids->SetValue(v, position >= 0 ? sources[position] : -1);
  }
  glue::AddNumbers(data, "GeodesicDistance", lengths);
  data->AddArray(ids);
}

void SetSources(vtkPolyData* output, vtkPolyData* surface, const std::vector<int>& sources)
{
  const vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  const vtkNew<vtkIdTypeArray> ids;
  ids->SetName("SourceId");
  output->AllocateExact(static_cast<vtkIdType>(sources.size()), 1);
  for (const int source : sources)
  {
    const vtkIdType id = points->InsertNextPoint(surface->GetPoint(source));
    output->InsertNextCell(VTK_VERTEX, 1, &id);
    ids->InsertNextValue(source);
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(ids);
}

// Follow ways along edges, and straighten the path. If the ways do not lead to a source, or the
// vertex is a source, the path is empty.
std::vector<conformal::PathPoint> StraightPath(const conformal::PathStraightener& surface,
  int vertex, const std::vector<int>& ways, const conformal::Run& run)
{
  std::vector<int> vertices = { vertex };
  while (ways[vertices.back()] >= 0 && ways[vertices.back()] != vertices.back())
  {
    vertices.push_back(ways[vertices.back()]);
  }
  return vertices.size() < 2 || ways[vertices.back()] < 0 ? std::vector<conformal::PathPoint>()
                                                          : surface.straighten(vertices, run);
}

// Paths from targets to sources, as polylines.
class PathLines
{
public:
  explicit PathLines(const conformal::Points& positions)
    : Positions(positions)
  {
  }

  void Add(const std::vector<conformal::PathPoint>& path)
  {
    this->Lines->InsertNextCell(static_cast<int>(path.size()));
    for (const conformal::PathPoint& point : path)
    {
      this->Lines->InsertCellPoint(static_cast<vtkIdType>(this->Places.size()));
      this->Places.push_back(positionOf(point, this->Positions));
    }
    this->Lengths.push_back(lengthOf(path, this->Positions));
    this->Targets->InsertNextValue(path.front().First);
    this->Sources->InsertNextValue(path.back().First);
  }

  void CopyTo(vtkPolyData* output, const conformal::CoordinateFrame& frame) const
  {
    conformal::Points places(static_cast<conformal::Index>(this->Places.size()), 3);
    for (conformal::Index i = 0; i < places.rows(); ++i)
    {
      places.row(i) = this->Places[i];
    }
    glue::SetPoints(output, places, frame);
    output->SetLines(this->Lines);
    this->Targets->SetName("TargetId");
    this->Sources->SetName("SourceId");
    output->GetCellData()->AddArray(this->Targets);
    output->GetCellData()->AddArray(this->Sources);
    glue::AddLengths(output->GetCellData(), "PathLength", this->Lengths, frame);
  }

private:
  const conformal::Points& Positions;
  std::vector<conformal::Vector3> Places;
  std::vector<double> Lengths;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkIdTypeArray> Targets, Sources;
};

using FindPath =
  std::function<std::vector<conformal::PathPoint>(int target, const conformal::Run& run)>;

// Find paths from targets to sources. Empty paths are left out.
void SetPaths(vtkPolyData* output, const conformal::Mesh& mesh, const std::vector<int>& targets,
  const FindPath& findPath, const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  PathLines lines(mesh.Positions);
  conformal::Steps steps(run, std::vector<double>(targets.size(), 1.0));
  for (const int target : targets)
  {
    const std::vector<conformal::PathPoint> path = findPath(target, steps.next());
    if (path.size() > 1)
    {
      lines.Add(path);
    }
  }
  run.report(1.0);
  if (!targets.empty())
  {
    lines.CopyTo(output, frame);
  }
}

// Find paths that are locally shortest, given distances from sources.
FindPath LocallyShortest(
  const conformal::Mesh& mesh, const std::vector<int>& sources, const Eigen::VectorXd& distances)
{
  const auto surface = std::make_shared<conformal::PathStraightener>(mesh);
  return
    [&mesh, surface, along = conformal::pathsAlongEdges(mesh, sources).Ways,
      downhill = conformal::waysDownhill(mesh, distances)](int target, const conformal::Run& run)
  {
    const auto first = StraightPath(*surface, target, along, run.part(0.0, 0.5)),
               second = StraightPath(*surface, target, downhill, run.part(0.5, 1.0));
    const bool isSecond = !second.empty() &&
      (first.empty() || lengthOf(second, mesh.Positions) < lengthOf(first, mesh.Positions));
    return isSecond ? second : first;
  };
}

// Sources with farthest points, distances from the nearest source, and paths to it.
struct Measured
{
  std::vector<int> Sources;
  conformal::NearestSources Nearest;
  FindPath PathFrom;
};

// Measure distances, in three steps. Farthest points are found by the heat method.
Measured MeasureWithoutAdvice(const conformal::Mesh& mesh, const std::vector<int>& given,
  int missing, bool isExact, conformal::Steps& steps)
{
  Measured result{ given, {}, {} };
  std::optional<conformal::HeatDistances> heat;
  const conformal::Run factoring = steps.next(), choosing = steps.next(), measuring = steps.next();
  if (!isExact || missing > 0)
  {
    heat.emplace(mesh, factoring);
    conformal::addFarthestVertices(*heat, missing, result.Sources, choosing);
  }
  if (isExact)
  {
    const auto exact = std::make_shared<conformal::ExactDistances>(mesh, result.Sources, measuring);
    result.Nearest = exact->nearestSources();
    result.PathFrom = [exact, positions = result.Nearest.Positions](
                        int target, const conformal::Run&) {
      return positions[target] >= 0 ? exact->pathFrom(target) : std::vector<conformal::PathPoint>();
    };
  }
  else
  {
    result.Nearest = heat->nearestSources(result.Sources);
  }
  return result;
}

// Measure distances. If the heat method fails, state what to do.
Measured Measure(const conformal::Mesh& mesh, const std::vector<int>& given, int missing,
  bool isExact, conformal::Steps& steps)
{
  try
  {
    return MeasureWithoutAdvice(mesh, given, missing, isExact, steps);
  }
  catch (const conformal::NumericalFailure& failure)
  {
    const std::string advice = isExact ? "set NumberOfFarthestPoints to 0"
      : missing > 0                    ? "set NumberOfFarthestPoints to 0, and Method to EXACT"
                                       : "set Method to EXACT";
    throw conformal::NumericalFailure(
      std::string("the heat method failed: ") + failure.what() + "; " + advice);
  }
}
}

//------------------------------------------------------------------------------
vtkSurfaceGeodesics::vtkSurfaceGeodesics()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesics::SetSourcesConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesics::SetSourcesData(vtkPointSet* sources)
{
  this->SetInputData(1, sources);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesics::SetTargetsConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(2, algOutput);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesics::SetTargetsData(vtkPointSet* targets)
{
  this->SetInputData(2, targets);
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesics::AddSourceId(vtkIdType id)
{
  this->SourceIds.push_back(id);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesics::RemoveAllSourceIds()
{
  if (!this->SourceIds.empty())
  {
    this->SourceIds.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSurfaceGeodesics::GetSources()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSurfaceGeodesics::GetPaths()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesics::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkPointSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0 ? 1 : 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceGeodesics::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto picked = glue::Held(vtkPointSet::GetData(inputVector[1]));
  const auto starts = glue::Held(vtkPointSet::GetData(inputVector[2]));
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the output is empty"))
      {
        return;
      }
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface });
      const conformal::Mesh mesh = ToMesh(surface, frame);
      const std::vector<int> used = conformal::usedVertices(mesh.Triangles, mesh.Positions.rows());
      VertexList targets(mesh, used), given(mesh, used);
      targets.AddNearest(starts, frame, 2);
      given.AddNearest(picked, frame, 1);
      given.AddIds(this->SourceIds);
      given.AddMarked(surface, this->SourceArrayName);
      int missing = this->NumberOfFarthestPoints;
      RequireSources(given, missing);
      const bool isExact = this->Method == EXACT;
      // Relative costs of the factorization, the farthest points, the distances and the paths.
      conformal::Steps steps(glue::RunOf(this),
        { isExact && missing == 0 ? 0.0 : 1.0, 0.1 * missing, isExact ? 5.0 : 0.15,
          0.002 * static_cast<double>(targets.Ids().size()) });
      Measured measured = Measure(mesh, given.Ids(), missing, isExact, steps);
      if (!isExact && !targets.Ids().empty())
      {
        measured.PathFrom = LocallyShortest(mesh, measured.Sources, measured.Nearest.Distances);
      }
      const vtkNew<vtkPolyData> result, vertices, paths;
      result->ShallowCopy(surface);
      AddDistances(result->GetPointData(), measured.Nearest, measured.Sources, frame);
      SetSources(vertices, surface, measured.Sources);
      SetPaths(paths, mesh, targets.Ids(), measured.PathFrom, frame, steps.next());
      vtkPolyData::GetData(outputVector, 0)->ShallowCopy(result);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(vertices);
      vtkPolyData::GetData(outputVector, 2)->ShallowCopy(paths);
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceGeodesics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << (this->Method == EXACT ? "Exact" : "Heat") << "\n";
  os << indent << "NumberOfSourceIds: " << this->SourceIds.size() << "\n";
  os << indent << "SourceArrayName: " << this->SourceArrayName << "\n";
  os << indent << "NumberOfFarthestPoints: " << this->NumberOfFarthestPoints << "\n";
}
