#include "vtkSphericalRegistration.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/RegisteredSurfaces.h"
#include "Glue/Run.h"
#include "Register/SphericalRegistration.h"
#include "Sphere/SphereOrientation.h"

#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkSphericalRegistration);

namespace
{
int VertexAt(const std::vector<int>& vertices, vtkIdType id, const char* which)
{
  if (id < 0 || id >= static_cast<vtkIdType>(vertices.size()) || vertices[id] < 0)
  {
    throw std::invalid_argument("a landmark refers to point " + std::to_string(id) + " of the " +
      which + " surface, which has " + std::to_string(vertices.size()) +
      " points; a landmark must be a point of one of its triangles");
  }
  return vertices[id];
}

// Return the vertex nearest to the position of a landmark. A landmark far from the surface is
// refused, since its nearest vertex is arbitrary.
int NearestVertex(vtkPolyData* data, const glue::SurfaceToRegister& surface,
  const double position[3], const std::string& name)
{
  constexpr double maximum = 0.05; // in multiples of the diagonal of the bounding box
  int nearest = 0;
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < surface.PointIds.size(); ++v)
  {
    double p[3];
    data->GetPoint(surface.PointIds[v], p);
    const double distance = std::hypot(p[0] - position[0], p[1] - position[1], p[2] - position[2]);
    if (distance < minimum)
    {
      minimum = distance;
      nearest = static_cast<int>(v);
    }
  }
  const double diagonal = data->GetLength();
  if (minimum > maximum * diagonal)
  {
    std::ostringstream text;
    text << "the landmark at (" << position[0] << ", " << position[1] << ", " << position[2]
         << ") is " << minimum << " from the nearest point of the " << name
         << " surface, but must be closer than 5 % of the diagonal of the bounding box, which is "
         << diagonal << "; use the coordinates of the surface";
    throw std::invalid_argument(text.str());
  }
  return nearest;
}

void AddTargets(vtkPointData* data, const conformal::Points& places,
  const glue::SurfaceToRegister& fixed, vtkPolyData* fixedData, const conformal::Run& run)
{
  std::vector<vtkIdType> cellIds;
  const conformal::Triangles cells = glue::ToTriangles(fixedData, cellIds);
  const conformal::MappedMesh& mesh = fixed.Core.Surface;
  // Triangles are matched to cells by their point ids, since some triangles may be reversed or left
  // out.
  std::vector<std::pair<std::array<vtkIdType, 3>, vtkIdType>> known(cellIds.size());
  for (std::size_t r = 0; r < cellIds.size(); ++r)
  {
    std::array<vtkIdType, 3> ids = { cells(r, 0), cells(r, 1), cells(r, 2) };
    std::sort(ids.begin(), ids.end());
    known[r] = { ids, cellIds[r] };
  }
  std::sort(known.begin(), known.end());
  const conformal::SphereGrid grid(
    { mesh.SpherePositions, conformal::turnedOutward(mesh.Triangles, mesh.SpherePositions) }, run);
  vtkNew<vtkIdTypeArray> targetCells, targetPoints;
  targetCells->SetName("TargetCellId");
  targetCells->SetNumberOfValues(places.rows());
  targetPoints->SetName("TargetPointIds");
  targetPoints->SetNumberOfComponents(3);
  targetPoints->SetNumberOfTuples(places.rows());
  conformal::Points weights(places.rows(), 3);
  for (conformal::Index i = 0; i < places.rows(); ++i)
  {
    const conformal::SphereWeights at = grid.weightsAt(places.row(i));
    std::array<vtkIdType, 3> ids{};
    for (int k = 0; k < 3; ++k)
    {
      ids[k] = fixed.PointIds[at.Ids[k]];
      targetPoints->SetComponent(i, k, static_cast<double>(ids[k]));
    }
    weights.row(i) = at.Weights;
    std::sort(ids.begin(), ids.end());
    const auto found = std::lower_bound(
      known.begin(), known.end(), std::make_pair(ids, std::numeric_limits<vtkIdType>::min()));
    targetCells->SetValue(i, found != known.end() && found->first == ids ? found->second : -1);
  }
  data->AddArray(targetCells);
  data->AddArray(targetPoints);
  glue::AddVectors(data, "TargetBarycentric", weights);
}

// Surfaces of a registration: the moving and the fixed one.
struct RegisteredPair
{
  vtkPolyData *Moving, *Fixed;
  glue::SurfaceToRegister From, To;
};

// Return the vertices of all landmarks: first landmarks given by point ids, then landmarks given by
// positions.
std::vector<std::pair<int, int>> LandmarksOf(const RegisteredPair& surfaces,
  const std::vector<std::pair<vtkIdType, vtkIdType>>& ids,
  const std::vector<std::array<double, 6>>& positions)
{
  std::vector<std::pair<int, int>> pairs;
  const std::vector<int> vertices = surfaces.From.vertices(),
                         fixedVertices = surfaces.To.vertices();
  pairs.reserve(ids.size() + positions.size());
  for (const auto& [id, fixedId] : ids)
  {
    pairs.emplace_back(VertexAt(vertices, id, "moving"), VertexAt(fixedVertices, fixedId, "fixed"));
  }
  for (const auto& position : positions)
  {
    if (!std::all_of(position.begin(), position.end(), [](double x) { return std::isfinite(x); }))
    {
      throw std::invalid_argument("the position of a landmark is not finite");
    }
    // Compilers evaluate arguments in different orders: the first error must not depend on it.
    const int from = NearestVertex(surfaces.Moving, surfaces.From, position.data(), "moving");
    const int to = NearestVertex(surfaces.Fixed, surfaces.To, position.data() + 3, "fixed");
    pairs.emplace_back(from, to);
  }
  std::set<int> used;
  for (const auto& pair : pairs)
  {
    if (!used.insert(pair.first).second)
    {
      throw std::invalid_argument("the point " +
        std::to_string(surfaces.From.PointIds[pair.first]) +
        " of the moving surface is in two landmarks");
    }
  }
  return pairs;
}

