#include "Register/SphereDeformation.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Register/RotationSearch.h"
#include "Sphere/MoebiusTransform.h"
#include "Sphere/SphereOrientation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace conformal
{
namespace
{
constexpr int NumberOfStarts = 8, NumberKept = 6, NumberKeptByLandmarks = 3, NumberOfFinalists = 2;
constexpr double NearMinimum = 1.2;  // maximum ratio of a finalist's score to the minimum score
constexpr double Comparable = 2.0;   // ratio of scores below which both directions are compared
constexpr double Ambiguous = 2.0;    // ratio of scores below which the second result is kept
constexpr double Distinct = 0.7;     // mean distance of deformations with other correspondences
constexpr double HoldAtTheEnd = 0.1; // factor of the sphere's weights in the last descent
constexpr int FirstSteps = 6, CoarseSteps = 25, FineSteps = 20;
constexpr double Tolerance = 2e-3; // relative decrease of the energy at which a descent ends
// Weights of the landmarks: in the search for rotations, in the first and second descents on the
// coarsest sphere, on finer spheres, and in the last descent. The weights grow, so that landmarks
// and shape determine the first descents together.
constexpr double LandmarksInSearch = 10.0, LandmarksAtFirst = 5.0, LandmarksOnCoarse = 20.0,
                 LandmarksOnFine = 100.0, LandmarksAtTheEnd = 1000.0;
// Maximum ratio of a start's difference to the minimum difference if there are landmarks.
constexpr double NearStart = 1.5;
constexpr double SphereWeight = 0.2; // multiple of the sphere's metric added to surface metrics
// Numbers that are added to the excess of the energy and to the pose difference in the score.
constexpr double SmallExcess = 0.02, SmallPoseDifference = 0.002;

struct Candidate
{
  Points Places;
  RegistrationEnergy Energy;
  double Score = 0.0;
};

Points carried(const SphereGrid& grid, const Points& places, const Points& directions)
{
  Points result = sampleAt(grid, places, directions);
  result.rowwise().normalize();
  return result;
}

Eigen::Matrix3d closestRotationOf(const SphereGrid& grid, const Points& places)
{
  return closestRotation(grid.mesh().Positions, places, Eigen::VectorXd::Ones(places.rows()));
}

bool hasLowerScore(const Candidate& a, const Candidate& b)
{
  return a.Score < b.Score;
}

// Descents on one geodesic sphere after the other.
class Descents
{
public:
  Descents(const PreparedSurface& moving, const PreparedSurface& fixed,
    const std::vector<SpherePair>& pairs, const DeformationOptions& options)
    : Moving(moving)
    , Fixed(fixed)
    , Pairs(pairs)
  {
    this->Options.Tolerance = Tolerance;
    this->Options.Weights.Stretch = options.StretchWeight;
    this->Options.Weights.Sphere = SphereWeight;
    this->Options.Weights.Features = options.FeatureWeights;
    this->beginAt(CoarsestFrequency);
  }

  const SphereGrid& grid() const { return this->Here.Grid; }

  std::vector<Eigen::Matrix3d> rotations(const Run& run)
  {
    const std::vector<double>& weights = this->Options.Weights.Features;
    if (this->Pairs.size() < 2 &&
      std::none_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; }))
    {
      return { Eigen::Matrix3d::Identity() };
    }
    this->Options.Weights.Landmarks = LandmarksInSearch;
    const std::vector<FoundRotation> found =
      searchRotations(this->Here, this->Fixed.sampled(CoarsestFrequency), this->Pairs,
        this->Options.Weights, NumberOfStarts, run);
    std::vector<Eigen::Matrix3d> result;
    for (const FoundRotation& one : found)
    {
      if (this->Pairs.empty() || one.Difference <= NearStart * found.front().Difference)
      {
        result.push_back(one.Rotation);
      }
    }
    return result;
  }

  // Run a few steps from each rotation, then full descents from the best results. Return the
  // results sorted by score.
  std::vector<Candidate> fromRotations(
    const std::vector<Eigen::Matrix3d>& rotations, const Run& run)
  {
    std::vector<Candidate> candidates(rotations.size());
    for (std::size_t i = 0; i < rotations.size(); ++i)
    {
      candidates[i].Places = this->grid().mesh().Positions * rotations[i].transpose();
    }
    this->descend(candidates, LandmarksAtFirst, FirstSteps, run.part(0.0, 0.5));
    const std::size_t kept = this->Pairs.empty() ? NumberKept : NumberKeptByLandmarks;
    candidates.resize(std::min(candidates.size(), kept));
    this->descend(candidates, LandmarksOnCoarse, CoarseSteps, run.part(0.5, 1.0));
    return candidates;
  }

  // Descend from a deformation of the coarsest sphere.
  Candidate from(const Points& places, const Run& run)
  {
    std::vector<Candidate> one(1);
    one.front().Places = places;
    this->descend(one, LandmarksOnCoarse, CoarseSteps, run);
    return one.front();
  }

  // Continue the descents on the present sphere, the last one with smaller weights against folds.
  // Sort the candidates by energy after the last descent: all have the same correspondences, so
  // that the pose cannot distinguish them.
  void refine(std::vector<Candidate>& candidates, bool isLast, const Run& run)
  {
    this->descend(candidates, LandmarksOnFine, FineSteps, run.part(0.0, 0.7));
    if (isLast)
    {
      // The weights that prevent folds also increase the stretch. Reduce these weights at the end.
      const RegistrationWeights held = this->Options.Weights;
      this->Options.Weights.Sphere *= HoldAtTheEnd;
      this->Options.Weights.Barrier *= HoldAtTheEnd;
      this->descend(candidates, LandmarksAtTheEnd, FineSteps, run.part(0.7, 1.0));
      this->Options.Weights = held;
      std::stable_sort(candidates.begin(), candidates.end(),
        [](const Candidate& a, const Candidate& b) { return a.Energy.Total < b.Energy.Total; });
    }
  }

  // Sample both surfaces on other spheres. Interpolate the candidates at the new vertices.
  void continueAt(int frequency, const std::vector<std::vector<Candidate>*>& lists)
  {
    const SphereGrid last = this->Here.Grid;
    this->beginAt(frequency);
    for (std::vector<Candidate>* list : lists)
    {
      for (Candidate& candidate : *list)
      {
        candidate.Places = carried(last, candidate.Places, this->grid().mesh().Positions);
      }
    }
  }

private:
  void beginAt(int frequency)
  {
    this->Here = this->Moving.sampled(frequency);
    this->There = this->Fixed.sampled(2 * frequency);
  }

  // Descend from each candidate, and sort the candidates by score, the best one first.
  void descend(
    std::vector<Candidate>& candidates, double landmarkWeight, int numberOfSteps, const Run& run)
  {
    this->Options.Weights.Landmarks = landmarkWeight;
    this->Options.MaximumNumberOfSteps = numberOfSteps;
    // Run two descents concurrently. Progress is reported after both, since each descent is long. A
    // single descent reports its own progress.
    constexpr std::size_t together = 2;
    const auto size = static_cast<double>(candidates.size());
    for (std::size_t start = 0; start < candidates.size(); start += together)
    {
      const std::size_t end = std::min(candidates.size(), start + together);
      const Run part = run.part(static_cast<double>(start) / size, static_cast<double>(end) / size);
      if (end - start == 1)
      {
        this->descendOne(candidates[start], part);
      }
      else
      {
        forBlocks(part, static_cast<Index>(end - start), 1,
          [&](Index i, Index) { this->descendOne(candidates[start + i], Run()); });
      }
      part.report(1.0);
    }
    std::stable_sort(candidates.begin(), candidates.end(), hasLowerScore);
  }

  void descendOne(Candidate& one, const Run& run) const
  {
    one.Energy =
      conformal::descend(this->Here, this->There, this->Pairs, this->Options, one.Places, run);
    const double excess = one.Energy.Total - this->Options.Weights.Stretch;
    one.Score = (std::max(0.0, excess) + SmallExcess) *
      (std::max(0.0, this->poseDifference(one.Places)) + SmallPoseDifference);
  }

  // Compute the pose difference: 1 minus the correlation of corresponding positions, after the best
  // rotation in space. The pose difference distinguishes a head from a tail with similar geodesic
  // features.
  double poseDifference(const Points& places) const
  {
    Points here = this->Here.Values.leftCols<3>(), there = this->Fixed.positionsAt(places);
    Eigen::VectorXd weights = vertexAreas(here, this->grid().mesh().Triangles);
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

  const PreparedSurface& Moving;
  const PreparedSurface& Fixed;
  const std::vector<SpherePair>& Pairs;
  SampledSurface Here, There;
  DescentOptions Options;
};

// Return the inverse of a deformation: the places to which it is inverse at the vertices of the
// grid. Return no points if the inverse folds a triangle of the grid.
Points inverseOf(const SphereGrid& grid, const Points& places)
{
  const Mesh& rest = grid.mesh();
  const SphereGrid deformed(Mesh{ places, rest.Triangles });
  const Points inverse = carried(deformed, rest.Positions, rest.Positions);
  return countFlippedTriangles(inverse, rest.Triangles) == 0 ? inverse : Points();
}

// Candidate of the opposite direction, and its inverse after a descent.
struct BothWays
{
  double BackwardScore = 0.0;
  std::vector<Candidate> Inverse; // empty if the inverse is folded
};

// Descend in the opposite direction, from the inverse of the rotation that is closest to a
// candidate. Then descend from the inverse of the result.
BothWays inOppositeDirection(Descents& forward, Descents& backward, const Candidate& candidate)
{
  const Candidate opposite =
    backward
      .fromRotations({ closestRotationOf(forward.grid(), candidate.Places).transpose() }, Run())
      .front();
  BothWays both{ opposite.Score, {} };
  const Points inverse = inverseOf(forward.grid(), opposite.Places);
  if (inverse.rows() > 0)
  {
    both.Inverse.push_back(forward.from(inverse, Run()));
  }
  return both;
}

// Find the best candidate whose correspondences differ from those of the first candidate.
std::vector<Candidate>::iterator distinctFromFirst(std::vector<Candidate>& candidates)
{
  return std::find_if(candidates.begin() + 1, candidates.end(),
    [&](const Candidate& one)
    { return (one.Places - candidates.front().Places).rowwise().norm().mean() > Distinct; });
}

// Decide between the best candidate and the best one with other correspondences. If both are about
// equally good, return the second one. Leave finalists with the correspondences of the first one.
std::vector<Candidate> takeSecond(
  std::vector<Candidate>& candidates, Descents& forward, Descents& backward)
{
  std::vector<Candidate> second;
  const auto other = distinctFromFirst(candidates);
  const bool isClose =
    other != candidates.end() && other->Score < Comparable * candidates.front().Score;
  const BothWays first = inOppositeDirection(forward, backward, candidates.front());
  std::vector<Candidate> inverses = first.Inverse;
  if (isClose)
  {
    const BothWays ofOther = inOppositeDirection(forward, backward, *other);
    const double ratio = std::sqrt(
      other->Score / candidates.front().Score * ofOther.BackwardScore / first.BackwardScore);
    if (ratio < 1.0)
    {
      std::swap(*other, candidates.front());
      inverses = ofOther.Inverse;
    }
    if (std::max(ratio, 1.0 / ratio) < Ambiguous)
    {
      second.push_back(*other);
    }
  }
  const Candidate best = candidates.front();
  const auto isFinalist = [&](const Candidate& one)
  {
    return one.Score <= NearMinimum * best.Score &&
      (one.Places - best.Places).rowwise().norm().mean() <= Distinct;
  };
  candidates.erase(std::remove_if(candidates.begin() + 1, candidates.end(),
                     [&](const Candidate& one) { return !isFinalist(one); }),
    candidates.end());
  candidates.resize(std::min<std::size_t>(candidates.size(), NumberOfFinalists));
  candidates.insert(candidates.end(), inverses.begin(), inverses.end());
  return second;
}
}

