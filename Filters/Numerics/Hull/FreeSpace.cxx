#include "Hull/FreeSpace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace conformal
{
namespace
{
constexpr double NodesOfSpacing = 2.0;    // distance of coarse nodes, in spacings of the points
constexpr double NearnessOfSpacing = 1.5; // minimum distance of marks from points, in coarse nodes
constexpr double NearnessOfNoise = 4.0;   // or in standard deviations of the noise
constexpr double StepOfNode = 0.5;        // between marks along a ray, in coarse nodes
constexpr Index PointsPerReport = 4096;

constexpr std::uint8_t Unknown = 0, Free = 1, NearPoint = 2;

// Make a coarse grid that covers a grid.
FreudenthalGrid coarseGridOf(const FreudenthalGrid& grid, double spacing)
{
  FreudenthalGrid coarse;
  coarse.Origin = grid.Origin;
  coarse.Spacing = std::max(spacing, grid.Spacing);
  for (int axis = 0; axis < 3; ++axis)
  {
    coarse.Size[axis] =
      static_cast<int>(std::ceil((grid.Size[axis] - 1) * grid.Spacing / coarse.Spacing)) + 2;
  }
  return coarse;
}

bool contains(const FreudenthalGrid& grid, const Eigen::Vector3i& node)
{
  const Eigen::Map<const Eigen::Vector3i> size(grid.Size.data());
  return (node.array() >= 0).all() && (node.array() < size.array()).all();
}

// Mark the nodes along the ray from a point to its scanner, or to the end of the grid.
void markRay(const FreudenthalGrid& grid, const Vector3& point, const Vector3& toScanner,
  std::vector<std::uint8_t>& marks)
{
  const double length = toScanner.norm();
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return;
  }
  const Vector3 step = StepOfNode * grid.Spacing / length * toScanner;
  const double count = length / (StepOfNode * grid.Spacing);
  for (double k = 1.0; k <= count; k += 1.0)
  {
    const Eigen::Vector3i at = grid.toGrid(point + k * step).array().round().cast<int>();
    if (!contains(grid, at))
    {
      break;
    }
    std::uint8_t& mark = marks[grid.node(at[0], at[1], at[2])];
    mark = mark == Unknown ? Free : mark;
  }
}

// Interpolate the marks of a coarse grid linearly at the nodes of a finer grid.
std::vector<float> interpolated(const FreudenthalGrid& grid, const FreudenthalGrid& coarse,
  const std::vector<std::uint8_t>& marks, const Run& run)
{
  std::vector<float> values(grid.numberOfNodes());
  const std::array<int, 8> corners = coarse.cornerSteps();
  forBlocks(run, grid.Size[2], 1,
    [&](Index begin, Index)
    {
      const int z = static_cast<int>(begin);
      for (int y = 0; y < grid.Size[1]; ++y)
      {
        for (int x = 0; x < grid.Size[0]; ++x)
        {
          const Vector3 at = grid.Spacing / coarse.Spacing * Vector3(x, y, z);
          const Eigen::Vector3i low = at.array().floor().cast<int>();
          const Vector3 t = at - low.cast<double>();
          const int first = coarse.node(low[0], low[1], low[2]);
          double sum = 0.0;
          for (int c = 0; c < 8; ++c)
          {
            if (marks[first + corners[c]] == Free)
            {
              sum += ((c & 1) ? t[0] : 1.0 - t[0]) * ((c & 2) ? t[1] : 1.0 - t[1]) *
                ((c & 4) ? t[2] : 1.0 - t[2]);
            }
          }
          values[grid.node(x, y, z)] = static_cast<float>(sum);
        }
      }
    });
  return values;
}
}

//------------------------------------------------------------------------------
std::vector<float> freeSpace(const FreudenthalGrid& grid, const Points& points,
  const Points& toScanner, double spacing, double noise, const Run& run)
{
  const FreudenthalGrid coarse = coarseGridOf(grid, NodesOfSpacing * spacing);
  const double nearness = std::max(NearnessOfSpacing * coarse.Spacing, NearnessOfNoise * noise);
  std::vector<std::uint8_t> marks(coarse.numberOfNodes(), Unknown);
  for (Index i = 0; i < points.rows(); ++i)
  {
    forNodesNear(coarse, coarse.toGrid(points.row(i)), nearness / coarse.Spacing, 0,
      [&](int node) { marks[node] = NearPoint; });
  }
  for (Index i = 0; i < points.rows(); ++i)
  {
    markRay(coarse, points.row(i), toScanner.row(i), marks);
    if (i % PointsPerReport == 0)
    {
      run.report(0.5 * static_cast<double>(i) / static_cast<double>(points.rows()));
    }
  }
  return interpolated(grid, coarse, marks, run);
}
}
