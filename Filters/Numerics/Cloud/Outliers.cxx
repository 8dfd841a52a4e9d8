#include "Cloud/Outliers.h"

#include "Base/Steps.h"
#include "Cloud/CloudThinning.h"
#include "Cloud/StrayPoints.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace conformal
{
namespace
{
// Few samples suffice to find that there are no outliers. Sparse parts of a surface have more marks
// among few samples than among many.
constexpr double ExaminedSamples = 10000.0, MarkedSamples = 50000.0;
constexpr double ShareOfOutliers = 0.005;
// Median distances, see isolatedPoints(). Many outliers are close to each other, so the limit is
// lower once there are outliers.
constexpr double FarthestPoint = 8.0, FarthestAmongOutliers = 5.0;
constexpr int MaximumRounds = 8;
constexpr double FewMarked = 0.001; // share of the samples that ends the rounds

Index countMarks(const std::vector<std::uint8_t>& marks)
{
  return static_cast<Index>(std::count(marks.begin(), marks.end(), 1));
}

bool hasOutliers(const TrainingSamples& samples, double examined, const Run& run)
{
  const Points points = selectSamples(samples, examined).Positions;
  return static_cast<double>(countMarks(isolatedPoints(points, FarthestPoint, run))) >=
    ShareOfOutliers * static_cast<double>(points.rows());
}

// Return samples without outliers, equal on all ranks.
Points cleanSamples(const TrainingSamples& samples, const Run& run)
{
  OrientedPoints cloud;
  cloud.Positions = selectSamples(samples, MarkedSamples).Positions;
  for (int round = 0; round < MaximumRounds; ++round)
  {
    const Index before = cloud.Positions.rows();
    cloud = without(cloud, isolatedPoints(cloud.Positions, FarthestAmongOutliers, run.unwatched()));
    cloud = without(cloud, strayPoints(cloud.Positions, run.unwatched()));
    run.report(static_cast<double>(round + 1) / MaximumRounds);
    if (static_cast<double>(before - cloud.Positions.rows()) <
      FewMarked * static_cast<double>(before))
    {
      break;
    }
  }
  return std::move(cloud.Positions);
}

// Test of samples by their neighbors among clean samples.
class OutlierTest
{
public:
  OutlierTest(const Points& clean, const Run& run)
    : Clean(clean)
    , Tree(clean, run.unwatched())
    , Squares(clean.rows())
  {
    forBlocks(run, clean.rows(), HeavyBlock,
      [&](Index begin, Index end)
      {
        std::vector<Neighbor> nearest;
        for (Index i = begin; i < end; ++i)
        {
          this->Tree.nearest(clean.row(i), StrayLimits::Neighbors + 1, nearest);
          this->Squares[i] = nearest.back().SquareDistance;
        }
      });
  }

  bool operator()(const Vector3& x) const
  {
    const Neighbor nearest = this->Tree.nearest(x);
    if (nearest.SquareDistance == 0.0)
    {
      return false;
    }
    constexpr double limit = StrayLimits::FromNeighbors * StrayLimits::FromNeighbors;
    return nearest.SquareDistance > limit * this->Squares[nearest.Id] ||
      isSteep(planeNear(this->Clean, this->Tree, x, StrayLimits::Neighbors));
  }

private:
  const Points& Clean;
  const PointTree Tree;
  std::vector<double> Squares; // distances to the eighth neighbor
};
}

//------------------------------------------------------------------------------
TrainingSamples withoutOutliers(const TrainingSamples& samples, const Run& run)
{
  Steps steps(run, { 0.1, 0.1, 0.5, 0.3 }); // two examinations, clean samples, all samples
  if (samples.dimension() < 3 || !hasOutliers(samples, ExaminedSamples, steps.next()) ||
    !hasOutliers(samples, MarkedSamples, steps.next()))
  {
    return samples;
  }
  const Points clean = cleanSamples(samples, steps.next());
  if (clean.rows() <= StrayLimits::Neighbors)
  {
    return samples;
  }
  const OutlierTest isOutlier(clean, run.unwatched());
  std::vector<std::uint8_t> marks(samples.size());
  forBlocksReporting(steps.next(), samples.size(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        marks[i] = isOutlier(samples[i]);
      }
    });
  const Index first = samples.firstOfTotal();
  return samples.selected([&](Index i) { return !marks[i - first]; });
}
}
