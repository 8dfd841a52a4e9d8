#include "Hull/GenusZeroHull.h"

#include "Base/Steps.h"
#include "Cloud/Orientation.h"
#include "Hull/CloudDistance.h"
#include "Hull/GridSolid.h"
#include "Hull/IndicatorSolid.h"
#include "Hull/LevelSetSurface.h"
#include "Hull/ThinHandles.h"
#include "Mesh/GenusZeroCheck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
void requireRange(double value, double minimum, double maximum, const char* name)
{
  if (!(value >= minimum && value <= maximum))
  {
    throw std::invalid_argument(std::string("the ") + name + " must be in [" +
      std::to_string(minimum) + ", " + std::to_string(maximum) + "]");
  }
}

// Return the number of samples outside of the hull that is tolerated: one in 200. Hulls of closed
// scans have up to one in a thousand.
Index usualStrays(const TrainingSamples& samples)
{
  constexpr Index share = 200;
  return samples.totalSize() / share;
}

// Count samples that are data of the hull, over all ranks.
Index countSamples(const TrainingSamples& samples, const HullData& data, const Run& run)
{
  constexpr Index blockSize = 1 << 12;
  std::vector<Index> counts((samples.size() + blockSize - 1) / blockSize, 0);
  forBlocksReporting(run, samples.size(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        counts[begin / blockSize] += data.contains(samples[i]);
      }
    });
  std::int64_t sum = 0;
  for (const Index count : counts)
  {
    sum += count;
  }
  samples.reduce().sum(&sum, 1);
  return sum;
}

// Keep the components of nodes near data (marked 1) that touch the outside. Return the number of
// removed nodes.
Index keepSurface(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  std::vector<std::uint8_t>& nodes, const Run& run)
{
  constexpr std::uint8_t inner = 1, surface = 2;
  const std::array<int, 14> steps = grid.neighborSteps();
  std::vector<int> piece;
  for (int node = 0; node < static_cast<int>(nodes.size()); ++node)
  {
    if (nodes[node] == inner &&
      std::any_of(steps.begin(), steps.end(), [&](int step) { return !inside[node + step]; }))
    {
      markPiece(grid, nodes, node, surface, piece, run);
    }
  }
  Index leftOut = 0;
  for (std::uint8_t& mark : nodes)
  {
    leftOut += mark == inner;
    mark = mark == surface;
  }
  return leftOut;
}

Index countInside(
  const std::vector<std::uint8_t>& inside, const std::vector<float>& distances, double offset)
{
  Index count = 0;
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    count += inside[node] && distances[node] > offset;
  }
  return count;
}

// Cut handles as far from the data as possible. Return the largest number of nodes near data in one
// cut.
Index countCutData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& solid,
  const std::vector<float>& distances, double offset, const Run& run)
{
  // If the samples are as dense as the grid, the nodes within this distance form rows without gaps.
  constexpr double nearness = 0.6; // offsets
  std::vector<std::uint8_t> opened = solid;
  cutHandles(grid, opened, distances, offset, HandleCut::FarFromData, run);
  return maximumCutNearData(grid, solid, opened, distances, nearness * offset);
}

void addSurface(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, double level, int smoothingPasses, const Run& run,
  GenusZeroHullResult& result)
{
  Steps steps(run, { 0.4, 0.6 }); // level set, smoothing
  Mesh surface = makeLevelSetSurface(grid, inside, values, level, steps.next());
  smoothSurface(surface.Positions, surface.Triangles, smoothingPasses, steps.next());
  result.Positions.swap(surface.Positions);
  result.Triangles.swap(surface.Triangles);
}

