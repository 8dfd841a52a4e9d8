#include "Register/SphericalRegistration.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Measure/SphericalAlignment.h"
#include "Mesh/GeodesicSphere.h"
#include "Register/LandmarkFlow.h"
#include "Register/RotationSearch.h"
#include "Register/SphereFeatures.h"
#include "Sphere/SphereCoverage.h"
#include "Sphere/SphereOrientation.h"
#include "SphereMap/FlipRepair.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
constexpr int CoarsestFrequency = 8, FeatureFrequency = 20;
constexpr int NumberOfStarts = 8, NumberKept = 6, NumberOfFinalists = 2;
constexpr double NearMinimum = 1.05; // maximum ratio of a finalist's score to the minimum score
constexpr double PoseWeight = 3.0;   // weight of the pose difference in the score
constexpr double HoldAtTheEnd = 0.1; // factor of the sphere's weights in the last descent
constexpr int FirstSteps = 6, CoarseSteps = 25, FineSteps = 20;
constexpr double Tolerance = 2e-3; // relative decrease of the energy at which a descent ends
constexpr double LandmarkWeight = 200.0;
constexpr double SphereWeight = 0.2; // multiple of the sphere's metric added to surface metrics
// Weights of the features: mean distance, two nearby areas, two curvatures. The weight of the
// stretch is 1.
constexpr double ShapeWeights[] = { 0.4, 0.4, 0.4, 0.2, 0.2 };
const std::vector<double> AreaRadii = { 0.17, 0.35 };
// Smoothing radius of a curvature, and the curvature at which its arc tangent saturates.
struct CurvatureFeature
{
  double Scale, Saturation;
};
constexpr CurvatureFeature CurvatureFeatures[] = { { 0.21, 8.5 }, { 0.07, 17.0 } };

// Surface scaled to the area of the unit sphere, with a map that is not mirrored, and all features.
class PreparedSurface
{
public:
  PreparedSurface(
    const RegisteredSurface& input, bool withShape, const std::string& name, const Run& run)
    : Surface(input.Surface)
  {
    SphereCoverage coverage =
      measureSphereCoverage(this->Surface.SpherePositions, this->Surface.Triangles);
    if (coverage.Degree == -1)
    {
      this->Mirrored = true;
      this->Surface.SpherePositions.col(0) *= -1.0;
      coverage = measureSphereCoverage(this->Surface.SpherePositions, this->Surface.Triangles);
    }
    const Index folds =
      countFlippedTriangles(this->Surface.SpherePositions, this->Surface.Triangles);
    if (coverage.Degree != 1 || folds > 0)
    {
      throw std::invalid_argument("the map of the " + name + " surface to the sphere covers it " +
        std::to_string(coverage.Degree) + " times with " + std::to_string(folds) +
        " folded triangles, but must cover it once without folds");
    }
    const Eigen::VectorXd areas = vertexAreas(this->Surface.Positions, this->Surface.Triangles);
    const double area = areas.sum() / 6.0; // each triangle is counted twice at three corners
    const Eigen::RowVector3d center = areas.transpose() * this->Surface.Positions / areas.sum();
    this->Surface.Positions.rowwise() -= center;
    this->Surface.Positions *= std::sqrt(4.0 * Pi / area);
    this->Own = SphereGrid(Mesh{ this->Surface.SpherePositions, this->Surface.Triangles });
    this->Given = input.Features;
    normalizeFeatures(this->Given, areas);
    if (withShape)
    {
      this->computeShape(run);
    }
  }

  // Sample the surface in the directions of a geodesic sphere.
  SampledSurface sampled(int frequency) const
  {
    SampledSurface result;
    result.Grid = SphereGrid(makeGeodesicSphere(frequency));
    const Points& directions = result.Grid.mesh().Positions;
    const Index shape = this->Shape.cols();
    result.Values.resize(result.Grid.size(), 3 + shape + this->Given.cols());
    result.Values.leftCols<3>() = sampleAt(this->Own, this->Surface.Positions, directions);
    if (shape > 0)
    {
      result.Values.middleCols(3, shape) = sampleAt(this->ShapeGrid, this->Shape, directions);
    }
    if (this->Given.cols() > 0)
    {
      result.Values.rightCols(this->Given.cols()) = this->averagedOn(result.Grid);
    }
    return result;
  }

