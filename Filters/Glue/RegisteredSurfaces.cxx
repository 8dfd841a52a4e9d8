#include "Glue/RegisteredSurfaces.h"

#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/SphereImages.h"
#include "Sphere/SphereOrientation.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <cmath>
#include <stdexcept>

namespace glue
{
namespace
{
conformal::Rows FeaturesOf(
  vtkPolyData* surface, const FeatureList& features, const std::vector<vtkIdType>& ids)
{
  conformal::Rows result(
    static_cast<conformal::Index>(ids.size()), static_cast<conformal::Index>(features.size()));
  for (std::size_t k = 0; k < features.size(); ++k)
  {
    const std::string& name = features[k].first;
    vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
    if (!array || array->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument(
        "every surface must have the feature \"" + name + "\" as a point array of 1 component");
    }
    for (std::size_t v = 0; v < ids.size(); ++v)
    {
      result(v, k) = array->GetComponent(ids[v], 0);
    }
    if (!result.col(k).allFinite())
    {
      throw std::invalid_argument("some values of the feature \"" + name + "\" are not finite");
    }
    // Divide the feature by its maximum, so that squares do not overflow.
    const double maximum = result.col(k).cwiseAbs().maxCoeff();
    if (maximum > 0.0)
    {
      result.col(k) /= maximum;
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
std::vector<int> SurfaceToRegister::vertices() const
{
  std::vector<int> vertices(this->Map.rows(), -1);
  for (std::size_t v = 0; v < this->PointIds.size(); ++v)
  {
    vertices[this->PointIds[v]] = static_cast<int>(v);
  }
  return vertices;
}

//------------------------------------------------------------------------------
SurfaceToRegister ToSurfaceToRegister(vtkObject* self, vtkPolyData* surface,
  const FeatureList& features, const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  ClosedMesh closed = ToClosedMesh(self, surface, frame, run, Topology::Closed, MeshUse::Copy);
  if (closed.InsideOut)
  {
    closed.Triangles.col(1).swap(closed.Triangles.col(2));
  }
  SurfaceToRegister result;
  result.Map = ToSpherePositions(surface);
  conformal::MappedMesh& mesh = result.Core.Surface;
  mesh.Positions = closed.Positions;
  mesh.Triangles = closed.Triangles;
  mesh.SpherePositions.resize(mesh.Positions.rows(), 3);
  for (conformal::Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    mesh.SpherePositions.row(v) = result.Map.row(closed.PointIds[v]);
  }
  result.Core.Features = FeaturesOf(surface, features, closed.PointIds);
  result.PointIds = std::move(closed.PointIds);
  return result;
}

//------------------------------------------------------------------------------
std::vector<double> WeightsOf(const FeatureList& features)
{
  std::vector<double> weights;
  for (const auto& [name, weight] : features)
  {
    if (!std::isfinite(weight) || weight < 0.0)
    {
      throw std::invalid_argument("the weight of the feature \"" + name + "\" is " +
        std::to_string(weight) + ", but must be finite and at least 0");
    }
    weights.push_back(weight);
  }
  return weights;
}

//------------------------------------------------------------------------------
std::map<double, int> LandmarksOf(
  vtkPolyData* surface, const SurfaceToRegister& registered, const std::string& arrayName)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(arrayName.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("there is no point array \"" + arrayName +
      "\" of 1 component; set LandmarkArrayName to the name of one, or to an empty one");
  }
  const std::vector<int> vertices = registered.vertices();
  std::map<double, int> landmarks;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double number = array->GetComponent(i, 0);
    if (!std::isfinite(number))
    {
      throw std::invalid_argument("the landmark array is not finite at point " + std::to_string(i));
    }
    if (number <= 0.0)
    {
      continue;
    }
    if (vertices[i] < 0)
    {
      throw std::invalid_argument("the landmark at point " + std::to_string(i) +
        " belongs to no triangle; a landmark must be a point of one");
    }
    if (!landmarks.emplace(number, vertices[i]).second)
    {
      throw std::invalid_argument("two points have the landmark " + vtkVariant(number).ToString() +
        "; the second is point " + std::to_string(i));
    }
  }
  return landmarks;
}

//------------------------------------------------------------------------------
conformal::Points PlacesOfAll(const SurfaceToRegister& moving, const conformal::Points& moved)
{
  conformal::Points places = moving.Map;
  if (static_cast<conformal::Index>(moving.PointIds.size()) < places.rows())
  {
    const conformal::MappedMesh& mesh = moving.Core.Surface;
    const conformal::Triangles outward =
      conformal::turnedOutward(mesh.Triangles, mesh.SpherePositions);
    places = conformal::sampleAt(
      conformal::SphereGrid({ mesh.SpherePositions, outward }), moved, moving.Map);
    places.rowwise().normalize();
  }
  for (std::size_t v = 0; v < moving.PointIds.size(); ++v)
  {
    places.row(moving.PointIds[v]) = moved.row(static_cast<conformal::Index>(v));
  }
  return places;
}

//------------------------------------------------------------------------------
void SetRegistration(vtkPolyData* surface, const conformal::Points& places,
  const conformal::SphericalRegistrationResult& result)
{
  ReplaceSpherePositions(surface, places);
  RemoveDistortions(surface);
  vtkFieldData* data = surface->GetFieldData();
  AddNumber(data, "RegistrationStretch", result.Stretch);
  AddNumber(data, "LandmarkError", result.LandmarkError);
  const double agreement[] = { result.AgreementBefore, result.AgreementAfter };
  AddTuple(data, "FeatureAgreement", agreement, 2);
  AddNumber(data, "NumberOfFolds", static_cast<long long>(result.NumberOfFolds));
  AddNumber(data, "Ambiguous", static_cast<long long>(result.IsAmbiguous));
}
}
