#include "Cloud/StrayPoints.h"

#include "Base/Steps.h"
#include "Search/PointTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>

namespace conformal
{
namespace
{
constexpr int Neighbors = StrayLimits::Neighbors;

/// Remove the marks from sparse parts of a surface. The mark of a point is removed if at least a
/// quarter of the nearest marked points pass liesFlat(). For a few points scattered in space, this
/// is unlikely.
void acquitSurfaces(
  const Points& points, const PointTree& tree, std::vector<std::uint8_t>& suspects, const Run& run)
{
  constexpr int jury = 32;
  constexpr double share = 0.25;
  constexpr Index SuspectsPerBlock = 64;
  std::vector<int> ids;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (suspects[i])
    {
      ids.push_back(static_cast<int>(i));
    }
  }
  const auto size = static_cast<Index>(ids.size());
  Points places(size, 3);
  std::vector<std::uint8_t> flat(size), guilty(size);
  forBlocksReporting(run.part(0.0, 0.5), size, SuspectsPerBlock,
    [&](Index begin, Index end)
    {
      for (Index k = begin; k < end; ++k)
      {
        places.row(k) = points.row(ids[k]);
        flat[k] = liesFlat(points, tree, points.row(ids[k]));
      }
    });
  const PointTree others(places, run.unwatched());
  forBlocksReporting(run.part(0.5, 1.0), size, SuspectsPerBlock,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> nearest;
      for (Index k = begin; k < end; ++k)
      {
        others.nearest(places.row(k), jury, nearest);
        const auto count = std::count_if(nearest.begin(), nearest.end(),
          [&](const Neighbor& neighbor) { return flat[neighbor.Id] != 0; });
        guilty[k] = static_cast<double>(count) < share * static_cast<double>(nearest.size());
      }
    });
  for (Index k = 0; k < size; ++k)
  {
    suspects[ids[k]] = guilty[k];
  }
}

// Return the median of the positive numbers; 0 if there are none. Square distances are 0 at points
// with many copies, which show no spacing. The numbers are rearranged.
template <typename Iterator>
double medianOfPositive(Iterator begin, Iterator end)
{
  const Iterator last = std::partition(begin, end, [](double number) { return number > 0.0; });
  if (last == begin)
  {
    return 0.0;
  }
  const Iterator middle = begin + (last - begin) / 2;
  std::nth_element(begin, middle, last);
  return *middle;
}
}

NearestPlane planeNear(const Points& points, const PointTree& tree, const Vector3& place, int count)
{
  std::vector<Neighbor> nearest;
  tree.nearest(place, count + 1, nearest);
  // The nearest point is the point at the position itself.
  const auto others = static_cast<Index>(nearest.size()) - 1;
  Eigen::Matrix<double, 3, Eigen::Dynamic> around(3, others);
  for (Index k = 0; k < others; ++k)
  {
    around.col(k) = points.row(nearest[k + 1].Id).transpose() - place;
  }
  const Vector3 middle = around.rowwise().mean();
  around.colwise() -= middle;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(around * around.transpose() / static_cast<double>(others));
  NearestPlane plane;
  plane.Normal = axes.eigenvectors().col(0);
  plane.Offset = plane.Normal.dot(middle);
  plane.SquareWidths = axes.eigenvalues();
  return plane;
}

bool liesFlat(const Points& points, const PointTree& tree, const Vector3& place)
{
  // Maximum ratio of the variance across the plane to the variance along its second axis
  constexpr double thickness = 0.1;
  for (const int count : { Neighbors, 2 * Neighbors })
  {
    const NearestPlane plane = planeNear(points, tree, place, count);
    const double maximum = thickness * plane.SquareWidths[1];
    if (plane.SquareWidths[0] < maximum && plane.Offset * plane.Offset < maximum)
    {
      return true;
    }
  }
  return false;
}

std::vector<std::uint8_t> strayPoints(const Points& points, const Run& run)
{
  std::vector<std::uint8_t> stray(points.rows(), 0);
  if (points.rows() <= Neighbors)
  {
    return stray;
  }
  Steps steps(run, { 0.1, 0.9 }); // tree, planes
  const PointTree tree(points, steps.next());
  forBlocksReporting(steps.next(), points.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        stray[i] = isSteep(planeNear(points, tree, points.row(i), Neighbors));
      }
    });
  return stray;
}

std::vector<std::uint8_t> isolatedPoints(const Points& points, double farthest, const Run& run)
{
  constexpr double FromNeighbors = StrayLimits::FromNeighbors;
  const Index size = points.rows();
  std::vector<std::uint8_t> isolated(size, 0);
  if (size <= Neighbors)
  {
    return isolated;
  }
  Steps steps(run, { 0.1, 0.84, 0.04, 0.02 });
  const PointTree tree(points, steps.next());
  std::vector<double> squares(size);
  std::vector<std::array<int, Neighbors>> around(size);
  forBlocksReporting(steps.next(), size, HeavyBlock,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> nearest;
      for (Index i = begin; i < end; ++i)
      {
        tree.nearest(points.row(i), Neighbors + 1, nearest);
        squares[i] = nearest.back().SquareDistance;
        for (int k = 0; k < Neighbors; ++k)
        {
          around[i][k] = nearest[k + 1].Id;
        }
      }
    });
  std::vector<double> sorted = squares;
  const double typical = medianOfPositive(sorted.begin(), sorted.end());
  forBlocksReporting(steps.next(), size, HeavyBlock,
    [&](Index begin, Index end)
    {
      std::array<double, Neighbors> theirs;
      for (Index i = begin; i < end; ++i)
      {
        std::transform(around[i].begin(), around[i].end(), theirs.begin(),
          [&](int neighbor) { return squares[neighbor]; });
        const double ofNeighbors = medianOfPositive(theirs.begin(), theirs.end());
        isolated[i] =
          (ofNeighbors > 0.0 && squares[i] > FromNeighbors * FromNeighbors * ofNeighbors) ||
          (typical > 0.0 && squares[i] > farthest * farthest * typical);
      }
    });
  acquitSurfaces(points, tree, isolated, steps.next());
  return isolated;
}
}
