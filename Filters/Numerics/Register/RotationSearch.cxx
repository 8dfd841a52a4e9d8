#include "Register/RotationSearch.h"

#include "Linear/EdgeWeights.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr int NumberOfAxes = 120, NumberOfAngles = 14; // spaced by about 23 degrees
constexpr int NumberImproved = 60, ImprovingSteps = 8;
constexpr double Apart = Pi / 6.0;

// Return point i of a spiral of evenly spaced points on the sphere.
Vector3 axisOf(int i)
{
  const double z = 1.0 - (2.0 * i + 1.0) / NumberOfAxes, golden = Pi * (3.0 - std::sqrt(5.0));
  const double radius = std::sqrt(1.0 - z * z);
  return { radius * std::cos(golden * i), radius * std::sin(golden * i), z };
}

class Search
{
public:
  Search(const SampledSurface& moving, const SampledSurface& fixed,
    const std::vector<SpherePair>& pairs, const RegistrationWeights& weights)
    : Moving(moving)
    , Fixed(fixed)
    , Pairs(pairs)
    , PairWeight(weights.Landmarks / std::max<double>(1.0, static_cast<double>(pairs.size())))
    , Weights(Eigen::Map<const Eigen::VectorXd>(
        weights.Features.data(), static_cast<Index>(weights.Features.size())))
    , Shares(vertexAreas(moving.Values.leftCols<3>(), moving.Grid.mesh().Triangles))
  {
    this->Shares /= this->Shares.sum();
  }

  // Compute the difference of the surfaces after a rotation. If `improved` is not null, set it to
  // the rotation after one Gauss-Newton step.
  double difference(const Eigen::Matrix3d& rotation, Eigen::Matrix3d* improved = nullptr) const
  {
    const Index count = this->Weights.size();
    double sum = 0.0;
    Eigen::Matrix3d matrix = 1e-6 * Eigen::Matrix3d::Identity();
    Vector3 slope = Vector3::Zero();
    int hint = -1;
    for (Index i = 0; i < this->Moving.Grid.size(); ++i)
    {
      const Vector3 place = rotation * this->Moving.Grid.mesh().Positions.row(i).transpose();
      const SphereWeights at = this->Fixed.Grid.weightsAt(place, hint);
      hint = at.Triangle;
      for (Index k = 0; k < count; ++k)
      {
        const Vector3 corners = { this->Fixed.Values(at.Ids[0], 3 + k),
          this->Fixed.Values(at.Ids[1], 3 + k), this->Fixed.Values(at.Ids[2], 3 + k) };
        const double off = corners.dot(at.Weights) - this->Moving.Values(i, 3 + k);
        const double weight = this->Weights[k] * this->Shares[i];
        sum += weight * off * off;
        if (improved)
        {
          // A rotation by a small vector w moves the position x by the cross product of w and x.
          const Vector3 turn = place.cross(at.Slopes.transpose() * corners);
          slope += weight * off * turn;
          matrix += weight * turn * turn.transpose();
        }
      }
    }
    sum += this->distanceOfLandmarks(rotation);
    if (improved)
    {
      for (const SpherePair& pair : this->Pairs)
      {
        const Vector3 place = rotation * pair.From;
        slope += this->PairWeight * place.cross(place - pair.To);
        matrix += this->PairWeight * (Eigen::Matrix3d::Identity() - place * place.transpose());
      }
      const Vector3 turn = -matrix.ldlt().solve(slope);
      const double angle = turn.norm();
      *improved = angle > 0.0
        ? Eigen::Matrix3d(Eigen::AngleAxisd(std::min(angle, 0.2), turn / angle) * rotation)
        : rotation;
    }
    return sum;
  }

  // Compute the weighted mean square distance between landmarks and their targets.
  double distanceOfLandmarks(const Eigen::Matrix3d& rotation) const
  {
    double sum = 0.0;
    for (const SpherePair& pair : this->Pairs)
    {
      sum += this->PairWeight * (rotation * pair.From - pair.To).squaredNorm();
    }
    return sum;
  }

  void improve(FoundRotation& found) const
  {
    Eigen::Matrix3d trial = found.Rotation;
    for (int step = 0; step < ImprovingSteps; ++step)
    {
      Eigen::Matrix3d after;
      const double difference = this->difference(trial, &after);
      if (step > 0 && difference > found.Difference)
      {
        break;
      }
      found = { trial, difference };
      trial = after;
    }
  }

private:
  const SampledSurface& Moving;
  const SampledSurface& Fixed;
  const std::vector<SpherePair>& Pairs;
  double PairWeight;
  Eigen::VectorXd Weights, Shares;
};

bool isBetter(const FoundRotation& a, const FoundRotation& b)
{
  return a.Difference < b.Difference;
}

// Return rotations that are spread evenly. Each rotation consists of two steps: a rotation about z,
// then the shortest rotation of z to one of the axes.
std::vector<FoundRotation> evenRotations()
{
  std::vector<FoundRotation> all;
  for (int i = 0; i < NumberOfAxes * NumberOfAngles; ++i)
  {
    const double angle = 2.0 * Pi * (i % NumberOfAngles) / NumberOfAngles;
    all.push_back(
      { (Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), axisOf(i / NumberOfAngles)) *
          Eigen::AngleAxisd(angle, Vector3::UnitZ()))
          .toRotationMatrix(),
        0.0 });
  }
  return all;
}
}

//------------------------------------------------------------------------------
std::vector<FoundRotation> searchRotations(const SampledSurface& moving,
  const SampledSurface& fixed, const std::vector<SpherePair>& pairs,
  const RegistrationWeights& weights, int count, const Run& run)
{
  const Search search(moving, fixed, pairs, weights);
  std::vector<FoundRotation> all = evenRotations();
  int numberImproved = NumberImproved;
  if (!pairs.empty())
  {
    // Landmarks exclude most rotations at little cost.
    for (FoundRotation& one : all)
    {
      one.Difference = search.distanceOfLandmarks(one.Rotation);
    }
    std::stable_sort(all.begin(), all.end(), isBetter);
    all.resize(all.size() / 4);
    numberImproved /= 4;
  }
  forBlocksReporting(run, static_cast<Index>(all.size()), 16,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        all[i].Difference = search.difference(all[i].Rotation);
      }
    });
  std::stable_sort(all.begin(), all.end(), isBetter);
  // Select distinct starts, so that refinements do not all converge to one minimum.
  std::vector<FoundRotation> starts;
  const auto isNew =
    [](const std::vector<FoundRotation>& list, const FoundRotation& one, double apart)
  {
    return std::all_of(list.begin(), list.end(),
      [&](const FoundRotation& other)
      {
        return Eigen::AngleAxisd(Eigen::Matrix3d(one.Rotation.transpose() * other.Rotation))
                 .angle() > apart;
      });
  };
  for (const FoundRotation& one : all)
  {
    if (static_cast<int>(starts.size()) < numberImproved && isNew(starts, one, 0.8 * Apart))
    {
      starts.push_back(one);
    }
  }
  forBlocks(run, static_cast<Index>(starts.size()), 1,
    [&](Index begin, Index) { search.improve(starts[begin]); });
  std::stable_sort(starts.begin(), starts.end(), isBetter);
  std::vector<FoundRotation> result;
  for (const FoundRotation& one : starts)
  {
    if (static_cast<int>(result.size()) < count && isNew(result, one, Apart))
    {
      result.push_back(one);
    }
  }
  return result;
}
}