  MappedMesh Surface;
  SphereGrid Own;
  bool Mirrored = false;

private:
  void computeShape(const Run& run)
  {
    this->ShapeGrid = SphereGrid(makeGeodesicSphere(FeatureFrequency));
    const Mesh even = { sampleAt(
                          this->Own, this->Surface.Positions, this->ShapeGrid.mesh().Positions),
      this->ShapeGrid.mesh().Triangles };
    GeodesicFeatureOptions options;
    options.Radii = AreaRadii;
    const Rows distances = geodesicFeatures(even, options, run);
    Index column = distances.cols();
    this->Shape.resize(distances.rows(), column + std::size(CurvatureFeatures));
    this->Shape.leftCols(column) = distances;
    for (const CurvatureFeature& feature : CurvatureFeatures)
    {
      this->Shape.col(column++) =
        (smoothMeanCurvature(even, feature.Scale).array() / feature.Saturation).atan().matrix();
    }
    normalizeFeatures(this->Shape, vertexAreas(even.Positions, even.Triangles));
  }

  // Average features around the vertices of a grid, so that details below the grid's resolution are
  // not aliased.
  Rows averagedOn(const SphereGrid& grid) const
  {
    const Eigen::VectorXd areas = vertexAreas(this->Surface.Positions, this->Surface.Triangles);
    // Weight of values interpolated at a vertex, for vertices without samples nearby.
    constexpr double few = 1e-6;
    const double minimum = few * areas.sum() / static_cast<double>(grid.size());
    Rows sums = minimum * sampleAt(this->Own, this->Given, grid.mesh().Positions);
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(grid.size(), minimum);
    int hint = -1;
    for (Index v = 0; v < areas.size(); ++v)
    {
      const SphereWeights at = grid.weightsAt(this->Surface.SpherePositions.row(v), hint);
      hint = at.Triangle;
      for (int k = 0; k < 3; ++k)
      {
        const double weight = at.Weights[k] * areas[v];
        sums.row(at.Ids[k]) += weight * this->Given.row(v);
        weights[at.Ids[k]] += weight;
      }
    }
    return weights.cwiseInverse().asDiagonal() * sums;
  }

  Rows Given, Shape;
  SphereGrid ShapeGrid;
};

Points carried(const SphereGrid& grid, const Points& places, const Points& directions)
{
  Points result = sampleAt(grid, places, directions);
  result.rowwise().normalize();
  return result;
}

// Deformation of the moving surface's sphere, from coarse to fine.
class Registration
{
public:
  Registration(const PreparedSurface& moving, const PreparedSurface& fixed,
    const std::vector<SpherePair>& pairs, std::vector<double> features, double stretch)
    : Moving(moving)
    , Fixed(fixed)
    , Pairs(pairs)
  {
    this->Options.Tolerance = Tolerance;
    this->Options.Weights.Stretch = stretch;
    this->Options.Weights.Sphere = SphereWeight;
    this->Options.Weights.Features = std::move(features);
    this->Options.Weights.Landmarks = LandmarkWeight;
  }

  RegistrationEnergy run(int finest, const Run& run)
  {
    std::vector<int> frequencies;
    // Progress: rotations, starts, then each level in proportion to its number of vertices.
    std::vector<double> shares = { 3.0, 8.5 };
    for (int frequency = CoarsestFrequency; frequency < finest;)
    {
      frequency = std::min(finest, 2 * frequency);
      frequencies.push_back(frequency);
      shares.push_back(0.037 * frequency * frequency);
    }
    Steps steps(run, shares);
    const std::vector<Eigen::Matrix3d> rotations = this->rotations(steps.next());
    this->Grid = this->Moving.sampled(CoarsestFrequency);
    const SampledSurface target = this->Fixed.sampled(2 * CoarsestFrequency);
    const RegistrationEnergy before =
      this->descendAt(target, 0, this->Before = this->Grid.Grid.mesh().Positions);
    std::vector<Candidate> candidates = this->bestStarts(rotations, target, steps.next());
    for (const int frequency : frequencies)
    {
      SampledSurface finer = this->Moving.sampled(frequency);
      for (Candidate& candidate : candidates)
      {
        candidate.Places = carried(this->Grid.Grid, candidate.Places, finer.Grid.mesh().Positions);
      }
      this->Grid = std::move(finer);
      const SampledSurface sampled = this->Fixed.sampled(2 * frequency);
      const Run part = steps.next();
      this->descendFrom(candidates, sampled, FineSteps, part.part(0.0, 0.7));
      candidates.resize(1);
      if (frequency == frequencies.back())
      {
        // The weights that prevent folds also increase the stretch. Reduce these weights at the
        // end.
        this->Options.Weights.Sphere *= HoldAtTheEnd;
        this->Options.Weights.Barrier *= HoldAtTheEnd;
        this->descendFrom(candidates, sampled, FineSteps, part.part(0.7, 1.0));
      }
    }
    this->Places = candidates.front().Places;
    this->DifferenceBefore = before.Features;
    return candidates.front().Energy;
  }

