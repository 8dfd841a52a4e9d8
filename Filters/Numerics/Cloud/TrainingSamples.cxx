#include "Cloud/TrainingSamples.h"

#include "Base/AcrossProcesses.h"
#include "Base/MortonOrder.h"
#include "Search/BoxTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace conformal
{
namespace
{
constexpr Index SamplesPerValue = 1 << 12;

/// Mass, first and second moments of the samples, as integer multiples of 2^-50. Each sum has two
/// parts, so that 2^38 numbers of magnitude up to 1 do not overflow. Blocks and ranks may be added
/// in any order.
class Moments
{
public:
  void add(double weight, const Vector3& x)
  {
    Index at = 0;
    this->addNumber(at++, weight);
    for (int c = 0; c < 3; ++c)
    {
      this->addNumber(at++, weight * x[c]);
      for (int d = c; d < 3; ++d)
      {
        this->addNumber(at++, weight * x[c] * x[d]);
      }
    }
  }
  void add(const Moments& other)
  {
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      this->Parts[i] += other.Parts[i];
    }
  }
  void reduce(const Reduce& reduce)
  {
    reduce.sum(this->Parts.data(), static_cast<Index>(this->Parts.size()));
  }
  Vector3 mean() const
  {
    return Vector3(this->number(1), this->number(5), this->number(8)) / this->number(0);
  }
  Eigen::Matrix3d covariance() const
  {
    Eigen::Matrix3d second;
    second << this->number(2), this->number(3), this->number(4), //
      this->number(3), this->number(6), this->number(7),         //
      this->number(4), this->number(7), this->number(9);
    return second / this->number(0) - this->mean() * this->mean().transpose();
  }

private:
  static constexpr int LowBits = 25;
  static constexpr std::int64_t LowMask = (std::int64_t(1) << LowBits) - 1;

  void addNumber(Index at, double value)
  {
    const std::int64_t steps = std::llrint(value * 0x1p50);
    this->Parts[2 * at] += steps >> LowBits;
    this->Parts[2 * at + 1] += steps & LowMask;
  }
  double number(Index at) const
  {
    return static_cast<double>(this->Parts[2 * at]) * 0x1p-25 +
      static_cast<double>(this->Parts[2 * at + 1]) * 0x1p-50;
  }
  std::array<std::int64_t, 20> Parts{};
};

template <typename Value>
std::vector<Value> forEachBlock(
  const Run& run, Index size, const std::function<void(Index begin, Index end, Value& value)>& body)
{
  std::vector<Value> values((size + SamplesPerValue - 1) / SamplesPerValue);
  forBlocksReporting(run, size, SamplesPerValue,
    [&](Index begin, Index end) { body(begin, end, values[begin / SamplesPerValue]); });
  return values;
}
}

TrainingSamples::TrainingSamples(const PointView& points, const NumberView& weights,
  const std::function<bool(Index)>& skip, const Reduce& reduce, const Run& run)
  : View(points)
  , Weights(weights)
  , Sums(reduce)
{
  std::int64_t weighted[] = { weights.size() > 0, weights.size() != points.size() };
  reduce.sum(weighted, 2);
  this->Weighted = weighted[0] > 0;
  if (this->Weighted && weighted[1] > 0)
  {
    throw std::invalid_argument("there must be as many weights as points");
  }
  struct Count
  {
    Index Used = 0, NonFinite = 0;
  };
  const auto used = [&](Index i)
  {
    return !(skip && skip(i)) &&
      (weights.size() == 0 || (weights[i] > 0.0 && std::isfinite(weights[i])));
  };
  const auto counts = forEachBlock<Count>(run.part(0.0, 0.25), points.size(),
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
    this->Kept = KeptIds(points.size(), [&](Index i) { return used(i) && points[i].allFinite(); });
  }
  this->OfAll = shareOf(reduce, this->Size);
  this->NonFinite = shareOf(reduce, this->NonFinite).Total;
  if (!this->empty())
  {
    this->findFrame(run);
  }
}

TrainingSamples TrainingSamples::selected(const std::function<bool(Index)>& keep) const
{
  TrainingSamples result = *this;
  Index sample = 0;
  result.Kept = KeptIds(this->View.size(),
    [&](Index id)
    {
      if (sample == this->Size || this->id(sample) != id)
      {
        return false;
      }
      return keep(this->firstOfTotal() + sample++);
    });
  result.Order = std::make_shared<std::vector<int>>();
  result.Size = result.Kept.size();
  result.OfAll = shareOf(this->Sums, result.Size);
  return result;
}

