#include "Register/SphericalTemplate.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/GeodesicSphere.h"
#include "Register/ConsistentRemesh.h"
#include "Register/SphereFeatures.h"
#include "Register/SphericalMorph.h"
#include "Sphere/SphereCoverage.h"
#include "Sphere/SphereOrientation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace conformal
{
namespace
{
using Registrations = std::vector<SphericalRegistrationResult>;

// Maximum number of third surfaces that decide about an ambiguous surface.
constexpr std::size_t NumberOfThirds = 3;
// A third surface decides if one correspondence is closer by this factor than the other.
constexpr double Closer = 0.5;

// Compute the mean distance between two maps of a surface, weighted by area.
double distanceOf(const Points& a, const Points& b, const Eigen::VectorXd& areas)
{
  return (a - b).rowwise().norm().dot(areas) / areas.sum();
}

void requireUsable(const std::vector<TemplateInput>& inputs)
{
  if (inputs.empty())
  {
    throw std::invalid_argument("there is no surface to register");
  }
  for (const TemplateInput& input : inputs)
  {
    const MappedMesh& mesh = input.Surface.Surface;
    double area = 0.0;
    for (Index r = 0; r < mesh.Triangles.rows(); ++r)
    {
      area += areaVector(mesh.Positions, mesh.Triangles, r).norm();
    }
    if (!(area > 0.0))
    {
      throw std::invalid_argument(
        input.Name + " has no area, or too little beside the other surfaces");
    }
    const Triangles turned = turnedToCoverOnce(
      mesh.SpherePositions, mesh.Triangles, "the map to the sphere of " + input.Name);
    const Index folds = countFlippedTriangles(mesh.SpherePositions, turned);
    if (folds > 0)
    {
      throw std::invalid_argument("the map to the sphere of " + input.Name + " has " +
        std::to_string(folds) + " flipped triangles as small as rounding");
    }
    if (input.Landmarks.size() != inputs.front().Landmarks.size())
    {
      throw std::invalid_argument(input.Name + " has " + std::to_string(input.Landmarks.size()) +
        " landmarks, but " + inputs.front().Name + " has " +
        std::to_string(inputs.front().Landmarks.size()) + "; all must have the same");
    }
  }
}

// Computation of a template: a mean shape with which all surfaces are registered.
class TemplateSearch
{
public:
  TemplateSearch(const std::vector<TemplateInput>& inputs, const std::vector<double>& weights,
    const SphericalTemplateOptions& options)
    : Inputs(inputs)
    , Weights(weights)
    , Options(options)
  {
    for (const TemplateInput& input : inputs)
    {
      Rows features = input.Surface.Features;
      const MappedMesh& mesh = input.Surface.Surface;
      normalizeFeatures(features, vertexAreas(mesh.Positions, mesh.Triangles));
      this->Features.push_back(std::move(features));
    }
  }

  // Register all surfaces with one of them. The registration of that surface is the identity.
  Registrations registeredWith(std::size_t one, const Run& run) const
  {
    return this->registered(this->Inputs[one].Surface, this->Inputs[one].Landmarks, one, run);
  }

  Registrations registeredWithMean(
    const RegisteredSurface& mean, const Registrations& last, const Run& run) const
  {
    return this->registered(mean, this->landmarksOf(mean, last), this->Inputs.size(), run);
  }

  // Average positions and features over all surfaces, aligned to the surface `front`.
  RegisteredSurface meanOf(
    const Registrations& registrations, std::size_t front, const Run& run) const
  {
    Steps steps(run, { 1.0, 1.0 });
    const std::vector<std::size_t> order = this->beginningWith(front);
    const ConsistentMeshes common =
      this->common(registrations, order, RemeshMeshType::Geodesic, steps.next());
    ShapeModesOptions shape;
    shape.Alignment = this->Options.Alignment;
    shape.NumberOfModes = 0;
    RegisteredSurface mean;
    mean.Surface.Positions =
      findShapeModes(common.Sphere.Triangles, common.Positions, shape, steps.next()).Mean;
    mean.Surface.Triangles = common.Sphere.Triangles;
    mean.Surface.SpherePositions = common.Sphere.Positions;
    mean.Features = this->meanFeatures(common.Weights, order);
    return mean;
  }

  // Average triangles over all surfaces, on a mesh whose sides are about equal on the surfaces.
  MappedMesh rigidMeanOf(
    const Registrations& registrations, std::size_t front, const Run& run) const
  {
    Steps steps(run, { 0.7, 0.1, 0.2 }); // mesh, alignment, mean
    const ConsistentMeshes common = this->common(
      registrations, this->beginningWith(front), RemeshMeshType::Adaptive, steps.next());
    ShapeModesOptions shape;
    shape.Alignment = this->Options.Alignment;
    shape.NumberOfModes = 0;
    const std::vector<Points> aligned =
      findShapeModes(common.Sphere.Triangles, common.Positions, shape, steps.next()).Aligned;
    MappedMesh mean;
    mean.Positions = rigidMean(common.Sphere, aligned, steps.next());
    mean.Triangles = common.Sphere.Triangles;
    mean.SpherePositions = common.Sphere.Positions;
    return mean;
  }

  // Find the surface closest to the mean of all shapes. If several surfaces are equally close up to
  // rounding, return the first of these surfaces.
  std::size_t closestToMean(const Registrations& registrations, const Run& run) const
  {
    Steps steps(run, { 1.0, 1.0 });
    const ConsistentMeshes common =
      this->common(registrations, this->beginningWith(0), RemeshMeshType::Geodesic, steps.next());
    ShapeModesOptions all;
    all.Alignment = this->Options.Alignment;
    all.NumberOfModes = static_cast<int>(this->Inputs.size());
    const ShapeModes modes =
      findShapeModes(common.Sphere.Triangles, common.Positions, all, steps.next());
    std::size_t closest = 0;
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < this->Inputs.size(); ++s)
    {
      double square = 0.0;
      for (std::size_t k = 0; k < modes.Modes.size(); ++k)
      {
        const double score = modes.Scores(static_cast<Index>(s), static_cast<Index>(k));
        square += modes.Explained[k] * score * score;
      }
      constexpr double closer = 1.0 - 1e-6;
      if (square < closer * minimum)
      {
        minimum = square;
        closest = s;
      }
    }
    return closest;
  }

private:
  Registrations registered(const RegisteredSurface& fixed, const std::vector<int>& landmarks,
    std::size_t own, const Run& run) const
  {
    Steps steps(run, std::vector<double>(this->Inputs.size() + 1, 1.0));
    Registrations result;
    for (std::size_t s = 0; s < this->Inputs.size(); ++s)
    {
      const Run part = steps.next();
      if (s == own)
      {
        result.emplace_back();
        result.back().SpherePositions = this->Inputs[s].Surface.Surface.SpherePositions;
        result.back().Stretch = 1.0;
        continue;
      }
      result.push_back(this->registeredOne(s, fixed, landmarks, part));
    }
    this->decide(result, own, steps.next());
    return result;
  }

  SphericalRegistrationResult registeredOne(std::size_t s, const RegisteredSurface& fixed,
    const std::vector<int>& landmarks, const Run& run) const
  {
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < landmarks.size(); ++i)
    {
      pairs.emplace_back(this->Inputs[s].Landmarks[i], landmarks[i]);
    }
    try
    {
      return registerSpheres(
        this->Inputs[s].Surface, fixed, pairs, this->Weights, this->Options.Registration, run);
    }
    catch (const NumericalFailure& failure)
    {
      throw NumericalFailure(this->Inputs[s].Name + ": " + failure.what());
    }
  }

  // Decide between the two best correspondences of each ambiguous surface by third surfaces.
  void decide(Registrations& result, std::size_t own, const Run& run) const
  {
    std::vector<std::size_t> ambiguous, thirds;
    for (std::size_t s = 0; s < result.size(); ++s)
    {
      if (result[s].IsAmbiguous)
      {
        ambiguous.push_back(s);
      }
      else if (s != own && result[s].NumberOfFolds == 0)
      {
        thirds.push_back(s);
      }
    }
    std::stable_sort(thirds.begin(), thirds.end(),
      [&](std::size_t a, std::size_t b) { return result[a].Stretch < result[b].Stretch; });
    thirds.resize(std::min(thirds.size(), NumberOfThirds));
    Steps steps(run, std::vector<double>(ambiguous.size() * thirds.size(), 1.0));
    for (const std::size_t s : ambiguous)
    {
      int balance = 0; // number of votes for the best correspondence, minus those for the second
      for (const std::size_t third : thirds)
      {
        balance += this->voteOf(third, s, result, steps.next());
      }
      if (balance < 0)
      {
        SphericalRegistrationResult second = std::move(result[s].Second.front());
        result[s] = std::move(second);
      }
      if (balance != 0)
      {
        result[s].IsAmbiguous = false;
        result[s].Second.clear();
      }
    }
  }

  // Register an ambiguous surface with a third surface, which has its new map. The result composes
  // both correspondences. Return 1 if it agrees with the best correspondence of the ambiguous
  // surface, -1 if it agrees with the second, and 0 if it is ambiguous itself or agrees with
  // neither.
  int voteOf(std::size_t third, std::size_t s, const Registrations& result, const Run& run) const
  {
    RegisteredSurface fixed = this->Inputs[third].Surface;
    fixed.Surface.SpherePositions = result[third].SpherePositions;
    const SphericalRegistrationResult composed =
      this->registeredOne(s, fixed, this->Inputs[third].Landmarks, run);
    if (composed.IsAmbiguous)
    {
      return 0;
    }
    const MappedMesh& mesh = this->Inputs[s].Surface.Surface;
    const Eigen::VectorXd areas = vertexAreas(mesh.Positions, mesh.Triangles);
    const double toBest = distanceOf(composed.SpherePositions, result[s].SpherePositions, areas);
    const double toSecond =
      distanceOf(composed.SpherePositions, result[s].Second.front().SpherePositions, areas);
    return toBest < Closer * toSecond ? 1 : toSecond < Closer * toBest ? -1 : 0;
  }

  // Find a distinct vertex of the mean for each landmark.
  std::vector<int> landmarksOf(const RegisteredSurface& mean, const Registrations& last) const
  {
    const Points& vertices = mean.Surface.SpherePositions;
    std::vector<char> isTaken(vertices.rows(), 0);
    std::vector<int> landmarks;
    for (std::size_t i = 0; i < this->Inputs.front().Landmarks.size(); ++i)
    {
      Vector3 place = Vector3::Zero();
      for (std::size_t s = 0; s < last.size(); ++s)
      {
        place += last[s].SpherePositions.row(this->Inputs[s].Landmarks[i]);
      }
      const Eigen::VectorXd closeness = vertices * place;
      int closest = 0; // vertex that is closest to the landmark and not yet used
      for (Index v = 0; v < vertices.rows(); ++v)
      {
        if (!isTaken[v] && (isTaken[closest] || closeness[v] > closeness[closest]))
        {
          closest = static_cast<int>(v);
        }
      }
      isTaken[closest] = 1;
      landmarks.push_back(closest);
    }
    return landmarks;
  }

  std::vector<std::size_t> beginningWith(std::size_t front) const
  {
    std::vector<std::size_t> order = { front };
    for (std::size_t s = 0; s < this->Inputs.size(); ++s)
    {
      if (s != front)
      {
        order.push_back(s);
      }
    }
    return order;
  }

  ConsistentMeshes common(const Registrations& registrations, const std::vector<std::size_t>& order,
    RemeshMeshType type, const Run& run) const
  {
    std::vector<MappedMesh> meshes;
    for (const std::size_t s : order)
    {
      meshes.push_back(this->Inputs[s].Surface.Surface);
      meshes.back().SpherePositions = registrations[s].SpherePositions;
    }
    ConsistentRemeshOptions remesh;
    remesh.MeshType = type;
    remesh.Frequency = this->Options.MeanFrequency;
    remesh.NumberOfPoints = geodesicSphereSize(this->Options.MeanFrequency);
    return remeshConsistently(meshes, remesh, run);
  }

  Rows meanFeatures(
    const std::vector<ResampleWeights>& weights, const std::vector<std::size_t>& order) const
  {
    Rows mean = Rows::Zero(weights.front().size(), this->Features.front().cols());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      const Rows& features = this->Features[order[k]];
      for (Index i = 0; i < mean.rows(); ++i)
      {
        for (Index j = weights[k].Offsets[i]; j < weights[k].Offsets[i + 1]; ++j)
        {
          mean.row(i) += weights[k].Weights[j] * features.row(weights[k].Ids[j]);
        }
      }
    }
    return mean / static_cast<double>(order.size());
  }

  const std::vector<TemplateInput>& Inputs;
  const std::vector<double>& Weights;
  const SphericalTemplateOptions& Options;
  std::vector<Rows> Features; // normalized
};