GenusZeroHullResult makeHull(const TrainingSamples& samples, double spacing,
  const GenusZeroHullOptions& options, const Run& run)
{
  const int margin = static_cast<int>(std::ceil(options.Offset)) + 2;
  // Grid, distances, outside, largest piece, Euler number, handles, nodes of the data, samples
  // outside, data hidden inside, surface.
  Steps steps(run, { 0.01, 0.6, 0.15, 0.02, 0.01, 0.05, 0.01, 0.01, 0.02, 0.12 });
  const FreudenthalGrid grid = gridAround(samples, spacing, margin, steps.next());
  std::vector<float> distances = distanceToSamples(grid, samples, steps.next());

  GenusZeroHullResult result;
  result.Spacing = spacing;
  std::vector<std::uint8_t> inside;
  {
    OutsideNodes outside =
      findOutside(grid, distances, options.Offset, options.Persistence, steps.next());
    result.Leaks = outside.Leaks;
    result.LargestHole = { outside.LargestHole.Saddle * spacing,
      outside.LargestHole.Peak * spacing };
    inside.swap(outside.Outside);
  }
  for (std::uint8_t& mark : inside)
  {
    mark = !mark;
  }
  keepLargestPiece(grid, inside, steps.next());
  const Run counting = steps.next();
  result.NumberOfInsideNodes = countInside(inside, distances, options.Offset);
  result.EulerNumber = eulerNumber(grid, inside, counting);
  const Run cutting = steps.next();
  if (result.EulerNumber != 1 && options.Genus == HullGenus::AsFound)
  {
    const double width = options.HandleWidth * spacingOfData(distances, samples.totalSize());
    const ThinHandles removed =
      removeThinHandles(grid, inside, distances, options.Offset, width, cutting);
    result.NumberOfCutNodes = removed.NumberOfCutNodes + removed.NumberOfFilledNodes;
    result.NumberOfHandles = 1 - eulerNumber(grid, inside);
  }
  else if (result.EulerNumber != 1)
  {
    const std::vector<std::uint8_t> uncut = inside;
    result.NumberOfCutNodes = cutHandles(
      grid, inside, distances, options.Offset, HandleCut::HalfWay, cutting.part(0.0, 0.5));
    result.NumberOfCutInsideNodes =
      result.NumberOfInsideNodes - countInside(inside, distances, options.Offset);
    result.NumberOfCutDataNodes =
      countCutData(grid, uncut, distances, options.Offset, cutting.part(0.5, 1.0));
  }
  steps.next();
  {
    std::vector<std::uint8_t> data(inside.size());
    for (std::size_t node = 0; node < inside.size(); ++node)
    {
      data[node] = inside[node] && distances[node] <= options.Offset;
    }
    result.Data = HullData(grid, data);
    const Index all = countSamples(samples, result.Data, steps.next());
    result.NumberOfSamplesOutside = samples.totalSize() - all;
    if (keepSurface(grid, inside, data, steps.next()) > 0)
    {
      result.NumberOfSamplesInside =
        all - countSamples(samples, HullData(grid, data), run.unwatched());
    }
  }
  if ((result.NumberOfInsideNodes == 0 || result.Leaks) &&
    2 * result.NumberOfSamplesOutside > samples.totalSize())
  {
    return result; // the cloud is too sparse for this spacing
  }
  addSurface(
    grid, inside, distances, options.Offset, options.SmoothingPasses, steps.next(), result);
  return result;
}

// Count the steps from each node to the surface of a solid. Nodes next to the surface, on both
// sides, have the number 1. Nodes beyond the maximum have the number 0.
std::vector<std::uint16_t> stepsToSurface(
  const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside, int maximum)
{
  const std::array<int, 14> steps = grid.neighborSteps();
  std::vector<std::uint16_t> reached(inside.size(), 0);
  std::vector<int> front, next;
  forInnerRows(grid, {},
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        reached[node] = std::any_of(steps.begin(), steps.end(),
          [&](int step) { return inside[node + step] != inside[node]; });
        if (reached[node])
        {
          front.push_back(node);
        }
      }
    });
  const auto size = static_cast<int>(reached.size());
  for (int layer = 2; layer <= maximum; ++layer)
  {
    next.clear();
    for (const int node : front)
    {
      for (const int step : steps)
      {
        const int other = node + step;
        if (other >= 0 && other < size && !reached[other])
        {
          reached[other] = static_cast<std::uint16_t>(layer);
          next.push_back(other);
        }
      }
    }
    front.swap(next);
  }
  return reached;
}