//------------------------------------------------------------------------------
SphereDeformation::SphereDeformation(SphereGrid grid, Points places)
  : Grid(std::move(grid))
  , Places(std::move(places))
{
}

Points SphereDeformation::placesOf(const Points& directions, double fraction) const
{
  if (fraction == 1.0)
  {
    return carried(this->Grid, this->Places, directions);
  }
  const Eigen::Matrix3d rotation = closestRotationOf(this->Grid, this->Places);
  if (fraction == 0.0)
  {
    return directions * rotation.transpose();
  }
  Points between =
    fraction * this->Places + (1.0 - fraction) * (this->rest().Positions * rotation.transpose());
  between.rowwise().normalize();
  return carried(this->Grid, between, directions);
}

//------------------------------------------------------------------------------
FoundDeformations findDeformations(const PreparedSurface& moving, const PreparedSurface& fixed,
  const std::vector<SpherePair>& pairs, const DeformationOptions& options, const Run& run)
{
  std::vector<int> frequencies;
  // Progress: rotations, starts, then each level in proportion to its number of vertices.
  std::vector<double> shares = { 3.0, 8.5 };
  for (int frequency = CoarsestFrequency; frequency < options.Frequency;)
  {
    frequency = std::min(options.Frequency, 2 * frequency);
    frequencies.push_back(frequency);
    shares.push_back(0.037 * frequency * frequency);
  }
  Steps steps(run, shares);
  Descents descents(moving, fixed, pairs, options);
  const Run searching = steps.next();
  const std::vector<Eigen::Matrix3d> rotations = options.StartFromMaps
    ? std::vector<Eigen::Matrix3d>{ Eigen::Matrix3d::Identity() }
    : descents.rotations(searching);
  std::vector<Candidate> candidates = descents.fromRotations(rotations, steps.next());
  std::vector<Candidate> second;
  if (!options.StartFromMaps)
  {
    std::vector<SpherePair> turned;
    turned.reserve(pairs.size());
    for (const SpherePair& pair : pairs)
    {
      turned.push_back({ pair.To, pair.From });
    }
    Descents backward(fixed, moving, turned, options);
    second = takeSecond(candidates, descents, backward);
  }
  for (const int frequency : frequencies)
  {
    descents.continueAt(frequency, { &candidates, &second });
    const bool isLast = frequency == frequencies.back();
    const Run part = steps.next();
    const double middle = second.empty() ? 1.0 : 0.5;
    descents.refine(candidates, isLast, part.part(0.0, middle));
    descents.refine(second, isLast, part.part(middle, 1.0));
  }
  FoundDeformations found;
  found.Best = { descents.grid(), std::move(candidates.front().Places) };
  for (Candidate& one : second)
  {
    found.Second.emplace_back(descents.grid(), std::move(one.Places));
  }
  return found;
}
}