// Make the moving surface with a new map, and with targets on the fixed surface.
vtkSmartPointer<vtkPolyData> WithMap(const RegisteredPair& surfaces,
  const conformal::SphericalRegistrationResult& result, const conformal::Run& run)
{
  const conformal::Points places = glue::PlacesOfAll(surfaces.From, result.SpherePositions);
  auto registered = vtkSmartPointer<vtkPolyData>::New();
  registered->ShallowCopy(surfaces.Moving);
  glue::SetRegistration(registered, places, result);
  AddTargets(registered->GetPointData(), places, surfaces.To, surfaces.Fixed, run);
  return registered;
}

void Warn(vtkObject* self, const conformal::SphericalRegistrationResult& result,
  std::size_t numberOfLandmarks)
{
  if (!result.Second.empty())
  {
    vtkWarningWithObjectMacro(self,
      << "two correspondences are about equally good, such as head and tail of similar shape; the "
         "second one is on output port 1. Inspect both, or add "
      << (numberOfLandmarks > 0 ? "landmarks" : "a landmark"));
  }
  if (result.NumberOfFolds > 0)
  {
    vtkWarningWithObjectMacro(self,
      << result.NumberOfFolds << " triangles of the map are flipped, since the transform is not "
      << "exact on thin triangles; set SpaceOfTransforms to Diffeomorphic");
  }
  if (result.NumberOfUnmetLandmarks > 0)
  {
    vtkWarningWithObjectMacro(self,
      << result.NumberOfUnmetLandmarks << " of " << numberOfLandmarks
      << " landmarks cannot be matched without folds of the map; the largest remaining distance is "
      << result.LandmarkError
      << " on the unit sphere. Check that landmarks have the same order on both surfaces, and that "
         "left and right are not swapped");
  }
}
}

//------------------------------------------------------------------------------
vtkSphericalRegistration::vtkSphericalRegistration()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::SetFixedConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::SetFixedData(vtkPolyData* fixed)
{
  this->SetInputData(1, fixed);
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::AddLandmark(vtkIdType pointId, vtkIdType fixedPointId)
{
  this->Landmarks.emplace_back(pointId, fixedPointId);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::RemoveAllLandmarks()
{
  if (!this->Landmarks.empty())
  {
    this->Landmarks.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::AddLandmarkPosition(
  double x, double y, double z, double fixedX, double fixedY, double fixedZ)
{
  this->Positions.push_back({ x, y, z, fixedX, fixedY, fixedZ });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::RemoveAllLandmarkPositions()
{
  if (!this->Positions.empty())
  {
    this->Positions.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::AddFeature(const char* name, double weight)
{
  this->Features.emplace_back(name ? name : "", weight);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::RemoveAllFeatures()
{
  if (!this->Features.empty())
  {
    this->Features.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkSphericalRegistration::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto moving = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto fixed = glue::Held(vtkPolyData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkPolyData* secondOutput = vtkPolyData::GetData(outputVector, 1);
  const auto landmarks = this->Landmarks;
  const auto positions = this->Positions;
  const auto features = this->Features;
  conformal::SphericalRegistrationOptions options;
  options.Space = static_cast<conformal::SpaceOfTransforms>(this->SpaceOfTransforms);
  options.ShapeWeight = this->ShapeWeight;
  options.StretchWeight = this->StretchWeight;
  options.Frequency = this->Frequency;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(
            this, moving, "the moving surface is empty; there is nothing to register") ||
        glue::IsEmptyInput(this, fixed, "the fixed surface is empty; nothing was registered"))
      {
        return;
      }
      const std::vector<double> weights = glue::WeightsOf(features);
      // Relative costs of reading each surface, registration and targets.
      conformal::Steps steps(glue::RunOf(this), { 0.02, 0.02, 0.92, 0.04 });
      RegisteredPair pair{ moving, fixed, {}, {} };
      pair.From =
        glue::ToSurfaceToRegister(this, moving, features, glue::FrameOf({ moving }), steps.next());
      pair.To =
        glue::ToSurfaceToRegister(this, fixed, features, glue::FrameOf({ fixed }), steps.next());
      const auto vertices = LandmarksOf(pair, landmarks, positions);
      const conformal::SphericalRegistrationResult result = conformal::registerSpheres(
        pair.From.Core, pair.To.Core, vertices, weights, options, steps.next());
      const conformal::Run locating = steps.next();
      const auto registered = WithMap(pair, result, locating);
      const auto second = result.Second.empty() ? vtkSmartPointer<vtkPolyData>::New()
                                                : WithMap(pair, result.Second.front(), {});
      Warn(this, result, vertices.size());
      output->ShallowCopy(registered);
      secondOutput->ShallowCopy(second);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalRegistration::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const spaces[] = { "Rotation", "Moebius", "Diffeomorphic" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SpaceOfTransforms: " << spaces[this->SpaceOfTransforms] << "\n";
  os << indent << "ShapeWeight: " << this->ShapeWeight << "\n";
  os << indent << "StretchWeight: " << this->StretchWeight << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "NumberOfLandmarks: " << this->Landmarks.size() << "\n";
  os << indent << "NumberOfLandmarkPositions: " << this->Positions.size() << "\n";
  os << indent << "NumberOfFeatures: " << this->Features.size() << "\n";
}
