#include "TrainingSamples.h"

#include "BoxTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
constexpr Index BlockSize = 1 << 16;

// Sums of one block; blocks are added up in their order, whoever computed them.
struct Moments
{
  double Mass = 0.0;
  Vector3 First = Vector3::Zero();
  Eigen::Matrix3d Second = Eigen::Matrix3d::Zero();
  double SquareRadius = 0.0;
};

template <typename Value>
std::vector<Value> forEachBlock(const ParallelFor& parallelFor, Index size,
  const std::function<void(Index begin, Index end, Value& value)>& body)
{
  std::vector<Value> values((size + BlockSize - 1) / BlockSize);
  forBlocks(parallelFor, size, BlockSize,
    [&](Index begin, Index end) { body(begin, end, values[begin / BlockSize]); });
  return values;
}
}

TrainingSamples::TrainingSamples(const PointView& points, const std::vector<double>& weights,
  const std::function<bool(Index)>& skip, const ParallelFor& parallelFor)
  : View(points)
  , Weights(weights)
{
  if (!weights.empty() && static_cast<Index>(weights.size()) != points.size())
  {
    throw std::invalid_argument("there must be as many weights as points");
  }
  struct Count
  {
    Index Used = 0, NonFinite = 0;
  };
  const auto used = [&](Index i)
  { return !(skip && skip(i)) && (weights.empty() || weights[i] > 0.0); };
  const auto counts = forEachBlock<Count>(parallelFor, points.size(),
    [&](Index begin, Index end, Count& count)
    {
      for (Index i = begin; i < end; ++i)
      {
        if (used(i))
        {
          const bool finite = points[i].allFinite();
          count.Used += finite;
          count.NonFinite += !finite;
        }
      }
    });
  for (const Count& count : counts)
  {
    this->Size += count.Used;
    this->NonFinite += count.NonFinite;
  }
  if (this->Size < points.size())
  {
    this->Ids.reserve(this->Size);
    for (Index i = 0; i < points.size(); ++i)
    {
      if (used(i) && points[i].allFinite())
      {
        this->Ids.push_back(i);
      }
    }
  }
  if (this->Size > 0)
  {
    this->findFrame(parallelFor);
  }
}

void TrainingSamples::findFrame(const ParallelFor& parallelFor)
{
  if (this->weighted())
  {
    this->LargestWeight = 0.0;
    for (Index i = 0; i < this->Size; ++i)
    {
      this->LargestWeight = std::max(this->LargestWeight, this->Weights[this->id(i)]);
    }
  }
  const auto boxes = forEachBlock<Box>(parallelFor, this->Size,
    [&](Index begin, Index end, Box& box)
    {
      for (Index i = begin; i < end; ++i)
      {
        box.extend(this->View[this->id(i)]);
      }
    });
  Box bounds;
  for (const Box& box : boxes)
  {
    bounds.extend(box);
  }
  // First in the box's own unit: sums of very large, very small or very distant coordinates would
  // overflow, vanish or lose their digits. Halves first, for the same reason.
  this->Center = 0.5 * bounds.Lower + 0.5 * bounds.Upper;
  const double half = (0.5 * bounds.Upper - 0.5 * bounds.Lower).maxCoeff();
  this->Scale = half > 0.0 ? half : 1.0;

  const auto moments = forEachBlock<Moments>(parallelFor, this->Size,
    [&](Index begin, Index end, Moments& sum)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 x = (*this)[i];
        const double weight = this->weight(i);
        sum.Mass += weight;
        sum.First += weight * x;
        sum.Second += weight * x * x.transpose();
      }
    });
  Moments total;
  for (const Moments& sum : moments)
  {
    total.Mass += sum.Mass;
    total.First += sum.First;
    total.Second += sum.Second;
  }
  const Vector3 mean = total.First / total.Mass;
  const Eigen::Matrix3d covariance = total.Second / total.Mass - mean * mean.transpose();
  const Vector3 spread =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly)
      .eigenvalues();
  constexpr double Negligible = 1e-14; // square of a thickness of 1e-7
  this->Rank = half > 0.0 ? static_cast<int>((spread.array() > Negligible).count()) : 0;

  const Vector3 centroid = this->Center + this->Scale * mean;
  const auto radii = forEachBlock<Moments>(parallelFor, this->Size,
    [&](Index begin, Index end, Moments& sum)
    {
      for (Index i = begin; i < end; ++i)
      {
        sum.SquareRadius = std::max(
          sum.SquareRadius, ((this->View[this->id(i)] - centroid) / this->Scale).squaredNorm());
      }
    });
  for (const Moments& sum : radii)
  {
    total.SquareRadius = std::max(total.SquareRadius, sum.SquareRadius);
  }
  this->Center = centroid;
  this->Scale *= total.SquareRadius > 0.0 ? std::sqrt(total.SquareRadius) : 1.0;
}
}
