#include "Sphere/LandmarkFlow.h"

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
constexpr double MinimumFraction = 1.0 / 64.0;
constexpr double WorthARound = 0.95;  // maximum ratio of distances after and before a round
constexpr double Nearer = 1.0 - 1e-6; // maximum ratio of distances after and before a step

// Compute the rotation vector from one direction to another. Its length is at most `limit`.
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

// Vector field on the sphere: a sum of Gaussian functions that has given values at the landmarks.
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
    // Keep the system regular if landmarks are much closer together than the width.
    constexpr double ridge = 1e-10;
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

// Find landmarks that are blocked: for each folded triangle, the nearest landmark that has not
// reached its target. No landmark is returned twice.
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
      double minimum = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < ids.size(); ++i)
      {
        const double distance = (places.row(ids[i]) - places.row(corners[0])).squaredNorm();
        if (left[static_cast<Index>(i)] > tolerance && distance < minimum)
        {
          minimum = distance;
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

// Flow of vertices that moves some of them, the landmarks, to their targets step by step.
class LandmarkFlow
{
public:
  LandmarkFlow(const Triangles& triangles, const std::vector<int>& ids, const Points& targets,
    Points& places, const LandmarkFlowOptions& options)
    : Corners(triangles)
    , Ids(ids)
    , Targets(targets)
    , Places(places)
    , Options(options)
    , Left(this->distances())
    , Fractions(Eigen::VectorXd::Ones(this->Left.size()))
    , LeftAtFirstWidth(this->Left.sum())
  {
  }

  const Eigen::VectorXd& left() const { return this->Left; }

  bool isOver() const
  {
    return this->Width >= this->Options.Widths.size() || this->Left.size() == 0 ||
      !(this->Left.maxCoeff() > this->Options.Tolerance);
  }

  // Move the vertices. If the move would fold triangles, shorten the steps of blocked landmarks
  // instead.
  void step(const Run& run)
  {
    Points moved = this->moved(run);
    const std::vector<int> blocked =
      blockedLandmarks(moved, this->Corners, this->Ids, this->Left, this->Options.Tolerance);
    const bool isShort = std::all_of(blocked.begin(), blocked.end(),
      [&](int i) { return this->Fractions[i] <= RepairedFraction; });
    if (blocked.empty() || (isShort && this->Options.Repair && this->Options.Repair(moved)))
    {
      this->accept(moved);
    }
    else
    {
      this->shorten(blocked);
    }
  }

private:
  // Compute the distance between each landmark and its target.
  Eigen::VectorXd distances() const
  {
    Eigen::VectorXd result(static_cast<Index>(this->Ids.size()));
    for (Index i = 0; i < result.size(); ++i)
    {
      result[i] = (this->Places.row(this->Ids[i]) - this->Targets.row(i)).norm();
    }
    return result;
  }

  Points moved(const Run& run) const
  {
    const Index count = this->Left.size();
    Points centers(count, 3), turns(count, 3);
    for (Index i = 0; i < count; ++i)
    {
      centers.row(i) = this->Places.row(this->Ids[i]);
      turns.row(i) = this->Fractions[i] *
        turnBetween(centers.row(i), this->Targets.row(i), this->Options.LongestStep);
    }
    const TurnField field(centers, turns, this->Options.Widths[this->Width]);
    Points moved(this->Places.rows(), 3);
    constexpr Index blockSize = 1024;
    forBlocks(run, this->Places.rows(), blockSize,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          moved.row(v) = turned(this->Places.row(v), field(this->Places.row(v)));
        }
      });
    return moved;
  }

  // Accept a step if it brings the landmarks closer to their targets. Otherwise, reject it and
  // continue with the next width.
  void accept(Points& moved)
  {
    std::swap(this->Places, moved);
    const Eigen::VectorXd after = this->distances();
    if (after.sum() < Nearer * this->Left.sum())
    {
      this->Left = after;
      this->Fractions = (2.0 * this->Fractions).cwiseMin(1.0);
    }
    else
    {
      std::swap(this->Places, moved);
      this->nextWidth();
    }
  }

  // Shorten the steps of landmarks next to folded triangles, so that other landmarks can proceed.
  void shorten(const std::vector<int>& blocked)
  {
    for (const int i : blocked)
    {
      this->Fractions[i] = this->Fractions[i] > MinimumFraction ? 0.5 * this->Fractions[i] : 0.0;
    }
    bool moves = false;
    for (Index i = 0; i < this->Left.size(); ++i)
    {
      moves = moves || (this->Fractions[i] > 0.0 && this->Left[i] > this->Options.Tolerance);
    }
    if (!moves ||
      std::all_of(blocked.begin(), blocked.end(), [&](int i) { return this->Fractions[i] == 0.0; }))
    {
      this->nextWidth();
    }
  }

  // Select the next width. After the last width, return to the first width if the total distance
  // decreased by at least 5 percent.
  void nextWidth()
  {
    this->Fractions.setOnes();
    ++this->Width;
    if (this->Width == this->Options.Widths.size() &&
      this->Left.sum() < WorthARound * this->LeftAtFirstWidth)
    {
      this->Width = 0;
      this->LeftAtFirstWidth = this->Left.sum();
    }
  }

  const Triangles& Corners;
  const std::vector<int>& Ids;
  const Points& Targets;
  Points& Places;
  const LandmarkFlowOptions& Options;
  Eigen::VectorXd Left; // remaining distances of the landmarks
  // Fraction of the remaining distance that each landmark moves in a step.
  Eigen::VectorXd Fractions;
  std::size_t Width = 0;
  double LeftAtFirstWidth;
};
}

//------------------------------------------------------------------------------
LandmarkFlowResult flowToLandmarks(const Triangles& triangles, const std::vector<int>& ids,
  const Points& targets, Points& places, const LandmarkFlowOptions& options, const Run& run)
{
  LandmarkFlow flow(triangles, ids, targets, places, options);
  for (int step = 0; step < options.MaximumNumberOfSteps && !flow.isOver(); ++step)
  {
    run.report(static_cast<double>(step) / options.MaximumNumberOfSteps);
    flow.step(run);
  }
  run.report(1.0);
  LandmarkFlowResult result;
  result.Error = ids.empty() ? 0.0 : flow.left().maxCoeff();
  result.NumberOfUnmet = (flow.left().array() > Met).count();
  return result;
}
}
