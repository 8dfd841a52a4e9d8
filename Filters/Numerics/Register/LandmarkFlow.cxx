#include "Register/LandmarkFlow.h"

#include "Sphere/SphereOrientation.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace conformal
{
namespace
{
constexpr double Met = 1e-6;
constexpr double RepairedFraction = 0.25;
constexpr double SmallestFraction = 1.0 / 64.0;
constexpr double WorthARound = 0.95;  // of the sum of distances, by all widths once
constexpr double Nearer = 1.0 - 1e-6; // likewise, by a step

// The turn that brings one direction to another, no farther than a limit.
Vector3 turnBetween(const Vector3& from, const Vector3& to, double limit)
{
  const Vector3 axis = from.cross(to);
  const double sine = axis.norm(), angle = std::atan2(sine, from.dot(to));
  return sine > 0.0 ? Vector3(axis * (std::min(angle, limit) / sine)) : Vector3(Vector3::Zero());
}

Vector3 turned(const Vector3& place, const Vector3& turn)
{
  const double angle = turn.norm();
  return angle > 0.0 ? Vector3((Eigen::AngleAxisd(angle, turn / angle) * place).normalized())
                     : place;
}

// The sum of Gaussians with the given values at the landmarks.
class TurnField
{
public:
  TurnField(const Points& centers, const Points& values, double width)
    : Centers(centers)
    , Scale(-0.5 / (width * width))
  {
    const Index count = centers.rows();
    Eigen::MatrixXd kernel(count, count);
    for (Index i = 0; i < count; ++i)
    {
      for (Index j = 0; j < count; ++j)
      {
        kernel(i, j) = this->kernel(centers.row(i), j);
      }
    }
    constexpr double ridge = 1e-10; // for landmarks much closer than the width
    kernel.diagonal().array() += ridge;
    this->Weights = kernel.ldlt().solve(values);
  }

  Vector3 operator()(const Vector3& place) const
  {
    Vector3 sum = Vector3::Zero();
    for (Index j = 0; j < this->Centers.rows(); ++j)
    {
      sum += this->kernel(place, j) * this->Weights.row(j).transpose();
    }
    return sum;
  }

private:
  double kernel(const Vector3& place, Index j) const
  {
    return std::exp(this->Scale * (place - this->Centers.row(j).transpose()).squaredNorm());
  }

  Points Centers, Weights;
  double Scale;
};

// For each folded triangle the nearest landmark that is not where it is to be; each once.
std::vector<int> blockedLandmarks(const Points& places, const Triangles& triangles,
  const std::vector<int>& ids, const Eigen::VectorXd& left, double tolerance)
{
  std::vector<int> blocked;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const auto corners = triangles.row(r);
    if (orientation(places.row(corners[0]), places.row(corners[1]), places.row(corners[2])) <= 0)
    {
      int nearest = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < ids.size(); ++i)
      {
        const double distance = (places.row(ids[i]) - places.row(corners[0])).squaredNorm();
        if (left[static_cast<Index>(i)] > tolerance && distance < least)
        {
          least = distance;
          nearest = static_cast<int>(i);
        }
      }
      blocked.push_back(nearest);
    }
  }
  std::sort(blocked.begin(), blocked.end());
  blocked.erase(std::unique(blocked.begin(), blocked.end()), blocked.end());
  return blocked;
}
}

//------------------------------------------------------------------------------
LandmarkFlowResult flowToLandmarks(const Triangles& triangles, const std::vector<int>& ids,
  const Points& targets, Points& places, const LandmarkFlowOptions& options, const Run& run)
{
  const auto count = static_cast<Index>(ids.size());
  const auto errors = [&]()
  {
    Eigen::VectorXd result(count);
    for (Index i = 0; i < count; ++i)
    {
      result[i] = (places.row(ids[i]) - targets.row(i)).norm();
    }
    return result;
  };
  // Those next to a folded triangle go on by a part of their way, so that the others get theirs.
  Eigen::VectorXd left = errors(), fractions = Eigen::VectorXd::Ones(count);
  std::size_t width = 0;
  double atFirstWidth = left.sum();
  const auto nextWidth = [&]()
  {
    fractions.setOnes();
    ++width;
    if (width == options.Widths.size() && left.sum() < WorthARound * atFirstWidth)
    {
      width = 0;
      atFirstWidth = left.sum();
    }
  };
  for (int step = 0; step < options.MaximumNumberOfSteps && width < options.Widths.size() &&
       count > 0 && left.maxCoeff() > options.Tolerance;
       ++step)
  {
    run.report(static_cast<double>(step) / options.MaximumNumberOfSteps);
    Points centers(count, 3), turns(count, 3);
    for (Index i = 0; i < count; ++i)
    {
      centers.row(i) = places.row(ids[i]);
      turns.row(i) =
        fractions[i] * turnBetween(centers.row(i), targets.row(i), options.LongestStep);
    }
    const TurnField field(centers, turns, options.Widths[width]);
    Points moved(places.rows(), 3);
    constexpr Index blockSize = 1024;
    forBlocks(run, places.rows(), blockSize,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          moved.row(v) = turned(places.row(v), field(places.row(v)));
        }
      });
    const std::vector<int> blocked =
      blockedLandmarks(moved, triangles, ids, left, options.Tolerance);
    bool isShort = true;
    for (const int i : blocked)
    {
      isShort = isShort && fractions[i] <= RepairedFraction;
    }
    if (blocked.empty() || (isShort && options.Repair && options.Repair(moved)))
    {
      std::swap(places, moved);
      const Eigen::VectorXd after = errors();
      if (after.sum() < Nearer * left.sum())
      {
        left = after;
        fractions = (2.0 * fractions).cwiseMin(1.0);
      }
      else
      {
        std::swap(places, moved);
        nextWidth();
      }
      continue;
    }
    bool moves = false;
    for (const int i : blocked)
    {
      fractions[i] = fractions[i] > SmallestFraction ? 0.5 * fractions[i] : 0.0;
    }
    for (Index i = 0; i < count; ++i)
    {
      moves = moves || (fractions[i] > 0.0 && left[i] > options.Tolerance);
    }
    if (!moves ||
      std::all_of(blocked.begin(), blocked.end(), [&](int i) { return fractions[i] == 0.0; }))
    {
      nextWidth();
    }
  }
  run.report(1.0);
  LandmarkFlowResult result;
  result.Error = count > 0 ? left.maxCoeff() : 0.0;
  result.NumberOfUnmet = (left.array() > Met).count();
  return result;
}
}