  Points places(const Points& directions) const
  {
    return carried(this->Grid.Grid, this->Places, directions);
  }

  // Interpolate between a rotation (fraction 0) and the deformation (fraction 1). The rotation is
  // the one closest to the deformation.
  Points placesAt(double fraction, const Points& directions) const
  {
    const Points& rest = this->Grid.Grid.mesh().Positions;
    const Eigen::Matrix3d rotation =
      closestRotation(rest, this->Places, Eigen::VectorXd::Ones(rest.rows()));
    if (fraction == 0.0)
    {
      return directions * rotation.transpose();
    }
    Points between = fraction * this->Places + (1.0 - fraction) * (rest * rotation.transpose());
    between.rowwise().normalize();
    return carried(this->Grid.Grid, between, directions);
  }

  SampledSurface Grid;
  Points Places;
  double DifferenceBefore = 0.0;

private:
  struct Candidate
  {
    Points Places;
    RegistrationEnergy Energy;
    double Score = 0.0; // energy plus the weighted pose difference
  };

  std::vector<Eigen::Matrix3d> rotations(const Run& run) const
  {
    if (this->Pairs.size() >= 2)
    {
      const auto count = static_cast<Index>(this->Pairs.size());
      Points from(count, 3), to(count, 3);
      for (Index i = 0; i < count; ++i)
      {
        from.row(i) = this->Pairs[i].From;
        to.row(i) = this->Pairs[i].To;
      }
      return { closestRotation(from, to, Eigen::VectorXd::Ones(count)) };
    }
    std::vector<Eigen::Matrix3d> result;
    const std::vector<double>& weights = this->Options.Weights.Features;
    if (std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; }))
    {
      for (const FoundRotation& found : searchRotations(this->Moving.sampled(CoarsestFrequency),
             this->Fixed.sampled(CoarsestFrequency), weights, NumberOfStarts, run))
      {
        result.push_back(found.Rotation);
      }
    }
    return result.empty() ? std::vector<Eigen::Matrix3d>{ Eigen::Matrix3d::Identity() } : result;
  }

  RegistrationEnergy descendAt(
    const SampledSurface& target, int numberOfSteps, Points& places, const Run& run = {}) const
  {
    DescentOptions options = this->Options;
    options.MaximumNumberOfSteps = numberOfSteps;
    return descend(this->Grid, target, this->Pairs, options, places, run);
  }

  // Descend from each candidate, and sort the candidates by score, the best one first.
  void descendFrom(std::vector<Candidate>& candidates, const SampledSurface& target,
    int numberOfSteps, const Run& run) const
  {
    // Run two descents concurrently. Progress is reported after both, since each descent is long. A
    // single descent reports its own progress.
    constexpr std::size_t together = 2;
    const auto size = static_cast<double>(candidates.size());
    for (std::size_t start = 0; start < candidates.size(); start += together)
    {
      const std::size_t end = std::min(candidates.size(), start + together);
      const Run part = run.part(static_cast<double>(start) / size, static_cast<double>(end) / size);
      const auto descendOne = [&](Candidate& one, const Run& watched)
      {
        one.Energy = this->descendAt(target, numberOfSteps, one.Places, watched);
        one.Score = one.Energy.Total + PoseWeight * this->poseDifference(one.Places);
      };
      if (end - start == 1)
      {
        descendOne(candidates[start], part);
      }
      else
      {
        forBlocks(part, static_cast<Index>(end - start), 1,
          [&](Index i, Index) { descendOne(candidates[start + i], Run()); });
      }
      part.report(1.0);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.Score < b.Score; });
  }

  // Compute the pose difference: 1 minus the correlation of corresponding positions, after the best
  // rotation in space. The pose difference distinguishes a head from a tail with similar geodesic
  // features.
  double poseDifference(const Points& places) const
  {
    Points here = this->Grid.Values.leftCols<3>(),
           there = sampleAt(this->Fixed.Own, this->Fixed.Surface.Positions, places);
    Eigen::VectorXd weights = vertexAreas(here, this->Grid.Grid.mesh().Triangles);
    weights /= weights.sum();
    for (Points* positions : { &here, &there })
    {
      const Eigen::RowVector3d mean = weights.transpose() * *positions;
      positions->rowwise() -= mean;
      *positions /= std::sqrt(weights.dot(positions->rowwise().squaredNorm()));
    }
    const Points turned = here * closestRotation(here, there, weights).transpose();
    return 1.0 - weights.dot(turned.cwiseProduct(there).rowwise().sum());
  }

  // Run a few steps from each rotation, then full descents from the best results. Return the
  // results with scores near the minimum.
  std::vector<Candidate> bestStarts(const std::vector<Eigen::Matrix3d>& rotations,
    const SampledSurface& target, const Run& run) const
  {
    std::vector<Candidate> candidates(rotations.size());
    for (std::size_t i = 0; i < rotations.size(); ++i)
    {
      candidates[i].Places = this->Grid.Grid.mesh().Positions * rotations[i].transpose();
    }
    this->descendFrom(candidates, target, FirstSteps, run.part(0.0, 0.5));
    candidates.resize(std::min<std::size_t>(candidates.size(), NumberKept));
    this->descendFrom(candidates, target, CoarseSteps, run.part(0.5, 1.0));
    const double limit = NearMinimum * candidates.front().Score;
    const auto isNear = [&](const Candidate& one) { return one.Score <= limit; };
    candidates.erase(
      std::find_if_not(candidates.begin(), candidates.end(), isNear), candidates.end());
    candidates.resize(std::min<std::size_t>(candidates.size(), NumberOfFinalists));
    return candidates;
  }

  const PreparedSurface& Moving;
  const PreparedSurface& Fixed;
  const std::vector<SpherePair>& Pairs;
  DescentOptions Options;
  Points Before;
};

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
    std::vector<Vector3> positions(places.rows());
    for (Index v = 0; v < places.rows(); ++v)
    {
      positions[v] = places.row(v);
    }
    repairFlips(positions, this->Surface.Positions, this->Surface.Triangles, this->Strings,
      this->Rings, this->Shapes);
    for (Index v = 0; v < places.rows(); ++v)
    {
      places.row(v) = positions[v];
    }
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
Points carriedWithoutFolds(const PreparedSurface& moving, const Registration& registration,
  const FoldRepair& repair, double maximum)
{
  const MappedMesh& mesh = moving.Surface;
  for (double fraction = maximum; fraction > 0.1; fraction *= 0.7)
  {
    Points places = fraction == 1.0 ? registration.places(mesh.SpherePositions)
                                    : registration.placesAt(fraction, mesh.SpherePositions);
    if (countFlippedTriangles(places, mesh.Triangles) == 0 || repair(places))
    {
      return places;
    }
  }
  const Points turned = registration.placesAt(0.0, mesh.SpherePositions);
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

// Return the weights of all features: first the built-in features if they are used, then the given
// features.
std::vector<double> weightsOf(double shapeWeight, const std::vector<double>& featureWeights)
{
  std::vector<double> weights;
  for (const double weight : ShapeWeights)
  {
    if (shapeWeight > 0.0)
    {
      weights.push_back(shapeWeight * weight);
    }
  }
  weights.insert(weights.end(), featureWeights.begin(), featureWeights.end());
  return weights;
}

// Move the moving surface's vertices by the deformation, then to the landmarks. If the landmarks
// cannot be reached after the whole deformation, try smaller fractions of the deformation.
Points carriedToLandmarks(const PreparedSurface& moving, const Registration& registration,
  const LandmarkPairs& landmarks, Index& numberOfUnmet, const Run& run)
{
  const FoldRepair repair(moving.Surface);
  LandmarkFlowOptions flowing;
  flowing.Repair = repair;
  LandmarkFlowResult flow;
  Points best;
  for (const double maximumFraction : { 1.0, 0.5, 0.0 })
  {
    const Run part = run.part(0.5 * (1.0 - maximumFraction), 0.5 * (1.5 - maximumFraction));
    Points places = carriedWithoutFolds(moving, registration, repair, maximumFraction);
    const LandmarkFlowResult found = flowToLandmarks(
      moving.Surface.Triangles, landmarks.Ids, landmarks.Targets, places, flowing, part);
    if (maximumFraction == 1.0 || found.Error < flow.Error)
    {
      flow = found;
      best = std::move(places);
    }
    if (flow.NumberOfUnmet == 0)
    {
      break;
    }
  }
  numberOfUnmet = flow.NumberOfUnmet;
  return best;
}

// Fit a rotation or Moebius transform to a deformation.
MoebiusTransform transformOf(const Registration& registration, AlignmentKind kind, const Run& run)
{
  const SampledSurface& grid = registration.Grid;
  return alignSpheres(grid.Grid.mesh().Positions, registration.Places,
    vertexAreas(grid.Values.leftCols<3>(), grid.Grid.mesh().Triangles), kind, run)
    .Transform;
}
}

