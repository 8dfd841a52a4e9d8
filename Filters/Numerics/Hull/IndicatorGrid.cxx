#include "Hull/IndicatorGrid.h"

#include "Base/Steps.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr int Stride = 4; // between the nodes of the coarse grid
constexpr int NodesPerCube = Stride * Stride * Stride;
constexpr double Nearness = 1.5;       // spacings from a point
constexpr double MarginOfLevel = 0.15; // tolerance, since corners of a cube may miss its content
constexpr Index CubesPerChunk = 1 << 12, CoarsePerChunk = 1 << 16;

using Triple = std::array<int, 3>;

// Every fourth node along each axis, up to one at or beyond the last.
struct CoarseGrid
{
  explicit CoarseGrid(const FreudenthalGrid& grid)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Size[axis] = (grid.Size[axis] - 2) / Stride + 2;
    }
  }
  Index numberOfNodes() const
  {
    return static_cast<Index>(this->Size[0]) * this->Size[1] * this->Size[2];
  }
  Index node(int x, int y, int z) const
  {
    return x + this->Size[0] * (y + static_cast<Index>(this->Size[1]) * z);
  }
  Triple coordinates(Index node) const
  {
    const Index row = node / this->Size[0];
    return { static_cast<int>(node % this->Size[0]), static_cast<int>(row % this->Size[1]),
      static_cast<int>(row / this->Size[1]) };
  }

  Triple Size;
};

double middleOf(const Eigen::VectorXd& values)
{
  std::vector<double> numbers(values.data(), values.data() + values.size());
  const auto middle = numbers.begin() + static_cast<Index>(numbers.size()) / 2;
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

// Call body(x) for all nodes from low up to, but not including, high; along x first.
template <typename Body>
void forNodes(const Triple& low, const Triple& high, const Body& body)
{
  Triple x;
  for (x[2] = low[2]; x[2] < high[2]; ++x[2])
  {
    for (x[1] = low[1]; x[1] < high[1]; ++x[1])
    {
      for (x[0] = low[0]; x[0] < high[0]; ++x[0])
      {
        body(x);
      }
    }
  }
}

// List the nodes of a coarse grid cube by cube. WindingNumbers::at() needs runs of 64 nodes that
// lie close together, and a cube of 4 x 4 x 4 nodes is such a run.
std::vector<Index> nodesByCubes(const CoarseGrid& coarseGrid)
{
  constexpr int side = 4;
  const Triple& size = coarseGrid.Size;
  std::vector<Index> nodes;
  nodes.reserve(coarseGrid.numberOfNodes());
  const auto cubes = [&](int axis) { return (size[axis] + side - 1) / side; };
  forNodes({ 0, 0, 0 }, { cubes(0), cubes(1), cubes(2) },
    [&](const Triple& cube)
    {
      Triple low, high;
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = side * cube[axis];
        high[axis] = std::min(low[axis] + side, size[axis]);
      }
      forNodes(
        low, high, [&](const Triple& x) { nodes.push_back(coarseGrid.node(x[0], x[1], x[2])); });
    });
  return nodes;
}

// Compute the winding numbers at the nodes of the coarse grid.
std::vector<float> coarseNumbers(const FreudenthalGrid& grid, const CoarseGrid& coarseGrid,
  const WindingNumbers& cloud, const WindingNumbers::Sources& sources, double width, const Run& run)
{
  const std::vector<Index> order = nodesByCubes(coarseGrid);
  std::vector<float> numbers(order.size());
  const auto size = static_cast<Index>(order.size());
  Points places;
  for (Index start = 0; start < size; start += CoarsePerChunk)
  {
    const Index count = std::min(CoarsePerChunk, size - start);
    places.resize(count, 3);
    for (Index i = 0; i < count; ++i)
    {
      const Triple x = coarseGrid.coordinates(order[start + i]);
      places.row(i) = grid.Origin + grid.Spacing * Stride * Vector3(x[0], x[1], x[2]);
    }
    const Eigen::VectorXd found = cloud.at(places, sources, width, run);
    for (Index i = 0; i < count; ++i)
    {
      numbers[order[start + i]] = static_cast<float>(found[i]);
    }
    run.report(static_cast<double>(start + count) / static_cast<double>(size));
  }
  return numbers;
}

