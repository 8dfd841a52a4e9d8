#include "Register/LandmarkFlow.h"

#include "Sphere/SphereOrientation.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr double Met = 1e-6;
constexpr double RepairedFraction = 0.25;
constexpr double SmallestFraction = 1.0 / 64.0;

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
  Eigen::VectorXd left = errors();
  std::size_t width = 0;
  double fraction = 1.0;
  for (int step = 0; step < options.MaximumNumberOfSteps && width < options.Widths.size() &&
       count > 0 && left.maxCoeff() > options.Tolerance;
       ++step)
  {
    run.report(static_cast<double>(step) / options.MaximumNumberOfSteps);
    Points centers(count, 3), turns(count, 3);
    for (Index i = 0; i < count; ++i)
    {
      centers.row(i) = places.row(ids[i]);
      turns.row(i) = fraction * turnBetween(centers.row(i), targets.row(i), options.LongestStep);
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
    const bool isShort = fraction <= RepairedFraction;
    if (countFlippedTriangles(moved, triangles) == 0 ||
      (isShort && options.Repair && options.Repair(moved)))
    {
      std::swap(places, moved);
      const Eigen::VectorXd after = errors();
      const bool nearer = after.sum() < left.sum();
      if (!nearer)
      {
        std::swap(places, moved);
        ++width;
      }
      left = nearer ? after : left;
      fraction = std::min(1.0, 2.0 * fraction);
    }
    else if (fraction > SmallestFraction)
    {
      fraction *= 0.5;
    }
    else
    {
      fraction = 1.0;
      ++width;
    }
  }
  run.report(1.0);
  LandmarkFlowResult result;
  result.Error = count > 0 ? left.maxCoeff() : 0.0;
  result.NumberOfUnmet = (left.array() > Met).count();
  return result;
}
}
