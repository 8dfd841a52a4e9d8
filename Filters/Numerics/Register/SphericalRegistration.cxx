#include "Register/SphericalRegistration.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Measure/SphericalAlignment.h"
#include "Register/RegistrationQuality.h"
#include "Register/SphereDeformation.h"
#include "Sphere/LandmarkFlow.h"
#include "Sphere/SphereOrientation.h"
#include "SphereMap/FlipRepair.h"
#include "SphereMap/GlobalConformalMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace conformal
{
namespace
{
constexpr double ProximityWeight = 1.0; // weight of the proximities of landmarks

// Repair of flipped triangles in a map of a mesh.
class FoldRepair
{
public:
  explicit FoldRepair(const Mesh& mesh)
    : Surface(mesh)
    , Strings(harmonicStrings(mesh.Positions, mesh.Triangles).Strings)
    , Rings(mesh.Triangles, mesh.Positions.rows())
    , Shapes(mesh.Positions, mesh.Triangles)
  {
  }

  // Return whether no triangle is flipped.
  bool operator()(Points& places) const
  {
    std::vector<Vector3> positions = toVectors(places);
    repairFlips(positions, this->Surface.Positions, this->Surface.Triangles, this->Strings,
      this->Rings, this->Shapes);
    places = toPoints(positions);
    return countFlippedTriangles(places, this->Surface.Triangles) == 0;
  }

private:
  const Mesh& Surface;
  EdgeWeights Strings;
  VertexRings Rings;
  BoundedTriangles Shapes;
};

// Move the moving surface's vertices by the deformation, or by the largest fraction of it that
// flips no triangle.
Points carriedWithoutFolds(const PreparedSurface& moving, const SphereDeformation& deformation,
  const FoldRepair& repair, double maximum)
{
  const MappedMesh& mesh = moving.mesh();
  for (double fraction = maximum; fraction > 0.1; fraction *= 0.7)
  {
    Points places = deformation.placesOf(mesh.SpherePositions, fraction);
    if (countFlippedTriangles(places, mesh.Triangles) == 0 || repair(places))
    {
      return places;
    }
  }
  const Points turned = deformation.placesOf(mesh.SpherePositions, 0.0);
  // If even fraction 0 flips triangles, these triangles are as small as rounding errors.
  return countFlippedTriangles(turned, mesh.Triangles) == 0 ? turned : mesh.SpherePositions;
}

// Landmarks: vertices of the moving surface, their positions, and their targets.
struct LandmarkPairs
{
  LandmarkPairs(
    const std::vector<std::pair<int, int>>& landmarks, const Points& moving, const Points& fixed)
    : Sources(static_cast<Index>(landmarks.size()), 3)
    , Targets(static_cast<Index>(landmarks.size()), 3)
  {
    for (Index i = 0; i < this->count(); ++i)
    {
      this->Ids.push_back(landmarks[i].first);
      this->Sources.row(i) = moving.row(landmarks[i].first);
      this->Targets.row(i) = fixed.row(landmarks[i].second);
      this->Pairs.push_back({ this->Sources.row(i), this->Targets.row(i) });
    }
  }

  Index count() const { return this->Sources.rows(); }

  MoebiusTransform transform(AlignmentKind kind) const
  {
    return alignSpheres(this->Sources, this->Targets, Eigen::VectorXd::Ones(this->count()), kind)
      .Transform;
  }

  // Compute the maximum distance between a landmark and its target.
  double errorOf(const Points& places) const
  {
    double error = 0.0;
    for (Index i = 0; i < this->count(); ++i)
    {
      error = std::max(error, (places.row(this->Ids[i]) - this->Targets.row(i)).norm());
    }
    return error;
  }

  std::vector<int> Ids;
  Points Sources, Targets;
  std::vector<SpherePair> Pairs;
};

// Move the moving surface's vertices by the deformation, then to the landmarks. If the landmarks
// cannot be reached after the whole deformation, and the registration `isRepeated`, try smaller
// fractions of the deformation.
Points carriedToLandmarks(const PreparedSurface& moving, const SphereDeformation& deformation,
  const LandmarkPairs& landmarks, bool isRepeated, Index& numberOfUnmet, const Run& run)
{
  const FoldRepair repair(moving.mesh());
  LandmarkFlowOptions flowing;
  // The deformation brings landmarks near their targets. If more steps are necessary, landmarks are
  // blocked.
  flowing.MaximumNumberOfSteps = 100;
  flowing.Repair = repair;
  LandmarkFlowResult flow;
  Points best;
  for (const double maximumFraction : { 1.0, 0.5, 0.0 })
  {
    const Run part = run.part(0.5 * (1.0 - maximumFraction), 0.5 * (1.5 - maximumFraction));
    Points places = carriedWithoutFolds(moving, deformation, repair, maximumFraction);
    const LandmarkFlowResult found = flowToLandmarks(
      moving.mesh().Triangles, landmarks.Ids, landmarks.Targets, places, flowing, part);
    if (maximumFraction == 1.0 || found.Error < flow.Error)
    {
      flow = found;
      best = std::move(places);
    }
    if (flow.NumberOfUnmet == 0 || !isRepeated)
    {
      break;
    }
  }
  numberOfUnmet = flow.NumberOfUnmet;
  return best;
}

// Transform the map of the moving surface. The transform is fitted to the landmarks. If there are
// no landmarks, it is fitted to a deformation of the coarsest sphere.
Points transformed(const PreparedSurface& moving, const LandmarkPairs& landmarks,
  const SphereDeformation& deformation, AlignmentKind kind, const Run& run)
{
  MoebiusTransform transform;
  if (landmarks.count() > 0)
  {
    transform = landmarks.transform(kind);
  }
  else
  {
    const Points positions = moving.positionsAt(deformation.rest().Positions);
    transform = alignSpheres(deformation.rest().Positions, deformation.places(),
      vertexAreas(positions, deformation.rest().Triangles), kind, run)
                  .Transform;
  }
  Points places = moving.mesh().SpherePositions;
  transform.applyTo(places);
  // A Moebius transform maps great circles to other circles. The triangles, whose edges are great
  // circles, can therefore fold if they are thin.
  if (countFlippedTriangles(places, moving.mesh().Triangles) > 0)
  {
    FoldRepair(moving.mesh())(places);
  }
  return places;
}

std::vector<int> idsOf(const std::vector<std::pair<int, int>>& landmarks, bool ofMoving)
{
  std::vector<int> ids;
  ids.reserve(landmarks.size());
  for (const auto& [moving, fixed] : landmarks)
  {
    ids.push_back(ofMoving ? moving : fixed);
  }
  return ids;
}

// Return the weights of all features but proximities: first the features of the shape if they are
// used, then the given features.
std::vector<double> weightsOf(double shapeWeight, const std::vector<double>& featureWeights)
{
  std::vector<double> weights = shapeFeatureWeights();
  for (double& weight : weights)
  {
    weight *= shapeWeight;
  }
  weights.resize(shapeWeight > 0.0 ? weights.size() : 0);
  weights.insert(weights.end(), featureWeights.begin(), featureWeights.end());
  return weights;
}

std::vector<double> withPositionsAndProximities(std::vector<double> weights,
  const SphericalRegistrationOptions& options, const PreparedSurface& surface)
{
  const double shapeWeight = options.ShapeWeight;
  weights.insert(weights.end(), options.PositionWeight > 0.0 ? 3 : 0, options.PositionWeight);
  weights.resize(weights.size() + surface.numberOfProximities(), shapeWeight * ProximityWeight);
  return weights;
}

SphericalRegistrationResult registerOnce(const RegisteredSurface& moving,
  const RegisteredSurface& fixed, const std::vector<std::pair<int, int>>& landmarks,
  const std::vector<double>& featureWeights, const SphericalRegistrationOptions& options,
  bool isRepeated, const Run& run)
{
  const bool diffeomorphic = options.Space == SpaceOfTransforms::Diffeomorphic;
  const bool withShape = options.ShapeWeight > 0.0, withPositions = options.PositionWeight > 0.0;
  // Progress: both surfaces, the deformation, and the vertices with landmarks and measures.
  Steps steps(run, { 0.15, 0.15, 0.55, 0.15 });
  const PreparedSurface from(
    moving, idsOf(landmarks, true), withShape, withPositions, "moving", steps.next());
  const PreparedSurface to(
    fixed, idsOf(landmarks, false), withShape, withPositions, "fixed", steps.next());
  const LandmarkPairs pairs(landmarks, from.mesh().SpherePositions, to.mesh().SpherePositions);
  const std::vector<double> weights = weightsOf(options.ShapeWeight, featureWeights);
  const AlignmentKind kind =
    options.Space == SpaceOfTransforms::Moebius ? AlignmentKind::Moebius : AlignmentKind::Rotation;
  FoundDeformations found;
  const Run searching = steps.next();
  if (diffeomorphic || landmarks.empty())
  {
    DeformationOptions deforming;
    deforming.FeatureWeights = withPositionsAndProximities(weights, options, from);
    deforming.StretchWeight = options.StretchWeight;
    deforming.StartFromMaps = options.StartFromMaps;
    deforming.Frequency = diffeomorphic ? options.Frequency : CoarsestFrequency;
    found = findDeformations(from, to, pairs.Pairs, deforming, searching);
  }
  const double agreementBefore = featureAgreement(from, to, from.mesh().SpherePositions, weights);
  const auto resultOf = [&](const SphereDeformation& deformation, const Run& part)
  {
    SphericalRegistrationResult result;
    result.SpherePositions = diffeomorphic ? carriedToLandmarks(from, deformation, pairs,
                                               isRepeated, result.NumberOfUnmetLandmarks, part)
                                           : transformed(from, pairs, deformation, kind, part);
    result.Stretch = registrationStretch(from, to, result.SpherePositions, 2 * options.Frequency);
    result.AgreementBefore = agreementBefore;
    result.AgreementAfter = featureAgreement(from, to, result.SpherePositions, weights);
    result.LandmarkError = pairs.errorOf(result.SpherePositions);
    result.NumberOfFolds = countFlippedTriangles(result.SpherePositions, from.mesh().Triangles);
    result.IsAmbiguous = !found.Second.empty();
    if (to.isMirrored())
    {
      result.SpherePositions.col(0) *= -1.0;
    }
    return result;
  };
  const Run carrying = steps.next();
  const double middle = found.Second.empty() ? 1.0 : 0.5;
  SphericalRegistrationResult result = resultOf(found.Best, carrying.part(0.0, middle));
  for (const SphereDeformation& second : found.Second)
  {
    result.Second.push_back(resultOf(second, carrying.part(middle, 1.0)));
  }
  run.report(1.0);
  return result;
}

// Return the moving surface with another map, of a balance between angles and areas. Return no
// surface if there is no such map.
std::optional<RegisteredSurface> balanced(
  const RegisteredSurface& surface, double balance, const Run& run)
{
  GlobalConformalMapOptions options;
  options.AreaBalance = balance;
  RegisteredSurface result = surface;
  try
  {
    result.Surface.SpherePositions =
      globalConformalMap({ surface.Surface.Positions, surface.Surface.Triangles }, options, run)
        .Positions;
  }
  catch (const NumericalFailure&)
  {
    return std::nullopt;
  }
  return result;
}
}

//------------------------------------------------------------------------------
SphericalRegistrationResult registerSpheres(const RegisteredSurface& moving,
  const RegisteredSurface& fixed, const std::vector<std::pair<int, int>>& landmarks,
  const std::vector<double>& featureWeights, const SphericalRegistrationOptions& options,
  const Run& run)
{
  // Progress: the registration, then other maps and their registrations, which are rarely
  // necessary.
  const double first = landmarks.empty() ? 1.0 : 0.4;
  SphericalRegistrationResult result =
    registerOnce(moving, fixed, landmarks, featureWeights, options, false, run.part(0.0, first));
  // A higher balance leaves more area to limbs, and makes narrower triangles.
  constexpr std::array balances = { 0.25, 0.4, 0.1 };
  const double share = (1.0 - first) / balances.size();
  double begin = first;
  for (const double balance : balances)
  {
    if (result.NumberOfUnmetLandmarks == 0 || options.StartFromMaps)
    {
      break;
    }
    const Run part = run.part(begin, begin + share);
    begin += share;
    if (const auto other = balanced(moving, balance, part.part(0.0, 0.25)))
    {
      SphericalRegistrationResult again =
        registerOnce(*other, fixed, landmarks, featureWeights, options, true, part.part(0.25, 1.0));
      if (again.NumberOfUnmetLandmarks < result.NumberOfUnmetLandmarks)
      {
        again.AgreementBefore = result.AgreementBefore;
        result = std::move(again);
      }
    }
  }
  run.report(1.0);
  return result;
}
}
