#include "Hull/ThinHandles.h"

#include "Base/Steps.h"
#include "Hull/GridSolid.h"
#include "Hull/SolidRepair.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace conformal
{
namespace
{
// Connected components of the difference between two sets.
std::vector<std::vector<int>> piecesBetween(const FreudenthalGrid& grid,
  const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& after)
{
  constexpr std::uint8_t unseen = 1, seen = 2;
  std::vector<std::uint8_t> marks(before.size());
  for (std::size_t node = 0; node < marks.size(); ++node)
  {
    marks[node] = before[node] != after[node] ? unseen : 0;
  }
  std::vector<std::vector<int>> pieces;
  for (int node = 0; node < static_cast<int>(marks.size()); ++node)
  {
    if (marks[node] == unseen)
    {
      pieces.emplace_back();
      markPiece(grid, marks, node, seen, pieces.back());
    }
  }
  return pieces;
}

// Change the nodes of those pieces that are to be changed, if the change removes a handle.
// @return number of changed nodes
Index change(const FreudenthalGrid& grid, const std::vector<std::vector<int>>& pieces,
  const std::function<bool(const std::vector<int>&)>& isNoise, std::vector<std::uint8_t>& inside)
{
  Index count = 0;
  const auto flip = [&](const std::vector<int>& nodes)
  {
    for (const int node : nodes)
    {
      inside[node] = !inside[node];
    }
  };
  for (const std::vector<int>& piece : pieces)
  {
    if (!isNoise(piece))
    {
      continue;
    }
    const Index before = eulerNumberAround(grid, inside, piece);
    flip(piece);
    if (eulerNumberAround(grid, inside, piece) > before)
    {
      count += static_cast<Index>(piece.size());
    }
    else
    {
      flip(piece);
    }
  }
  return count;
}
}

//------------------------------------------------------------------------------
double widthOfPiece(const std::vector<int>& nodes, const std::vector<float>& distances)
{
  float maximum = 0.0F;
  for (const int node : nodes)
  {
    maximum = std::max(maximum, distances[node]);
  }
  return 2.0 * maximum;
}

//------------------------------------------------------------------------------
double spacingOfData(const std::vector<float>& distances, Index numberOfSamples)
{
  constexpr double reach = 2.0; // of the nodes on both sides of the data [grid spacings]
  const auto count = std::count_if(
    distances.begin(), distances.end(), [](float distance) { return distance <= reach; });
  const double area = static_cast<double>(count) / (2.0 * reach);
  return std::max(1.0, std::sqrt(area / static_cast<double>(std::max<Index>(1, numberOfSamples))));
}

//------------------------------------------------------------------------------
ThinHandles removeThinHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& distances, double offset, double width, const Run& run)
{
  Steps steps(run, { 0.3, 0.3, 0.2, 0.2 }); // fillings and cuts of two rounds
  ThinHandles result;
  // Among nodes at equal distance from the solid, those far from the data are filled last.
  std::vector<float> values(distances.size());
  std::transform(distances.begin(), distances.end(), values.begin(),
    [](float distance) { return 0.5F / (1.0F + std::max(0.0F, distance)); });
  const auto isNarrow = [&](const std::vector<int>& piece)
  { return widthOfPiece(piece, distances) < width; };
  const auto isThin = [&](const std::vector<int>& piece)
  { return isNarrow(piece) || widthOfPiece(piece, distances) <= 2.0 * offset; };
  // In the second round, the ball of cutHandles() begins with the wide cuts of the first round, so
  // that cuts are at other positions.
  constexpr float first = 1e6F;
  std::vector<float> depths = distances;
  for (int round = 0; round < 2; ++round)
  {
    std::vector<std::uint8_t> changed = inside;
    fillHandles(grid, changed, values, steps.next());
    result.NumberOfFilledNodes +=
      change(grid, piecesBetween(grid, inside, changed), isNarrow, inside);
    changed = inside;
    cutHandles(grid, changed, depths, offset, HandleCut::HalfWay, steps.next());
    const std::vector<std::vector<int>> pieces = piecesBetween(grid, inside, changed);
    result.NumberOfCutNodes += change(grid, pieces, isThin, inside);
    for (const std::vector<int>& piece : pieces)
    {
      for (const int node : piece)
      {
        depths[node] += inside[node] ? first : 0.0F;
      }
    }
  }
  keepLargestPiece(grid, inside);
  fillCavities(grid, inside);
  run.report(1.0);
  return result;
}
}