// Mark the nodes near the surface of a solid. In sparse parts of the cloud, the error of the
// surface may be as large as the spacing of the samples. Around such samples, nodes up to that
// distance from the surface are marked.
std::vector<std::uint8_t> nodesOfData(const IndicatorSolid& solid)
{
  // The distance of marked nodes increases with the kernel width, and thus with the noise.
  constexpr double reach = 1.5, farthest = 24.0;
  const FreudenthalGrid& grid = solid.Grid;
  const double layers = std::max(1.0, std::floor(reach * solid.Width / grid.Spacing));
  const std::vector<double> areas = areasOfPoints(solid.Cloud);
  const double maximumSide =
    areas.empty() ? 0.0 : std::sqrt(*std::max_element(areas.begin(), areas.end()));
  const std::vector<std::uint16_t> steps = stepsToSurface(grid, solid.Inside,
    static_cast<int>(std::max(layers, std::min(farthest, maximumSide / grid.Spacing))));
  std::vector<std::uint8_t> data(steps.size());
  for (std::size_t node = 0; node < data.size(); ++node)
  {
    data[node] = steps[node] > 0 && steps[node] <= layers;
  }
  const Eigen::VectorXd sparsity = sparsityOf(solid.Cloud);
  for (Index i = 0; i < solid.Cloud.rows(); ++i)
  {
    if (sparsity[i] == 1.0)
    {
      continue;
    }
    const Eigen::Vector3i low =
      grid.toGrid(solid.Cloud.row(i)).array().floor().cast<int>().matrix();
    const int first = grid.node(low[0], low[1], low[2]);
    for (const int corner : grid.cornerSteps())
    {
      const int node = first + corner;
      data[node] =
        data[node] || (steps[node] > 0 && steps[node] * grid.Spacing <= std::sqrt(areas[i]));
    }
  }
  return data;
}

// Make the hull by winding numbers. If the winding numbers do not separate inside from outside, the
// result has no triangles.
GenusZeroHullResult makeHullByWindingNumbers(
  const TrainingSamples& samples, const GenusZeroHullOptions& options, const Run& run)
{
  Steps steps(run, { 0.93, 0.01, 0.06 }); // solid, samples outside, surface
  const bool keepsHandles = options.Genus == HullGenus::AsFound;
  IndicatorSolid solid = solidByWindingNumbers(
    samples, options.Spacing, keepsHandles ? options.HandleWidth : RemoveAllHandles, steps.next());
  GenusZeroHullResult result;
  if (solid.Inside.empty())
  {
    return result;
  }
  result.Method = HullMethod::WindingNumbers;
  result.NormalsUsed = solid.NormalsUsed;
  result.Width = solid.Width;
  result.Noise = solid.Noise;
  result.Spacing = options.Spacing;
  result.NumberOfInsideNodes = std::count(solid.Inside.begin(), solid.Inside.end(), 1);
  result.EulerNumber = solid.EulerNumber;
  result.NumberOfCutNodes = solid.Repair.NumberOfCutNodes + solid.Repair.NumberOfFilledNodes;
  result.NumberOfCutInsideNodes = keepsHandles ? 0 : solid.Repair.NumberOfDefiniteNodes;
  result.NumberOfHandles = keepsHandles ? 1 - eulerNumber(solid.Grid, solid.Inside) : 0;

  const Run counting = steps.next();
  std::vector<std::uint8_t> near = nodesOfData(solid);
  result.Data = HullData(solid.Grid, near);
  const Index atSurface = countSamples(samples, result.Data, counting.part(0.0, 0.5));
  for (std::size_t node = 0; node < near.size(); ++node)
  {
    near[node] = near[node] || solid.Inside[node];
  }
  const Index all = countSamples(samples, HullData(solid.Grid, near), counting.part(0.5, 1.0));
  result.NumberOfSamplesOutside = samples.totalSize() - all;
  result.NumberOfSamplesInside = all - atSurface;

  for (float& value : solid.Field.Values)
  {
    value = -value; // rising outward, as a distance
  }
  addSurface(solid.Grid, solid.Inside, solid.Field.Values, -solid.Field.Level,
    options.SmoothingPasses, steps.next(), result);
  return result;
}
}

