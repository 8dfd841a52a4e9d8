#include "Hull/IndicatorSolid.h"

#include "Base/Steps.h"
#include "Cloud/CloudThinning.h"
#include "Cloud/Orientation.h"
#include "Cloud/StrayPoints.h"
#include "Hull/CloudDistance.h"
#include "Hull/GridSolid.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr double SelectedPoints = 50000.0;
constexpr Index ThinnedPoints = 10000;
constexpr Index MinimumPoints = 20; // of which anything can be told

// Widths, in units of the largest radius and of the typical spacing of the thinned points.
constexpr double MinimumWidth = 0.01, WidthOfSpacing = 0.5, FirstToLastWidth = 4.0;

// Noise that is no smaller against the spacing asks for a width of its own, and for wider ones
// while there are more handles and cavities than these.
constexpr double NoiseOfSpacing = 0.25, WidthOfNoise = 2.5, NextWidth = 1.5;
constexpr int NumberOfWidths = 3;
constexpr Index ToleratedFaults = 4;

// In nanoseconds as in Steps: for each point selected, each point thinned, and each node.
constexpr double WorkOfIsolated = 1500.0, WorkOfThinning = 1000.0;
constexpr double WorkOfNeighbors = 3000.0, WorkOfOrientation = 110000.0;
constexpr double WorkOfFaults = 18.0, WorkOfRepair = 34.0;

// The surface over missing data may bulge out of the data's box by as much.
constexpr double Bulge = 0.1;

Box boxOf(const Points& points)
{
  Box box;
  for (Index i = 0; i < points.rows(); ++i)
  {
    box.extend(Vector3(points.row(i)));
  }
  return box;
}

// Nodes above the level, none in the grid's outer layers: what is there is outside.
std::vector<std::uint8_t> nodesAbove(const FreudenthalGrid& grid, const Indicator& indicator)
{
  constexpr int layers = 3;
  std::vector<std::uint8_t> inside(indicator.Values.size(), 0);
  for (int z = layers; z < grid.Size[2] - layers; ++z)
  {
    for (int y = layers; y < grid.Size[1] - layers; ++y)
    {
      for (int x = layers; x < grid.Size[0] - layers; ++x)
      {
        const int node = grid.node(x, y, z);
        inside[node] = indicator.Values[node] > indicator.Level;
      }
    }
  }
  return inside;
}

// What has to be repaired on the largest piece of a solid.
struct Faults
{
  Index Handles = 0, Cavities = 0;
  Index sum() const { return this->Handles + this->Cavities; }
};

Faults faultsOf(const FreudenthalGrid& grid, std::vector<std::uint8_t> inside)
{
  Faults faults;
  keepLargestPiece(grid, inside);
  faults.Cavities = fillCavities(grid, inside);
  faults.Handles = 1 - eulerNumber(grid, inside);
  return faults;
}
}

//------------------------------------------------------------------------------
double workOfIndicatorSolid(const TrainingSamples& samples, double spacing)
{
  const auto size = static_cast<double>(samples.totalSize());
  const double nodes = 6.0 / (spacing * spacing * spacing); // of a usual object
  const double thinned = std::min(size, 0.9 * static_cast<double>(ThinnedPoints));
  return (WorkOfIsolated + WorkOfThinning) * std::min(size, SelectedPoints) +
    (2.0 * WorkOfNeighbors + (samples.oriented() ? 0.0 : WorkOfOrientation)) * thinned +
    workOfIndicator(nodes) + (WorkOfFaults + WorkOfRepair) * nodes;
}

