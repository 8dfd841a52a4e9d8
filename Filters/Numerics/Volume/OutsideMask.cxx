#include "Volume/OutsideMask.h"

#include "Base/Steps.h"
#include "Volume/VoxelDistance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace conformal
{
namespace
{
using Mask = std::vector<std::uint8_t>;

constexpr Index VoxelsPerBlock = Index(1) << 14; // voxels of a block of a short loop

// Report the progress of a flood of voxels.
class FloodReports
{
public:
  FloodReports(const Run& run, Index numberOfVoxels)
    : Watched(run)
    , NumberOfVoxels(numberOfVoxels)
  {
  }

  void count()
  {
    constexpr Index interval = Index(1) << 20;
    if (++this->Done % interval == 0)
    {
      this->Watched.report(
        static_cast<double>(this->Done) / static_cast<double>(this->NumberOfVoxels));
    }
  }

private:
  const Run& Watched;
  Index NumberOfVoxels, Done = 0;
};

// Mark the voxels that face neighbors connect to the seeds, in the given space.
Mask filled(const VolumeImage& grid, const Mask& space, std::vector<Index> seeds, const Run& run)
{
  FloodReports reports(run, grid.size());
  Mask reached(space.size(), 0);
  const std::array<Index, 3> steps = { 1, grid.Size[0], grid.Size[0] * grid.Size[1] };
  for (const Index seed : seeds)
  {
    reached[seed] = 1;
  }
  while (!seeds.empty())
  {
    const Index voxel = seeds.back();
    seeds.pop_back();
    reports.count();
    for (int a = 0; a < 3; ++a)
    {
      const Index at = voxel / steps[a] % grid.Size[a];
      for (const Index side : { -1, 1 })
      {
        const Index other = voxel + side * steps[a];
        if (at + side >= 0 && at + side < grid.Size[a] && space[other] && !reached[other])
        {
          reached[other] = 1;
          seeds.push_back(other);
        }
      }
    }
  }
  return reached;
}

// Keep the largest part of a mask, or the first of those of equal size.
void keepLargest(const VolumeImage& grid, Mask& mask, const Run& run)
{
  FloodReports reports(
    run, 2 * grid.size()); // each voxel is visited once, and flooded at most once
  Mask left = mask;
  std::vector<Index> best;
  for (Index voxel = 0; voxel < static_cast<Index>(mask.size()); ++voxel)
  {
    reports.count();
    if (!left[voxel])
    {
      continue;
    }
    // A flood by hand, so that small parts cost only their own voxels.
    std::vector<Index> part = { voxel };
    left[voxel] = 0;
    const std::array<Index, 3> steps = { 1, grid.Size[0], grid.Size[0] * grid.Size[1] };
    for (std::size_t next = 0; next < part.size(); ++next)
    {
      reports.count();
      for (int a = 0; a < 3; ++a)
      {
        const Index at = part[next] / steps[a] % grid.Size[a];
        for (const Index side : { -1, 1 })
        {
          const Index other = part[next] + side * steps[a];
          if (at + side >= 0 && at + side < grid.Size[a] && left[other])
          {
            left[other] = 0;
            part.push_back(other);
          }
        }
      }
    }
    if (part.size() > best.size())
    {
      best = std::move(part);
    }
  }
  std::fill(mask.begin(), mask.end(), 0);
  for (const Index voxel : best)
  {
    mask[voxel] = 1;
  }
}

// Move all objects but the largest to the outside.
void leaveOthersOutside(const VolumeImage& grid, Mask& outside, Mask& object, const Run& run)
{
  Steps steps(run, { 0.15, 0.7, 0.15 });
  Mask inside(outside.size());
  forBlocksReporting(steps.next(), grid.size(), VoxelsPerBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        inside[i] = !outside[i];
      }
    });
  keepLargest(grid, inside, steps.next());
  forBlocksReporting(steps.next(), grid.size(), VoxelsPerBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        outside[i] = !inside[i];
        object[i] = object[i] && inside[i];
      }
    });
}

// Copy of the grid with a margin on all sides, without values.
VolumeImage padded(const VolumeImage& volume, Index margin)
{
  VolumeImage grid;
  for (int a = 0; a < 3; ++a)
  {
    grid.Size[a] = volume.Size[a] + 2 * margin;
  }
  return grid;
}

template <typename Visit>
void forVoxels(
  const VolumeImage& volume, const VolumeImage& grid, Index margin, const Run& run, Visit visit)
{
  const Index length = std::max<Index>(volume.Size[0], 1), rows = volume.Size[1] * volume.Size[2];
  forBlocksReporting(run, rows, std::max<Index>(VoxelsPerBlock / length, 1),
    [&](Index begin, Index end)
    {
      for (Index row = begin; row < end; ++row)
      {
        const Index j = row % volume.Size[1], k = row / volume.Size[1];
        for (Index i = 0; i < volume.Size[0]; ++i)
        {
          visit(volume.id(i, j, k), grid.id(i + margin, j + margin, k + margin));
        }
      }
    });
}
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> markOutside(
  const VolumeImage& volume, const OutsideMaskOptions& options, const Run& run)
{
  const double radius = options.ClosingRadius;
  if (!(radius >= 0.0 && radius <= MaximumClosing))
  {
    throw std::invalid_argument("the closing radius must be in [0, 100] voxels");
  }
  // Object, distance, outside, largest object, distance and result.
  Steps steps(run, { 0.05, 0.3, 0.2, options.LargestObject ? 0.1 : 0.0, 0.3, 0.05 });
  const Index margin = static_cast<Index>(std::ceil(radius)) + 2;
  const VolumeImage grid = padded(volume, margin);
  Mask object(static_cast<std::size_t>(grid.size()), 0);
  forVoxels(volume, grid, margin, steps.next(),
    [&](Index from, Index to) { object[to] = volume.Values[from] > options.Level; });
  const Mask free = farFrom(grid.Size, object, radius, steps.next());
  Mask outside = filled(grid, free, { 0 }, steps.next());
  const Run largest = steps.next();
  if (options.LargestObject)
  {
    leaveOthersOutside(grid, outside, object, largest);
  }
  const Mask far = farFrom(grid.Size, outside, radius, steps.next());
  Mask result(volume.Values.size());
  forVoxels(volume, grid, margin, steps.next(),
    [&](Index to, Index from) { result[to] = !far[from] && !object[from]; });
  return result;
}
}
