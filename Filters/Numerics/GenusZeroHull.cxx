#include "GenusZeroHull.h"

#include "CloudDistance.h"
#include "LatticeSolid.h"
#include "LevelSetSurface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
void requireRange(double value, double lowest, double highest, const char* name)
{
  if (!(value >= lowest && value <= highest))
  {
    throw std::invalid_argument(std::string("the ") + name + " must be in [" +
      std::to_string(lowest) + ", " + std::to_string(highest) + "]");
  }
}

// Samples that the solid does not contain.
Index countOutside(const TrainingSamples& samples, const HullSolid& solid,
  const ParallelFor& parallelFor, const Progress& progress)
{
  constexpr Index blockSize = 1 << 12;
  std::vector<Index> counts((samples.size() + blockSize - 1) / blockSize, 0);
  forBlocks(parallelFor, samples.size(), blockSize, progress,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        counts[begin / blockSize] += !solid.contains(samples[i]);
      }
    });
  Index sum = 0;
  for (const Index count : counts)
  {
    sum += count;
  }
  return sum;
}

GenusZeroHullResult makeHull(const TrainingSamples& samples, double spacing,
  const GenusZeroHullOptions& options, const ParallelFor& parallelFor, const Progress& progress)
{
  const auto part = [&](double begin, double end) -> Progress
  {
    return [&progress, begin, end](double fraction)
    {
      report(progress, begin + fraction * (end - begin));
      return true;
    };
  };
  const int margin = static_cast<int>(std::ceil(options.Offset)) + 2;
  const FreudenthalLattice lattice =
    latticeAround(samples, spacing, margin, parallelFor, part(0.0, 0.02));
  std::vector<float> distances = distanceToSamples(lattice, samples, parallelFor, part(0.02, 0.4));

  GenusZeroHullResult result;
  result.Spacing = spacing;
  std::vector<std::uint8_t> inside;
  {
    OutsideNodes outside = findOutside(
      lattice, distances, options.Offset, options.Persistence, parallelFor, part(0.4, 0.65));
    result.Leaks = outside.Leaks;
    result.LargestHole = { outside.LargestHole.Saddle * spacing,
      outside.LargestHole.Peak * spacing };
    inside.swap(outside.Outside);
  }
  for (std::uint8_t& mark : inside)
  {
    mark = !mark;
  }
  keepLargestPiece(lattice, inside, part(0.65, 0.7));
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    result.NumberOfInsideNodes += inside[node] && distances[node] > options.Offset;
  }
  result.EulerNumber = eulerNumber(lattice, inside, part(0.7, 0.72));
  if (result.EulerNumber != 1)
  {
    result.NumberOfCutNodes =
      cutHandles(lattice, inside, distances, options.Offset, part(0.72, 0.8));
  }
  result.Solid = HullSolid(lattice, inside);
  result.NumberOfSamplesOutside = countOutside(samples, result.Solid, parallelFor, part(0.8, 0.82));
  if (result.NumberOfInsideNodes == 0 && 2 * result.NumberOfSamplesOutside > samples.size())
  {
    return result; // too coarse a cloud: no surface is asked for
  }
  LevelSetSurface surface =
    makeLevelSetSurface(lattice, inside, distances, options.Offset, part(0.82, 0.9));
  smoothSurface(
    surface.Positions, surface.Faces, options.SmoothingPasses, parallelFor, part(0.9, 1.0));
  result.Points.swap(surface.Positions);
  result.Triangles.swap(surface.Faces);
  return result;
}
}

//------------------------------------------------------------------------------
HullSolid::HullSolid(const FreudenthalLattice& lattice, const std::vector<std::uint8_t>& inside)
  : Lattice(lattice)
  , Inside(inside.begin(), inside.end())
{
}

//------------------------------------------------------------------------------
bool HullSolid::contains(const Vector3& x) const
{
  const Vector3 low = this->Lattice.toLattice(x).array().floor();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(low[axis] >= 0.0 && low[axis] + 1.0 < this->Lattice.Size[axis]))
    {
      return false;
    }
  }
  const int node = this->Lattice.node(
    static_cast<int>(low[0]), static_cast<int>(low[1]), static_cast<int>(low[2]));
  for (const int step : this->Lattice.cornerSteps())
  {
    if (this->Inside[node + step])
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
GenusZeroHullResult makeGenusZeroHull(const TrainingSamples& samples,
  const GenusZeroHullOptions& options, const ParallelFor& parallelFor, const Progress& progress)
{
  if (samples.empty())
  {
    throw std::invalid_argument("there are no samples to make a hull of");
  }
  requireRange(options.Spacing, 0.002, 0.2, "spacing of the lattice");
  requireRange(options.Offset, 0.9, 10.0, "offset");
  requireRange(options.Persistence, 1.1, 10.0, "persistence");
  requireRange(options.SmoothingPasses, 0, 1000, "number of smoothing passes");

  // Never falling, though attempts are repeated.
  double reached = 0.0;
  const Progress rising = [&](double fraction)
  {
    reached = std::max(reached, fraction);
    report(progress, reached);
    return true;
  };
  double spacing = options.Spacing;
  GenusZeroHullResult result = makeHull(samples, spacing, options, parallelFor, rising);
  while (result.Triangles.rows() == 0)
  {
    spacing *= 2.0;
    result = makeHull(samples, spacing, options, parallelFor, rising);
  }
  return result;
}
}
