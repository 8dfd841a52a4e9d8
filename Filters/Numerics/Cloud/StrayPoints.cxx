#include "Cloud/StrayPoints.h"

#include "Base/Steps.h"
#include "Search/PointTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>

namespace conformal
{
std::vector<std::uint8_t> strayPoints(const Points& points, const Run& run)
{
  constexpr int Neighbors = 8;
  constexpr double Steepness = 0.8;
  constexpr Index BlockSize = 256;
  std::vector<std::uint8_t> stray(points.rows(), 0);
  if (points.rows() <= Neighbors)
  {
    return stray;
  }
  Steps steps(run, { 160.0, 1550.0 }); // for each point
  const PointTree tree(points, steps.next());
  forBlocksReporting(steps.next(), points.rows(), BlockSize,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> nearest;
      Eigen::Matrix<double, 3, Neighbors> around;
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 x = points.row(i);
        tree.nearest(x, Neighbors + 1, nearest);
        for (int k = 0; k < Neighbors; ++k)
        {
          // The first is the point itself, or one at the same place.
          around.col(k) = points.row(nearest[k + 1].Id).transpose() - x;
        }
        const Vector3 middle = around.rowwise().mean();
        around.colwise() -= middle;
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
        axes.computeDirect(around * around.transpose() / Neighbors);
        const double width = axes.eigenvalues()[1] + axes.eigenvalues()[2]; // ascending
        const double offset = axes.eigenvectors().col(0).dot(middle);
        stray[i] = offset * offset > Steepness * Steepness * width;
      }
    });
  return stray;
}

std::vector<std::uint8_t> isolatedPoints(const Points& points, const Run& run)
{
  constexpr int Neighbors = 8;
  constexpr double FromNeighbors = 3.0, FromAll = 8.0;
  constexpr Index BlockSize = 256;
  const Index size = points.rows();
  std::vector<std::uint8_t> isolated(size, 0);
  if (size <= Neighbors)
  {
    return isolated;
  }
  Steps steps(run, { 160.0, 1400.0, 60.0 }); // for each point
  const PointTree tree(points, steps.next());
  std::vector<double> squares(size);
  std::vector<std::array<int, Neighbors>> around(size);
  forBlocksReporting(steps.next(), size, BlockSize,
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
  std::nth_element(sorted.begin(), sorted.begin() + size / 2, sorted.end());
  const double typical = sorted[size / 2];
  forBlocksReporting(steps.next(), size, BlockSize,
    [&](Index begin, Index end)
    {
      std::array<double, Neighbors> theirs;
      for (Index i = begin; i < end; ++i)
      {
        std::transform(around[i].begin(), around[i].end(), theirs.begin(),
          [&](int neighbor) { return squares[neighbor]; });
        std::nth_element(theirs.begin(), theirs.begin() + Neighbors / 2, theirs.end());
        isolated[i] = squares[i] > FromNeighbors * FromNeighbors * theirs[Neighbors / 2] ||
          squares[i] > FromAll * FromAll * typical;
      }
    });
  return isolated;
}
}