//------------------------------------------------------------------------------
IndicatorSolid solidByWindingNumbers(const TrainingSamples& samples, double spacing, const Run& run)
{
  IndicatorSolid solid;
  OrientedPoints cloud = selectSamples(samples, SelectedPoints);
  const auto selected = static_cast<double>(cloud.Positions.rows());
  Steps steps(run,
    { WorkOfIsolated * selected, WorkOfThinning * selected,
      workOfIndicatorSolid(samples, spacing) - (WorkOfIsolated + WorkOfThinning) * selected });
  constexpr double farthest = 8.0;
  cloud = without(cloud, isolatedPoints(cloud.Positions, farthest, steps.next()));
  cloud = thin(cloud, ThinnedPoints, steps.next());
  if (cloud.Positions.rows() < MinimumPoints)
  {
    return solid;
  }
  const int margin = static_cast<int>(std::ceil(Bulge / spacing)) + 3;
  solid.Grid = gridAround(boxOf(cloud.Positions), spacing, margin);

  const auto size = static_cast<double>(cloud.Positions.rows());
  const auto nodes = static_cast<double>(solid.Grid.numberOfNodes());
  const auto workFromOrientation = [&]
  {
    return std::vector<double>{ solid.NormalsUsed ? 0.0 : WorkOfOrientation * size,
      workOfIndicator(nodes), WorkOfFaults * nodes, WorkOfRepair * nodes };
  };
  std::vector<double> work = workFromOrientation();
  work[0] += WorkOfNeighbors * size; // for the noise
  work.insert(work.begin(), WorkOfNeighbors * size);
  steps.replan(work);
  steps.next();
  const WindingNumbers numbers(cloud.Positions, run.unwatched());
  const double spacingOfPoints = typicalSpacing(cloud.Positions, run.unwatched());
  double width = std::max(MinimumWidth, WidthOfSpacing * spacingOfPoints);
  Points areas;
  if (samples.oriented())
  {
    areas = areaVectors(cloud.Positions, cloud.Normals, run.unwatched());
    solid.NormalsUsed = turnOutward(numbers, areas, width, run);
    steps.replan(workFromOrientation());
  }
  const auto orientAnew = [&]
  {
    const Run orienting = steps.next();
    if (!solid.NormalsUsed)
    {
      OrientationOptions options;
      options.FirstWidth = FirstToLastWidth * width;
      options.LastWidth = width;
      areas = orient(numbers, options, orienting);
    }
  };
  orientAnew();
  const double noise = noiseOf(cloud.Positions, areas, run.unwatched()).Deviation;
  solid.Noise = noise;
  const bool noisy = noise > NoiseOfSpacing * spacingOfPoints;
  if (noisy && width < WidthOfNoise * noise)
  {
    width = WidthOfNoise * noise;
    steps.replan(workFromOrientation());
    orientAnew();
  }
  Index fewest = -1;
  for (int i = 0; i < NumberOfWidths; ++i)
  {
    if (i > 0)
    {
      width *= NextWidth;
      steps.replan(workFromOrientation());
      orientAnew();
    }
    Indicator field = indicatorOn(solid.Grid, numbers, areas, width, steps.next());
    steps.next();
    std::vector<std::uint8_t> inside = nodesAbove(solid.Grid, field);
    const Index faults = faultsOf(solid.Grid, inside).sum();
    if (fewest < 0 || faults < fewest)
    {
      fewest = faults;
      solid.Field = std::move(field);
      solid.Inside.swap(inside);
      solid.Width = width;
    }
    if (!noisy || faults <= ToleratedFaults)
    {
      break;
    }
  }
  const Run repairing = steps.next();
  joinPieces(solid.Grid, solid.Field, solid.Inside, repairing.part(0.0, 0.3));
  fillCavities(solid.Grid, solid.Inside, repairing.part(0.3, 0.5));
  solid.EulerNumber = eulerNumber(solid.Grid, solid.Inside);
  solid.Repair = openHandles(solid.Grid, solid.Field, solid.Inside, repairing.part(0.5, 1.0));
  if (std::count(solid.Inside.begin(), solid.Inside.end(), 1) == 0)
  {
    solid.Inside.clear();
  }
  solid.Cloud.swap(cloud.Positions);
  return solid;
}
}
