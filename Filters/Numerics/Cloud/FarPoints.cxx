#include "Cloud/FarPoints.h"

#include "Base/AcrossProcesses.h"
#include "Cloud/StrayPoints.h"
#include "Search/BoxTree.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace conformal
{
namespace
{
using Place = std::array<double, 3>;

constexpr Index PointsPerBox = 1 << 14;
constexpr Index MinimumPlaces = 20; // fewer positions have no typical distance
constexpr Index SampledPoints = 20000;
constexpr double RadiusQuantile = 0.9;

// Gaps are found in shells of a quarter octave: 8 shells from R to 4 R.
constexpr double Gap = 4.0, Farthest = 32.0;
constexpr int ShellsPerOctave = 4, ShellsOfGap = 8;
constexpr Index MaximumInGap = 3;

constexpr Index AlwaysFew = 32, ShareOfPlaces = 20;

Vector3 quarterOf(const Vector3& x)
{
  return 0.25 * x;
}

double maximumNorm(const Vector3& x)
{
  return x.cwiseAbs().maxCoeff();
}

void removeDuplicates(std::vector<Place>& places)
{
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

// Gather distinct positions of all ranks in an order that does not depend on the ranks.
std::vector<Place> gatherPlaces(const Reduce& reduce, const std::vector<Place>& own)
{
  std::vector<double> numbers;
  numbers.reserve(3 * own.size());
  for (const Place& place : own)
  {
    numbers.insert(numbers.end(), place.begin(), place.end());
  }
  const std::vector<double> all = gather(reduce, numbers);
  std::vector<Place> places(all.size() / 3);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, places[i].begin());
  }
  removeDuplicates(places);
  return places;
}

double quantile(std::vector<double>& values, double share)
{
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// State of one search for far points. All lengths are divided by 4, so that differences do not
/// overflow.
class Search
{
public:
  Search(const PointView& points, const std::function<bool(Index)>& skip, const Reduce& reduce,
    const Run& run)
    : View(points)
    , Skip(skip)
    , Sums(reduce)
    , Threads(run)
    , OfAll(shareOf(reduce, points.size()))
  {
  }

  FarPoints find()
  {
    FarPoints far;
    if (!this->findCloud() || this->extent() <= Gap * this->Radius)
    {
      return far;
    }
    const std::vector<std::int64_t> shells = this->countByShell();
    for (const double reach : { this->beyondGap(shells), Farthest * this->Radius })
    {
      far.QuarterOfCenter = this->Center;
      far.QuarterOfReach = reach;
      if (this->accept(far))
      {
        return far;
      }
    }
    return {};
  }

private:
  bool examines(Index i) const
  {
    return !(this->Skip && this->Skip(i)) && this->View[i].allFinite();
  }

  double distance(const Vector3& quarter) const { return maximumNorm(quarter - this->Center); }

  // Compute center and radius from about SampledPoints points in the order of all ranks.
  bool findCloud()
  {
    const Index stretch = std::max<Index>(1, this->OfAll.Total / SampledPoints);
    const Index first = this->OfAll.Before, last = first + this->View.size();
    std::vector<Place> places;
    for (Index block = first / stretch; block * stretch < last; ++block)
    {
      // Select a point at a varying position of each interval, since the sequence of points of a
      // scan may be periodic.
      const std::uint64_t mixed = static_cast<std::uint64_t>(block) * 0x9e3779b97f4a7c15U;
      const Index id = block * stretch +
        static_cast<Index>((mixed >> 32) % static_cast<std::uint64_t>(stretch)) - first;
      if (id >= 0 && id < this->View.size() && this->examines(id))
      {
        const Vector3 x = quarterOf(this->View[id]);
        places.push_back({ x[0], x[1], x[2] });
      }
    }
    places = gatherPlaces(this->Sums, places);
    if (static_cast<Index>(places.size()) < MinimumPlaces)
    {
      return false;
    }
    std::vector<double> numbers(places.size());
    for (std::size_t c = 0; c < 3; ++c)
    {
      std::transform(
        places.begin(), places.end(), numbers.begin(), [c](const Place& x) { return x[c]; });
      this->Center[static_cast<Index>(c)] = quantile(numbers, 0.5);
    }
    std::transform(places.begin(), places.end(), numbers.begin(),
      [this](const Place& x) { return this->distance(Eigen::Map<const Vector3>(x.data())); });
    this->Radius = quantile(numbers, RadiusQuantile);
    return this->Radius > 0.0;
  }

  // Compute the maximum distance of the bounding box of the points on all ranks.
  double extent() const
  {
    std::vector<Box> boxes((this->View.size() + PointsPerBox - 1) / PointsPerBox);
    forBlocks(this->Threads, this->View.size(), PointsPerBox,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          if (this->examines(i))
          {
            boxes[begin / PointsPerBox].extend(quarterOf(this->View[i]));
          }
        }
      });
    double own = 0.0;
    for (const Box& box : boxes)
    {
      if (box.Lower[0] <= box.Upper[0])
      {
        own = std::max({ own, this->distance(box.Lower), this->distance(box.Upper) });
      }
    }
    return maximum(this->Sums, { own })[0];
  }

  int shellOf(double distance) const
  {
    const double radii = distance / this->Radius;
    if (!(radii > 1.0))
    {
      return 0;
    }
    // Use logarithms, since the quotient of doubles may overflow.
    const double octaves =
      std::isfinite(radii) ? std::log2(radii) : std::log2(distance) - std::log2(this->Radius);
    return 1 + static_cast<int>(octaves * ShellsPerOctave);
  }

  // Count the points of all ranks in each shell.
  std::vector<std::int64_t> countByShell() const
  {
    constexpr int octaves = 2200; // range of doubles, from minimum to maximum
    std::vector<std::int64_t> counts(octaves * ShellsPerOctave, 0);
    for (Index i = 0; i < this->View.size(); ++i)
    {
      if (this->examines(i))
      {
        ++counts[this->shellOf(this->distance(quarterOf(this->View[i])))];
      }
    }
    this->Sums.sum(counts.data(), static_cast<Index>(counts.size()));
    return counts;
  }

  // Find the distance at the end of the first gap. If there is no gap, the result is infinite.
  double beyondGap(const std::vector<std::int64_t>& counts) const
  {
    const auto size = static_cast<int>(counts.size());
    for (int shell = 1; shell + ShellsOfGap < size; ++shell)
    {
      const auto begin = counts.begin() + shell;
      if (std::accumulate(begin, begin + ShellsOfGap, std::int64_t(0)) <= MaximumInGap)
      {
        const double octaves = static_cast<double>(shell - 1 + ShellsOfGap) / ShellsPerOctave;
        return this->Radius * std::exp2(octaves);
      }
    }
    return std::numeric_limits<double>::infinity();
  }

  // Count the points beyond the reach, and test whether they are few or scattered.
  bool accept(FarPoints& far) const
  {
    std::vector<Place> places;
    double nearest = std::numeric_limits<double>::infinity(), maximumCoordinate = 0.0;
    // Numbers of far points, of examined points, and of positions of far points on this rank
    std::int64_t counts[] = { 0, 0, 0 };
    for (Index i = 0; i < this->View.size(); ++i)
    {
      if (!this->examines(i))
      {
        continue;
      }
      ++counts[1];
      const Vector3 x = this->View[i];
      if (far.contains(x))
      {
        ++counts[0];
        nearest = std::min(nearest, this->distance(quarterOf(x)));
        places.push_back({ x[0], x[1], x[2] });
      }
      else
      {
        maximumCoordinate = std::max(maximumCoordinate, maximumNorm(x));
      }
    }
    removeDuplicates(places);
    counts[2] = static_cast<std::int64_t>(places.size());
    this->Sums.sum(counts, 3);
    const Index maximumCount = std::max(AlwaysFew, counts[1] / ShareOfPlaces);
    if (counts[0] == 0 || counts[2] > maximumCount * this->Sums.NumberOfRanks)
    {
      return false;
    }
    places = gatherPlaces(this->Sums, places);
    const auto size = static_cast<Index>(places.size());
    if (size > maximumCount || (size > AlwaysFew && this->isSurface(places)))
    {
      return false;
    }
    far.Count = counts[0];
    far.Total = counts[1];
    far.MaximumCoordinate = maximum(this->Sums, { maximumCoordinate })[0];
    far.Distance = minimum(this->Sums, { nearest })[0].Value / this->Radius;
    return true;
  }

  // Test whether at least a quarter of the positions are flat, with neighbors nearer than the
  // cloud. Outliers at increasing distances from the cloud have neighbors towards the cloud, and
  // would be flat by chance.
  bool isSurface(const std::vector<Place>& places) const
  {
    constexpr Index asked = 2000, share = 4;
    constexpr int neighbors = 8;
    constexpr double near = 0.5; // fraction of the distance from the cloud
    const auto size = static_cast<Index>(places.size());
    Points points(size, 3);
    for (Index i = 0; i < size; ++i)
    {
      points.row(i) =
        quarterOf(Eigen::Map<const Vector3>(places[static_cast<std::size_t>(i)].data())) -
        this->Center;
    }
    points /= points.cwiseAbs().maxCoeff();
    const PointTree tree(points, this->Threads.unwatched());
    const Index stretch = std::max<Index>(1, size / asked);
    std::vector<Neighbor> nearest;
    Index count = 0, flat = 0;
    for (Index i = 0; i < size; i += stretch)
    {
      ++count;
      tree.nearest(points.row(i), neighbors + 1, nearest);
      flat += nearest.back().SquareDistance < near * near * points.row(i).squaredNorm() &&
        liesFlat(points, tree, points.row(i));
    }
    return share * flat >= count;
  }

  const PointView& View;
  const std::function<bool(Index)>& Skip;
  const Reduce& Sums;
  const Run& Threads;
  const Share OfAll;
  Vector3 Center = Vector3::Zero();
  double Radius = 0.0;
};
}

//------------------------------------------------------------------------------
FarPoints findFarPoints(const PointView& points, const std::function<bool(Index)>& skip,
  const Reduce& reduce, const Run& run)
{
  FarPoints far = Search(points, skip, reduce, run).find();
  run.report(1.0);
  return far;
}
}
