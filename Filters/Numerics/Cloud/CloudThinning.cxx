#include "Cloud/CloudThinning.h"

#include "Base/AllColumns.h"
#include "Search/BoxTree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace conformal
{
namespace
{
using Numbers = std::vector<double>;

Points asPoints(const Numbers& numbers)
{
  return Eigen::Map<const Points>(numbers.data(), static_cast<Index>(numbers.size()) / 3, 3);
}

Vector3 direction(const Vector3& x)
{
  const double length = x.norm();
  return length > 0.0 && std::isfinite(length) ? Vector3(x / length) : Vector3(Vector3::Zero());
}

// Sort points by their cubes, and points of one cube by id.
using Cubes = std::vector<std::pair<std::uint64_t, int>>;

Cubes cubesOf(const Points& points, const Vector3& origin, double spacing)
{
  constexpr int bits = 21;
  Cubes cubes(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    std::uint64_t key = 0;
    for (int c = 0; c < 3; ++c)
    {
      const auto along = static_cast<std::uint64_t>((points(i, c) - origin[c]) / spacing);
      key = key << bits | along;
    }
    cubes[i] = { key, static_cast<int>(i) };
  }
  std::sort(cubes.begin(), cubes.end());
  return cubes;
}

Index numberOfCubes(const Cubes& cubes)
{
  Index count = 0;
  for (std::size_t i = 0; i < cubes.size(); ++i)
  {
    count += i == 0 || cubes[i].first != cubes[i - 1].first;
  }
  return count;
}
}

//------------------------------------------------------------------------------
OrientedPoints selectSamples(const TrainingSamples& samples, double maximum)
{
  const Index stretch =
    std::max<Index>(1, std::llround(static_cast<double>(samples.totalSize()) / maximum));
  const Index first = samples.firstOfTotal(), last = first + samples.size();
  Numbers positions, normals, toScanner;
  for (Index i = first / stretch; i < std::min(samples.totalSize() / stretch, last); ++i)
  {
    const std::uint64_t mixed = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15U;
    const Index id =
      i * stretch + static_cast<Index>((mixed >> 32) % static_cast<std::uint64_t>(stretch));
    if (id >= first && id < last)
    {
      const Vector3 x = samples[id - first];
      positions.insert(positions.end(), x.data(), x.data() + 3);
      if (samples.oriented())
      {
        const Vector3 n = direction(samples.normal(id - first));
        normals.insert(normals.end(), n.data(), n.data() + 3);
      }
      if (samples.hasScanners())
      {
        const Vector3 v = samples.toScanner(id - first);
        toScanner.insert(toScanner.end(), v.data(), v.data() + 3);
      }
    }
  }
  OrientedPoints cloud;
  cloud.Positions = asPoints(gather(samples.reduce(), positions));
  if (samples.oriented())
  {
    cloud.Normals = asPoints(gather(samples.reduce(), normals));
  }
  if (samples.hasScanners())
  {
    cloud.ToScanner = asPoints(gather(samples.reduce(), toScanner));
  }
  return cloud;
}

//------------------------------------------------------------------------------
OrientedPoints without(const OrientedPoints& cloud, const std::vector<std::uint8_t>& marks)
{
  std::vector<Index> kept;
  for (Index i = 0; i < cloud.Positions.rows(); ++i)
  {
    if (!marks[i])
    {
      kept.push_back(i);
    }
  }
  const auto keptRows = [&](const Points& rows)
  { return rows.rows() > 0 ? Points(rows(kept, AllColumns)) : rows; };
  return { keptRows(cloud.Positions), keptRows(cloud.Normals), keptRows(cloud.ToScanner) };
}

//------------------------------------------------------------------------------
OrientedPoints thin(const OrientedPoints& cloud, Index count, const Run& run)
{
  constexpr int steps = 12; // of bisection
  // Keys have 21 bits for each axis.
  constexpr double finest = 1e-6;
  if (cloud.Positions.rows() <= count)
  {
    return cloud;
  }
  Box bounds;
  for (Index i = 0; i < cloud.Positions.rows(); ++i)
  {
    bounds.extend(Vector3(cloud.Positions.row(i)));
  }
  const double size = (bounds.Upper - bounds.Lower).maxCoeff();
  if (!(size > 0.0))
  {
    return cloud;
  }
  // Bisect the logarithm of the spacing, between one cube and the finest grid.
  double low = finest * size, high = 2.0 * size;
  Cubes cubes;
  for (int step = 0; step < steps; ++step)
  {
    const double middle = std::sqrt(low * high);
    cubes = cubesOf(cloud.Positions, bounds.Lower, middle);
    (numberOfCubes(cubes) > count ? low : high) = middle;
    run.report((step + 1.0) / (steps + 1.0));
  }
  cubes = cubesOf(cloud.Positions, bounds.Lower, high);
  const Index left = numberOfCubes(cubes);
  const bool oriented = cloud.Normals.rows() > 0;
  OrientedPoints thinned;
  thinned.Positions.resize(left, 3);
  thinned.Normals.resize(oriented ? left : 0, 3);
  Index next = 0;
  for (std::size_t begin = 0, end = 0; begin < cubes.size(); begin = end)
  {
    Vector3 position = Vector3::Zero(), normal = Vector3::Zero();
    for (; end < cubes.size() && cubes[end].first == cubes[begin].first; ++end)
    {
      position += cloud.Positions.row(cubes[end].second);
      if (oriented)
      {
        normal += cloud.Normals.row(cubes[end].second);
      }
    }
    thinned.Positions.row(next) = position / static_cast<double>(end - begin);
    if (oriented)
    {
      thinned.Normals.row(next) = direction(normal);
    }
    ++next;
  }
  run.report(1.0);
  return thinned;
}
}