//------------------------------------------------------------------------------
HullData::HullData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& nodes)
  : Grid(grid)
  , Nodes(nodes.begin(), nodes.end())
{
}

//------------------------------------------------------------------------------
bool HullData::contains(const Vector3& sample) const
{
  // Test all corners of the sample's cube.
  const Eigen::Vector3i cube = this->Grid.toGrid(sample).array().floor().cast<int>();
  const Eigen::Vector3i low = cube.cwiseMax(0);
  const Eigen::Vector3i high =
    (cube.array() + 1)
      .matrix()
      .cwiseMin(
        Eigen::Map<const Eigen::Vector3i>(this->Grid.Size.data()) - Eigen::Vector3i::Ones());
  for (int z = low[2]; z <= high[2]; ++z)
  {
    for (int y = low[1]; y <= high[1]; ++y)
    {
      for (int x = low[0]; x <= high[0]; ++x)
      {
        if (this->Nodes[this->Grid.node(x, y, z)])
        {
          return true;
        }
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool hasHandles(const GenusZeroHullResult& hull)
{
  constexpr Index maximum = 4, maximumOfData = 3; // numbers that sparse data have by chance
  return !hull.HandlesByChance &&
    (hull.NumberOfCutInsideNodes > std::min(1 - hull.EulerNumber, maximum) ||
      (hull.NumberOfInsideNodes > 0 && hull.NumberOfCutDataNodes > maximumOfData));
}

//------------------------------------------------------------------------------
bool seemsWrong(const GenusZeroHullResult& hull, const TrainingSamples& samples)
{
  return hull.Leaks || hull.NumberOfInsideNodes == 0 || hasHandles(hull) ||
    hull.NumberOfSamplesOutside > usualStrays(samples);
}

//------------------------------------------------------------------------------
bool isTorn(const GenusZeroHullResult& hull)
{
  // Handles that sparse data have by chance are cut by one or two nodes. The holes of a thin sheet
  // are cut open from one hole to the next.
  constexpr Index manyHandles = 4, nodesOfHandle = 3;
  const Index handles = 1 - hull.EulerNumber;
  return handles > manyHandles && hull.NumberOfCutNodes >= nodesOfHandle * handles;
}

namespace
{
// Make hulls by Distance with larger offsets, until the holes of thin sheets are closed. Return a
// hull without triangles if they stay open.
GenusZeroHullResult hullOfSheets(
  const TrainingSamples& samples, GenusZeroHullOptions options, const Run& run)
{
  constexpr Index fewCutNodes = 8;
  constexpr double share = 0.5; // of the remaining progress, for each offset
  double begin = 0.0;
  for (const double factor : { 1.5, 2.0, 3.0 })
  {
    GenusZeroHullOptions wider = options;
    wider.Offset = std::min(factor * options.Offset, GenusZeroHullLimits::MaximumOffset);
    const double end = begin + share * (1.0 - begin);
    GenusZeroHullResult hull = makeGenusZeroHull(samples, wider, run.part(begin, end));
    begin = end;
    if (hull.NumberOfCutNodes <= fewCutNodes)
    {
      return hull;
    }
  }
  return {};
}
}

//------------------------------------------------------------------------------
GenusZeroHullResult chooseHull(const TrainingSamples& samples, GenusZeroHullOptions options,
  GenusZeroHullOptions winding, const Run& run)
{
  // Most clouds need no other hulls, so they get little of the progress.
  constexpr double share = 0.95, shareOfSecond = 0.97;
  // At most one sample in 4000, such as the end of a limb, may be left out.
  constexpr Index shareOfLimbs = 4000;
  // Noise of thinned points; that of all points is about twice as much.
  constexpr double maximumNoise = 0.004;
  options.Method = HullMethod::Distance;
  winding.Method = HullMethod::WindingNumbers;
  const auto isUsable = [](const GenusZeroHullResult& hull)
  { return hull.Method == HullMethod::WindingNumbers && !hasHandles(hull); };
  // Only winding numbers use what is known about the scanners.
  const bool windingFirst = samples.hasScanners() && samples.dimension() == 3;
  const double begin = windingFirst ? 0.5 : 0.0;
  GenusZeroHullResult byAll;
  if (windingFirst)
  {
    byAll = makeGenusZeroHull(samples, winding, run.part(0.0, begin));
    if (isUsable(byAll))
    {
      return byAll;
    }
  }
  GenusZeroHullResult hull = makeGenusZeroHull(samples, options, run.part(begin, share));
  if (samples.dimension() < 3 || !(seemsWrong(hull, samples) || isTorn(hull)))
  {
    return hull;
  }
  if (!windingFirst)
  {
    byAll = makeGenusZeroHull(samples, winding, run.part(share, shareOfSecond));
  }
  // For a hull that leaks, the number of samples left out is undefined.
  const Index leftOut = hull.Leaks ? usualStrays(samples) : samples.totalSize() / shareOfLimbs;
  const bool better = isUsable(byAll) && (hull.Leaks || byAll.Noise <= maximumNoise) &&
    byAll.NumberOfSamplesOutside <= std::max(hull.NumberOfSamplesOutside, leftOut);
  if (isTorn(hull) && !(better && !isTorn(byAll)))
  {
    GenusZeroHullResult wide = hullOfSheets(samples, options, run.part(shareOfSecond, 1.0));
    if (wide.Triangles.rows() > 0)
    {
      return wide;
    }
  }
  if (better)
  {
    return byAll;
  }
  hull.HandlesByChance = isUsable(byAll);
  return hull;
}

//------------------------------------------------------------------------------
double cutFraction(const GenusZeroHullResult& hull)
{
  const double area = surfaceArea(hull.Positions, hull.Triangles);
  const double cut = static_cast<double>(hull.NumberOfCutNodes) * hull.Spacing * hull.Spacing;
  return hasHandles(hull) && area > 0.0 ? std::min(1.0, 2.0 * cut / area) : 0.0;
}

//------------------------------------------------------------------------------
GenusZeroHullResult makeGenusZeroHull(
  const TrainingSamples& samples, const GenusZeroHullOptions& options, const Run& run)
{
  if (samples.empty())
  {
    throw std::invalid_argument("there are no samples for a hull");
  }
  using Limits = GenusZeroHullLimits;
  requireRange(options.Spacing, Limits::MinimumSpacing, Limits::MaximumSpacing, "grid's spacing");
  requireRange(options.Offset, Limits::MinimumOffset, Limits::MaximumOffset, "offset");
  requireRange(
    options.Persistence, Limits::MinimumPersistence, Limits::MaximumPersistence, "persistence");
  requireRange(options.HandleWidth, Limits::MinimumHandleWidth, Limits::MaximumHandleWidth,
    "width of handles");
  requireRange(
    options.SmoothingPasses, 0, Limits::MaximumSmoothingPasses, "number of smoothing passes");

  if (options.Method == HullMethod::Automatic)
  {
    return chooseHull(samples, options, options, run);
  }
  // The first attempt accounts for most of the progress. Later attempts have an eighth of the nodes
  // each, and share the remaining progress.
  double reached = 0.0;
  const auto attempt = [&](double spacing)
  {
    const double begin = reached;
    return makeHull(samples, spacing, options,
      run.watchedBy(
        [&, begin](double fraction)
        {
          reached = begin + fraction * (1.0 - begin);
          run.report(reached);
          return true;
        }));
  };
  if (options.Method == HullMethod::WindingNumbers && samples.dimension() == 3)
  {
    GenusZeroHullResult byAll = makeHullByWindingNumbers(samples, options,
      run.watchedBy(
        [&](double fraction)
        {
          reached = fraction;
          run.report(fraction);
          return true;
        }));
    if (byAll.Triangles.rows() > 0)
    {
      return byAll;
    }
  }
  double spacing = options.Spacing;
  GenusZeroHullResult result = attempt(spacing);
  while (result.Triangles.rows() == 0)
  {
    spacing *= 2.0;
    result = attempt(spacing);
  }
  return result;
}
}