void TrainingSamples::sortAlongCurve(const Run& run) const
{
  // The samples are in the cube [-1, 1]^3.
  *this->Order = mortonOrder(
    this->Size, [&](Index i) { return Vector3(0.5 * ((*this)[i].array() + 1.0)); }, run);
}

void TrainingSamples::setNormals(const PointView& normals)
{
  if (normals.size() != this->View.size())
  {
    throw std::invalid_argument("there must be as many normals as points");
  }
  this->Normals = normals;
  this->Oriented = true;
}

void TrainingSamples::setPatternValues(const Columns& values)
{
  if (values.cols() != this->View.size())
  {
    throw std::invalid_argument("there must be as many columns of pattern values as points");
  }
  this->PatternValues = &values;
}

void TrainingSamples::setScanners(const PointView& positions)
{
  if (positions.size() != this->View.size() && positions.size() != 1)
  {
    throw std::invalid_argument(
      "there must be one position, or as many positions of scanners as points");
  }
  this->Scanners = positions;
  this->HasScanners = true;
}

Vector3 TrainingSamples::toScanner(Index i) const
{
  const Vector3 scanner = this->Scanners[this->Scanners.size() == 1 ? 0 : this->id(i)];
  return scanner.allFinite() ? Vector3(this->normalize(scanner) - (*this)[i])
                             : Vector3(Vector3::Zero());
}

Points TrainingSamples::normalizeAll(Points points) const
{
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = this->normalize(points.row(i));
  }
  return points;
}

Points TrainingSamples::restoreAll(Points points) const
{
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = this->restore(points.row(i));
  }
  return points;
}

void TrainingSamples::findFrame(const Run& run)
{
  std::vector<double> extremes(7, -std::numeric_limits<double>::infinity());
  if (this->weighted())
  {
    for (Index i = 0; i < this->Size; ++i)
    {
      extremes[6] = std::max(extremes[6], this->Weights[this->id(i)]);
    }
  }
  const auto boxes = forEachBlock<Box>(run.part(0.25, 0.4), this->Size,
    [&](Index begin, Index end, Box& box)
    {
      for (Index i = begin; i < end; ++i)
      {
        box.extend(this->View[this->id(i)]);
      }
    });
  for (const Box& box : boxes)
  {
    for (int c = 0; c < 3; ++c)
    {
      extremes[c] = std::max(extremes[c], -box.Lower[c]);
      extremes[3 + c] = std::max(extremes[3 + c], box.Upper[c]);
    }
  }
  extremes = maximum(this->Sums, extremes);
  this->MaximumWeight = this->weighted() ? extremes[6] : 1.0;
  const Vector3 lower(-extremes[0], -extremes[1], -extremes[2]);
  const Vector3 upper(extremes[3], extremes[4], extremes[5]);
  // Compute the sums in the unit box first. Otherwise, sums of very large coordinates would
  // overflow, sums of very small ones would underflow, and sums of very distant ones would lose
  // digits. Halved coordinates also avoid overflow.
  this->Center = 0.5 * lower + 0.5 * upper;
  const double half = (0.5 * upper - 0.5 * lower).maxCoeff();
  this->Scale = half > 0.0 ? half : 1.0;

  const auto moments = forEachBlock<Moments>(run.part(0.4, 0.8), this->Size,
    [&](Index begin, Index end, Moments& sum)
    {
      for (Index i = begin; i < end; ++i)
      {
        sum.add(this->weight(i), (*this)[i]);
      }
    });
  Moments total;
  for (const Moments& sum : moments)
  {
    total.add(sum);
  }
  total.reduce(this->Sums);
  const Vector3 spread =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(total.covariance(), Eigen::EigenvaluesOnly)
      .eigenvalues();
  // Square of the relative thickness 1e-7 below which a cloud is regarded as flat
  constexpr double Negligible = 1e-14;
  this->Dimension = half > 0.0 ? static_cast<int>((spread.array() > Negligible).count()) : 0;

  const Vector3 centroid = this->Center + this->Scale * total.mean();
  const auto squares = forEachBlock<double>(run.part(0.8, 1.0), this->Size,
    [&](Index begin, Index end, double& square)
    {
      for (Index i = begin; i < end; ++i)
      {
        square =
          std::max(square, ((this->View[this->id(i)] - centroid) / this->Scale).squaredNorm());
      }
    });
  const double squareRadius = maximum(this->Sums,
    { std::accumulate(
      squares.begin(), squares.end(), 0.0, [](double a, double b) { return std::max(a, b); }) })[0];
  this->Center = centroid;
  this->Scale *= squareRadius > 0.0 ? std::sqrt(squareRadius) : 1.0;
}
}
