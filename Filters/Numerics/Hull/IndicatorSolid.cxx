#include "Hull/IndicatorSolid.h"

#include "Base/Steps.h"
#include "Cloud/CloudThinning.h"
#include "Cloud/Orientation.h"
#include "Cloud/StrayPoints.h"
#include "Hull/CloudDistance.h"
#include "Hull/FreeSpace.h"
#include "Hull/GridSolid.h"
#include "Hull/ThinHandles.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr double SelectedPoints = 50000.0;
constexpr Index ThinnedPoints = 10000;
constexpr Index MinimumPoints = 20; // for a solid

// Kernel widths: the minimum, in units of the largest radius; the multiple of the typical spacing
// of the thinned points; and the ratio of the first to the last width of the orientation.
constexpr double MinimumWidth = 0.01, WidthOfSpacing = 0.5, FirstToLastWidth = 4.0;

// If the noise exceeds NoiseOfSpacing times the spacing, the width is at least WidthOfNoise times
// the noise. While there are more handles and cavities than tolerated, the width is multiplied by
// NextWidth.
constexpr double NoiseOfSpacing = 0.25, WidthOfNoise = 2.5, NextWidth = 1.5;
constexpr int NumberOfWidths = 3;
constexpr Index ToleratedFaults = 4;

// Maximum distance by which the surface over holes may extend beyond the bounding box of the
// points.
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

// Mark the nodes above the level. Nodes in the three outer layers of the grid are always outside.
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

// Numbers of handles and cavities of the largest component of a solid.
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

// Lower the indicator where scanners have looked through. It is at most the level where free space
// is 1/2, and 0 where it is 1.
void carve(const std::vector<float>& free, Indicator& indicator)
{
  for (std::size_t node = 0; node < free.size(); ++node)
  {
    if (free[node] > 0.0F)
    {
      const auto maximum = static_cast<float>(2.0 * indicator.Level * (1.0 - free[node]));
      indicator.Values[node] = std::min(indicator.Values[node], maximum);
    }
  }
}

// Search for the solid that is enclosed by thinned samples.
class SolidSearch
{
public:
  SolidSearch(OrientedPoints cloud, double spacing, const Run& run)
    : Cloud(std::move(cloud))
    , Numbers(this->Cloud.Positions, run.unwatched())
    , SpacingOfPoints(typicalSpacing(this->Cloud.Positions, run.unwatched()))
    , Width(std::max(MinimumWidth, WidthOfSpacing * this->SpacingOfPoints))
  {
    const int margin = static_cast<int>(std::ceil(Bulge / spacing)) + 3;
    this->Solid.Grid = gridAround(boxOf(this->Cloud.Positions), spacing, margin);
  }

  // Find area vectors of the samples. If the normals of the samples are consistent, they are used.
  void orientSamples(bool hasNormals, const Run& run)
  {
    if (hasNormals)
    {
      this->Areas = areaVectors(this->Cloud.Positions, this->Cloud.Normals, run.unwatched());
      this->Solid.NormalsUsed =
        turnOutward(this->Numbers, this->Areas, this->Width, run.part(0.0, 0.1));
    }
    this->orientAnew(run.part(0.1, 1.0));
    const double noise = noiseOf(this->Cloud.Positions, this->Areas, run.unwatched()).Deviation;
    this->Solid.Noise = noise;
    this->IsNoisy = noise > NoiseOfSpacing * this->SpacingOfPoints;
  }

  // Find the nodes inside. While noise causes many handles and cavities, repeat with a wider
  // kernel. Keep the result with the fewest.
  // @param[in] rays  points and the vectors to their scanners, empty if unknown
  void findInside(const OrientedPoints& rays, const Run& run)
  {
    std::vector<float> free;
    if (rays.ToScanner.rows() > 0)
    {
      free = freeSpace(this->Solid.Grid, rays.Positions, rays.ToScanner,
        typicalSpacing(rays.Positions, run.unwatched()), this->Solid.Noise, run.unwatched());
    }
    constexpr double share = 0.8; // each width accounts for this fraction of the remaining progress
    Index minimum = -1;
    double begin = 0.0;
    for (int i = 0; i < NumberOfWidths; ++i)
    {
      const double end = begin + share * (1.0 - begin);
      Steps steps(run.part(begin, end), { 0.5, 0.4, 0.1 }); // orientation, indicator, faults
      begin = end;
      this->widen(i, steps.next());
      Indicator field =
        indicatorOn(this->Solid.Grid, this->Numbers, this->Areas, this->Width, steps.next());
      steps.next();
      carve(free, field);
      std::vector<std::uint8_t> inside = nodesAbove(this->Solid.Grid, field);
      const Index faults = faultsOf(this->Solid.Grid, inside).sum();
      if (minimum < 0 || faults < minimum)
      {
        minimum = faults;
        this->Solid.Field = std::move(field);
        this->Solid.Inside.swap(inside);
        this->Solid.Width = this->Width;
      }
      if (!this->IsNoisy || faults <= ToleratedFaults)
      {
        break;
      }
    }
  }