// Find the cubes of the coarse grid in which all nodes must be evaluated. Each cube is identified
// by its lowest node.
std::vector<Index> cubesToEvaluate(const FreudenthalGrid& grid, const CoarseGrid& coarseGrid,
  const std::vector<float>& coarse, const Points& points, double level)
{
  std::vector<std::uint8_t> marks(coarse.size(), 0);
  for (Index i = 0; i < points.rows(); ++i)
  {
    const Vector3 x = grid.toGrid(points.row(i));
    Triple low, high;
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::max(0, static_cast<int>(std::floor((x[axis] - Nearness) / Stride)));
      high[axis] = std::min(
        coarseGrid.Size[axis] - 1, static_cast<int>(std::floor((x[axis] + Nearness) / Stride)) + 1);
    }
    forNodes(low, high, [&](const Triple& c) { marks[coarseGrid.node(c[0], c[1], c[2])] = 1; });
  }
  std::vector<Index> cubes;
  forNodes({ 0, 0, 0 }, { coarseGrid.Size[0] - 1, coarseGrid.Size[1] - 1, coarseGrid.Size[2] - 1 },
    [&](const Triple& x)
    {
      const Index cube = coarseGrid.node(x[0], x[1], x[2]);
      float minimum = coarse[cube], maximum = minimum;
      for (int s = 1; s < 8; ++s)
      {
        const float value =
          coarse[coarseGrid.node(x[0] + (s & 1), x[1] + (s >> 1 & 1), x[2] + (s >> 2))];
        minimum = std::min(minimum, value);
        maximum = std::max(maximum, value);
      }
      if (marks[cube] || (minimum < level + MarginOfLevel && maximum > level - MarginOfLevel))
      {
        cubes.push_back(cube);
      }
    });
  return cubes;
}

// Interpolate all nodes between those of the coarse grid.
std::vector<float> interpolate(const FreudenthalGrid& grid, const CoarseGrid& coarseGrid,
  const std::vector<float>& coarse, const Run& run)
{
  std::vector<float> values(grid.numberOfNodes());
  forBlocks(run, grid.Size[2], 1,
    [&](Index begin, Index)
    {
      const int z = static_cast<int>(begin), cz = std::min(z / Stride, coarseGrid.Size[2] - 2);
      const float tz = static_cast<float>(z - Stride * cz) / Stride;
      for (int y = 0; y < grid.Size[1]; ++y)
      {
        const int cy = std::min(y / Stride, coarseGrid.Size[1] - 2);
        const float ty = static_cast<float>(y - Stride * cy) / Stride;
        const auto along = [&](int cx)
        {
          const auto at = [&](int s)
          { return coarse[coarseGrid.node(cx, cy + (s & 1), cz + (s >> 1))]; };
          return (1.0F - tz) * ((1.0F - ty) * at(0) + ty * at(1)) +
            tz * ((1.0F - ty) * at(2) + ty * at(3));
        };
        const int row = grid.node(0, y, z);
        for (int cx = 0; cx + 1 < coarseGrid.Size[0]; ++cx)
        {
          const float from = along(cx), to = along(cx + 1);
          const int first = Stride * cx, last = std::min(first + Stride, grid.Size[0]);
          for (int x = first; x < last; ++x)
          {
            const float tx = static_cast<float>(x - first) / Stride;
            values[row + x] = (1.0F - tx) * from + tx * to;
          }
        }
        // The last node may coincide with the last node of the coarse grid.
        const int last = Stride * (coarseGrid.Size[0] - 1);
        if (last < grid.Size[0])
        {
          values[row + last] = along(coarseGrid.Size[0] - 1);
        }
      }
    });
  return values;
}

void evaluate(const FreudenthalGrid& grid, const CoarseGrid& coarseGrid,
  const std::vector<Index>& cubes, const WindingNumbers& cloud,
  const WindingNumbers::Sources& sources, double width, std::vector<float>& values, const Run& run)
{
  const auto size = static_cast<Index>(cubes.size());
  Points places;
  for (Index start = 0; start < size; start += CubesPerChunk)
  {
    const Index count = std::min(CubesPerChunk, size - start);
    places.resize(count * NodesPerCube, 3);
    const auto nodeOf = [&](Index i, int k)
    {
      const Triple cube = coarseGrid.coordinates(cubes[start + i]);
      return Triple{ Stride * cube[0] + k % Stride, Stride * cube[1] + k / Stride % Stride,
        Stride * cube[2] + k / (Stride * Stride) };
    };
    forBlocks(run, count, 64,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          for (int k = 0; k < NodesPerCube; ++k)
          {
            const Triple x = nodeOf(i, k);
            places.row(i * NodesPerCube + k) =
              grid.Origin + grid.Spacing * Vector3(x[0], x[1], x[2]);
          }
        }
      });
    const Eigen::VectorXd found = cloud.at(places, sources, width, run);
    for (Index i = 0; i < count; ++i)
    {
      for (int k = 0; k < NodesPerCube; ++k)
      {
        const Triple x = nodeOf(i, k);
        if (x[0] < grid.Size[0] && x[1] < grid.Size[1] && x[2] < grid.Size[2])
        {
          values[grid.node(x[0], x[1], x[2])] = static_cast<float>(found[i * NodesPerCube + k]);
        }
      }
    }
    run.report(static_cast<double>(start + count) / static_cast<double>(size));
  }
}

