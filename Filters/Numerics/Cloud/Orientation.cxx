#include "Cloud/Orientation.h"

#include "Base/Steps.h"
#include "Cloud/StrayPoints.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr int NumberOfNeighbors = 8;

double middleOf(std::vector<double> numbers)
{
  const auto middle = numbers.begin() + static_cast<Index>(numbers.size()) / 2;
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}
}

//------------------------------------------------------------------------------
Points orient(const WindingNumbers& cloud, const OrientationOptions& options, const Run& run)
{
  const Index size = cloud.size();
  const Eigen::VectorXd weights = sparsityOf(cloud.points(), run);
  Points areas = Points::Zero(size, 3);
  for (int i = 0; i < options.NumberOfIterations; ++i)
  {
    const double way = i / std::max(1.0, options.NumberOfIterations - 1.0);
    const double width = options.FirstWidth + way * (options.LastWidth - options.FirstWidth);
    const Eigen::VectorXd missing =
      Eigen::VectorXd::Constant(size, 0.5) - cloud.atPoints(areas, width, run);
    const Points gradient = cloud.transposed(weights.cwiseProduct(missing), width, run);
    const Points step = weights.asDiagonal() * gradient;
    const double rise = cloud.atPoints(step, width, run).cwiseAbs2().dot(weights);
    if (!(rise > 0.0))
    {
      break; // converged, or no descent is possible
    }
    areas += gradient.cwiseProduct(step).sum() / rise * step;
    const Points descent = cloud.descentAtPoints(areas, width, run);
    for (Index k = 0; k < size; ++k)
    {
      const double steepness = descent.row(k).norm();
      if (steepness > 0.0)
      {
        areas.row(k) = areas.row(k).norm() / steepness * descent.row(k);
      }
    }
    run.report((i + 1.0) / options.NumberOfIterations);
  }
  return areas;
}

//------------------------------------------------------------------------------
std::vector<double> areasOfPoints(const Points& points, const Run& run)
{
  constexpr Index blockSize = 256;
  std::vector<double> areas(points.rows(), 0.0);
  const Index neighbors = std::min<Index>(NumberOfNeighbors, points.rows() - 1);
  if (neighbors < 1)
  {
    return areas;
  }
  Steps steps(run, { 0.1, 0.9 });
  const PointTree tree(points, steps.next());
  forBlocksReporting(steps.next(), points.rows(), blockSize,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> nearest;
      for (Index i = begin; i < end; ++i)
      {
        tree.nearest(points.row(i), static_cast<int>(neighbors) + 1, nearest);
        areas[i] = Pi * nearest.back().SquareDistance / static_cast<double>(neighbors);
      }
    });
  return areas;
}

//------------------------------------------------------------------------------
Eigen::VectorXd sparsityOf(const Points& points, const Run& run)
{
  constexpr double notEven = 4.0, far = 2.5;
  const std::vector<double> areas = areasOfPoints(points, run.unwatched());
  const std::vector<std::uint8_t> isolated = isolatedPoints(points, far, run.unwatched());
  const double typical = areas.empty() ? 0.0 : middleOf(areas);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(points.rows());
  for (Index i = 0; i < points.rows() && typical > 0.0; ++i)
  {
    if (!isolated[i] && areas[i] > notEven * typical)
    {
      weights[i] = areas[i] / typical;
    }
  }
  return weights;
}

//------------------------------------------------------------------------------
Points areaVectors(const Points& points, const Points& normals, const Run& run)
{
  const std::vector<double> areas = areasOfPoints(points, run);
  return Eigen::Map<const Eigen::VectorXd>(areas.data(), points.rows()).asDiagonal() * normals;
}

//------------------------------------------------------------------------------
bool turnOutward(const WindingNumbers& cloud, Points& areas, double width, const Run& run)
{
  // Winding numbers are 1/2 at the points of a complete surface. They are lower near large holes,
  // and if the noise exceeds the distance between points. They are about zero if normals have
  // random signs.
  constexpr double telling = 0.15, majority = 0.9;
  if (cloud.size() == 0)
  {
    return false;
  }
  const Eigen::VectorXd numbers = cloud.atPoints(areas, width, run);
  const double middle = middleOf({ numbers.data(), numbers.data() + numbers.size() });
  if (middle < 0.0)
  {
    areas = -areas;
  }
  const auto agreeing = static_cast<double>((numbers.array() * middle > 0.0).count());
  return std::abs(middle) > telling && agreeing > majority * static_cast<double>(cloud.size());
}

//------------------------------------------------------------------------------
PointNoise noiseOf(const Points& points, const Points& areas, const Run& run)
{
  constexpr int neighbors = 16;
  constexpr Index blockSize = 256;
  // Standard deviation of a normal distribution, divided by the median of the absolute value
  constexpr double toDeviation = 1.4826;
  const Index size = points.rows();
  PointNoise noise;
  noise.Offsets = Eigen::VectorXd::Zero(size);
  if (size <= neighbors)
  {
    return noise;
  }
  Steps steps(run, { 0.06, 0.94 });
  const PointTree tree(points, steps.next());
  std::vector<std::vector<int>> around(size);
  forBlocksReporting(steps.next(), size, blockSize,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> nearest;
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 x = points.row(i), n = Vector3(areas.row(i)).stableNormalized();
        tree.nearest(x, neighbors + 1, nearest);
        double sum = 0.0;
        for (const Neighbor& neighbor : nearest)
        {
          if (neighbor.Id != i && n.dot(areas.row(neighbor.Id)) > 0.0)
          {
            around[i].push_back(neighbor.Id);
            sum += n.dot(Vector3(points.row(neighbor.Id)) - x);
          }
        }
        noise.Offsets[i] = around[i].empty() ? 0.0 : sum / static_cast<double>(around[i].size());
      }
    });
  // The bending of the surface causes nearly equal offsets of neighboring points.
  std::vector<double> differences(size, 0.0);
  for (Index i = 0; i < size; ++i)
  {
    double sum = 0.0;
    for (const int neighbor : around[i])
    {
      sum += noise.Offsets[neighbor];
    }
    differences[i] = around[i].empty()
      ? 0.0
      : std::abs(noise.Offsets[i] - sum / static_cast<double>(around[i].size()));
  }
  noise.Deviation = toDeviation * middleOf(differences);
  return noise;
}

//------------------------------------------------------------------------------
double typicalSpacing(const Points& points, const Run& run)
{
  if (points.rows() < 2)
  {
    return 0.0;
  }
  return std::sqrt(middleOf(areasOfPoints(points, run)));
}
}