//------------------------------------------------------------------------------
SphericalRegistrationResult registerSpheres(const RegisteredSurface& moving,
  const RegisteredSurface& fixed, const std::vector<std::pair<int, int>>& landmarks,
  const std::vector<double>& featureWeights, const SphericalRegistrationOptions& options,
  const Run& run)
{
  const bool diffeomorphic = options.Space == SpaceOfTransforms::Diffeomorphic;
  const bool withShape = options.ShapeWeight > 0.0;
  // Progress: both surfaces, the deformation, the vertices, and the landmarks.
  Steps steps(run, { 0.15, 0.15, 0.55, 0.05, 0.1 });
  const PreparedSurface from(moving, withShape, "moving", steps.next());
  const PreparedSurface to(fixed, withShape, "fixed", steps.next());
  const LandmarkPairs pairs(landmarks, from.Surface.SpherePositions, to.Surface.SpherePositions);
  const std::vector<double> weights = weightsOf(options.ShapeWeight, featureWeights);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const AlignmentKind kind =
    options.Space == SpaceOfTransforms::Moebius ? AlignmentKind::Moebius : AlignmentKind::Rotation;
  Registration registration(from, to, pairs.Pairs, weights, options.StretchWeight);
  const bool byLandmarks = !diffeomorphic && pairs.count() > 0;
  const MoebiusTransform given = byLandmarks ? pairs.transform(kind) : MoebiusTransform();
  RegistrationEnergy energy =
    registration.run(diffeomorphic ? options.Frequency : CoarsestFrequency, steps.next());
  SphericalRegistrationResult result;
  const Run carrying = steps.next();
  if (diffeomorphic)
  {
    result.SpherePositions =
      carriedToLandmarks(from, registration, pairs, result.NumberOfUnmetLandmarks, steps.next());
  }
  else
  {
    const MoebiusTransform transform =
      byLandmarks ? given : transformOf(registration, kind, carrying);
    result.SpherePositions = from.Surface.SpherePositions;
    transform.applyTo(result.SpherePositions);
  }
  result.Stretch = energy.Stretch;
  if (sum > 0.0)
  {
    // The features have mean 0 and variance 1, so their correlation is 1 - difference / 2.
    result.AgreementBefore = 1.0 - 0.5 * registration.DifferenceBefore / sum;
    result.AgreementAfter = 1.0 - 0.5 * energy.Features / sum;
  }
  result.LandmarkError = pairs.errorOf(result.SpherePositions);
  result.NumberOfFolds = countFlippedTriangles(result.SpherePositions, from.Surface.Triangles);
  if (to.Mirrored)
  {
    result.SpherePositions.col(0) *= -1.0;
  }
  run.report(1.0);
  return result;
}
}