// Compute the change of the mean: root mean square displacement over root mean square radius.
double changeOf(const MappedMesh& mean, const MappedMesh& last)
{
  const Eigen::VectorXd areas = vertexAreas(mean.Positions, mean.Triangles);
  const Eigen::RowVector3d center = areas.transpose() * mean.Positions / areas.sum();
  const double size = areas.dot((mean.Positions.rowwise() - center).rowwise().squaredNorm());
  const double change = areas.dot((mean.Positions - last.Positions).rowwise().squaredNorm());
  return std::sqrt(change / size);
}
}

//------------------------------------------------------------------------------
SphericalTemplateResult findSphericalTemplate(const std::vector<TemplateInput>& inputs,
  const std::vector<double>& featureWeights, const SphericalTemplateOptions& options,
  const Run& run)
{
  requireUsable(inputs);
  const TemplateSearch search(inputs, featureWeights, options);
  const int rounds = inputs.size() > 1 ? options.MaximumNumberOfRounds : 0;
  std::vector<double> shares;
  for (int i = 0; i < 2 + rounds; ++i)
  {
    shares.insert(shares.end(), { 0.95, 0.05 }); // progress: registrations, then the mean
  }
  constexpr double last = 0.95; // progress at which the last mean is computed
  Steps steps(run.part(0.0, last), shares);

  SphericalTemplateResult result;
  result.Registrations = search.registeredWith(0, steps.next());
  const auto start = search.closestToMean(result.Registrations, steps.next());
  result.Start = static_cast<Index>(start);
  const Run again = steps.next();
  if (start != 0)
  {
    result.Registrations = search.registeredWith(start, again);
  }
  RegisteredSurface mean = search.meanOf(result.Registrations, start, steps.next());
  for (int i = 0; i < rounds; ++i)
  {
    result.Registrations = search.registeredWithMean(mean, result.Registrations, steps.next());
    RegisteredSurface next = search.meanOf(result.Registrations, start, steps.next());
    result.Changes.push_back(changeOf(next.Surface, mean.Surface));
    mean = std::move(next);
    if (result.Changes.back() <= options.Tolerance)
    {
      break;
    }
  }
  result.Mean = search.rigidMeanOf(result.Registrations, start, run.part(last, 1.0));
  run.report(1.0);
  return result;
}
}