  // Repair the solid so that it has the topology of a ball, or only handles of a given width, and
  // return it.
  IndicatorSolid repaired(const TrainingSamples& samples, double handleWidth, const Run& run)
  {
    IndicatorSolid& solid = this->Solid;
    const PointTree tree(this->Cloud.Positions, run.unwatched());
    const double near = this->SpacingOfPoints * this->SpacingOfPoints;
    joinPieces(
      solid.Grid, solid.Field, solid.Inside,
      [&](int node) { return tree.nearest(solid.Grid.position(node)).SquareDistance <= near; },
      run.part(0.0, 0.3));
    fillCavities(solid.Grid, solid.Inside, run.part(0.3, 0.5));
    solid.EulerNumber = eulerNumber(solid.Grid, solid.Inside);
    std::function<bool(const std::vector<int>&)> isKept;
    std::vector<float> distances;
    double begin = 0.5; // of the removal of handles
    if (handleWidth != RemoveAllHandles && solid.EulerNumber < 1)
    {
      begin = 0.7;
      distances = distanceToSamples(solid.Grid, samples, run.part(0.5, begin));
      const double width = handleWidth * spacingOfData(distances, samples.totalSize());
      isKept = [&distances, width](const std::vector<int>& nodes)
      { return widthOfPiece(nodes, distances) >= width; };
    }
    solid.Repair = openHandles(solid.Grid, solid.Field, solid.Inside, isKept, run.part(begin, 1.0));
    if (std::count(solid.Inside.begin(), solid.Inside.end(), 1) == 0)
    {
      solid.Inside.clear();
    }
    solid.Cloud.swap(this->Cloud.Positions);
    return std::move(solid);
  }

private:
  void orientAnew(const Run& run)
  {
    if (!this->Solid.NormalsUsed)
    {
      OrientationOptions options;
      options.FirstWidth = FirstToLastWidth * this->Width;
      options.LastWidth = this->Width;
      this->Areas = orient(this->Numbers, options, run);
    }
  }

  // Set the kernel width of an attempt. The first attempt uses the width of the orientation, or a
  // larger width for noisy points.
  void widen(int number, const Run& run)
  {
    const double widthOfNoise = WidthOfNoise * this->Solid.Noise;
    if (number > 0)
    {
      this->Width *= NextWidth;
      this->orientAnew(run);
    }
    else if (this->IsNoisy && this->Width < widthOfNoise)
    {
      this->Width = widthOfNoise;
      this->orientAnew(run);
    }
  }

  OrientedPoints Cloud;
  WindingNumbers Numbers;
  double SpacingOfPoints;
  double Width; // of the kernel
  bool IsNoisy = false;
  Points Areas;
  IndicatorSolid Solid;
};
}

//------------------------------------------------------------------------------
IndicatorSolid solidByWindingNumbers(
  const TrainingSamples& samples, double spacing, double handleWidth, const Run& run)
{
  // Isolated points, thinning, trees, orientation, inside, repair.
  Steps steps(run, { 0.06, 0.04, 0.02, 0.72, 0.13, 0.03 });
  constexpr double farthest = 8.0;
  OrientedPoints cloud = selectSamples(samples, SelectedPoints);
  cloud = without(cloud, isolatedPoints(cloud.Positions, farthest, steps.next()));
  const OrientedPoints rays = samples.hasScanners() ? cloud : OrientedPoints();
  cloud = thin(cloud, ThinnedPoints, steps.next());
  if (cloud.Positions.rows() < MinimumPoints)
  {
    return {};
  }
  SolidSearch search(std::move(cloud), spacing, steps.next());
  search.orientSamples(samples.oriented(), steps.next());
  search.findInside(rays, steps.next());
  return search.repaired(samples, handleWidth, steps.next());
}
}