// Blur along an axis in place: each node has weight 1/2, its two neighbors 1/4 each.
void blur(const FreudenthalGrid& grid, int axis, std::vector<float>& values, const Run& run)
{
  const int across = axis == 2 ? 1 : 2; // planes that hold the lines
  const int rows = axis == 0 ? grid.Size[1] : grid.Size[axis];
  const int length = grid.Size[0];
  forBlocks(run, grid.Size[across], 1,
    [&](Index plane, Index)
    {
      Triple at = { 0, 0, 0 };
      at[across] = static_cast<int>(plane);
      const auto rowAt = [&](int i)
      {
        Triple place = at;
        place[axis == 0 ? 1 : axis] = i;
        return values.data() + grid.node(0, place[1], place[2]);
      };
      std::vector<float> before(length), now(length);
      for (int i = 0; i < rows; ++i)
      {
        float* row = rowAt(i);
        now.assign(row, row + length);
        if (axis == 0)
        {
          for (int x = 0; x < length; ++x)
          {
            row[x] =
              0.5F * now[x] + 0.25F * (now[std::max(x - 1, 0)] + now[std::min(x + 1, length - 1)]);
          }
        }
        else
        {
          const float* after = rowAt(std::min(i + 1, rows - 1));
          const std::vector<float>& last = i > 0 ? before : now;
          for (int x = 0; x < length; ++x)
          {
            row[x] = 0.5F * now[x] + 0.25F * (last[x] + after[x]);
          }
        }
        before.swap(now);
      }
    });
}

// Interpolate values at a position within the grid.
double interpolated(
  const FreudenthalGrid& grid, const std::vector<float>& values, const Vector3& place)
{
  const Vector3 x = grid.toGrid(place);
  Triple low;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = std::clamp(static_cast<int>(std::floor(x[axis])), 0, grid.Size[axis] - 2);
  }
  double sum = 0.0;
  for (int s = 0; s < 8; ++s)
  {
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double t = x[axis] - low[axis];
      weight *= (s >> axis & 1) ? t : 1.0 - t;
    }
    sum += weight * values[grid.node(low[0] + (s & 1), low[1] + (s >> 1 & 1), low[2] + (s >> 2))];
  }
  return sum;
}
}

//------------------------------------------------------------------------------
Indicator indicatorOn(const FreudenthalGrid& grid, const WindingNumbers& cloud, const Points& areas,
  double width, const Run& run)
{
  const CoarseGrid coarseGrid(grid);
  Steps steps(run, { 0.2, 0.6, 0.2 }); // coarse grid, nodes near the surface, blur
  const WindingNumbers::Sources sources = cloud.sources(areas);
  const std::vector<float> coarse =
    coarseNumbers(grid, coarseGrid, cloud, sources, width, steps.next());
  Indicator indicator;
  indicator.Level = middleOf(cloud.atPoints(areas, width, run));
  indicator.Values = interpolate(grid, coarseGrid, coarse, run);
  evaluate(grid, coarseGrid,
    cubesToEvaluate(grid, coarseGrid, coarse, cloud.points(), indicator.Level), cloud, sources,
    width, indicator.Values, steps.next());
  steps.next();
  for (int axis = 0; axis < 3; ++axis)
  {
    blur(grid, axis, indicator.Values, run);
  }
  Eigen::VectorXd ofPoints(cloud.size());
  for (Index i = 0; i < cloud.size(); ++i)
  {
    ofPoints[i] = interpolated(grid, indicator.Values, cloud.points().row(i));
  }
  indicator.Level = middleOf(ofPoints);
  run.report(1.0);
  return indicator;
}
}
