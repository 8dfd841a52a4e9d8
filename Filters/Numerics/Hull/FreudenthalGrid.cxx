#include "Hull/FreudenthalGrid.h"

#include <algorithm>

namespace conformal
{
namespace
{
constexpr int NumberOfNeighbors = 14;

Eigen::Vector3i neighborDirection(int i)
{
  const int corner = i % 7 + 1;
  const Eigen::Vector3i up(corner & 1, (corner >> 1) & 1, corner >> 2);
  return i < 7 ? up : Eigen::Vector3i(-up);
}

bool areNeighbors(const Eigen::Vector3i& a, const Eigen::Vector3i& b)
{
  const Eigen::Vector3i step = b - a;
  return step != Eigen::Vector3i::Zero() && step.cwiseAbs().maxCoeff() == 1 &&
    (step.minCoeff() >= 0 || step.maxCoeff() <= 0);
}

// Return whether a set of neighbors is connected and not empty. Two neighbors of a node are
// adjacent if they are neighbors of each other.
bool isConnected(unsigned int set, const std::array<unsigned int, NumberOfNeighbors>& neighborsOf)
{
  unsigned int reached = 0, next = set & (~set + 1);
  while (next != reached)
  {
    reached = next;
    for (int i = 0; i < NumberOfNeighbors; ++i)
    {
      next |= (reached >> i & 1U) ? neighborsOf[i] & set : 0U;
    }
  }
  return set != 0 && reached == set;
}

std::vector<bool> makeSimpleNodeTable()
{
  std::array<unsigned int, NumberOfNeighbors> neighborsOf = {};
  for (int i = 0; i < NumberOfNeighbors; ++i)
  {
    for (int j = 0; j < NumberOfNeighbors; ++j)
    {
      neighborsOf[i] |= areNeighbors(neighborDirection(i), neighborDirection(j)) ? 1U << j : 0U;
    }
  }
  constexpr unsigned int all = (1U << NumberOfNeighbors) - 1;
  std::vector<bool> table(all + 1);
  for (unsigned int set = 0; set <= all; ++set)
  {
    table[set] = isConnected(set, neighborsOf) && isConnected(all & ~set, neighborsOf);
  }
  return table;
}

// Compute the part of the Euler number that is due to simplices whose lowest node is a given corner
// of a cube. Such a simplex is an ascending path through corners: the bits of each corner include
// all bits of the previous corner.
int eulerShare(unsigned int corners, unsigned int from)
{
  int sum = 1;
  for (unsigned int to = from + 1; to < 8; ++to)
  {
    if ((to & from) == from && (corners >> to & 1U))
    {
      sum -= eulerShare(corners, to);
    }
  }
  return sum;
}

class EulerShares
{
public:
  EulerShares(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside)
    : Steps(grid.cornerSteps())
    , Inside(inside)
  {
    for (unsigned int corners = 0; corners < 256; ++corners)
    {
      this->Shares[corners] = (corners & 1U) ? eulerShare(corners, 0) : 0;
    }
  }
  // Return the part of the Euler number that is due to simplices whose lowest node is the given
  // node.
  int of(int node) const
  {
    if (!this->Inside[node])
    {
      return 0;
    }
    unsigned int corners = 1;
    for (int s = 1; s < 8; ++s)
    {
      corners |= static_cast<unsigned int>(this->Inside[node + this->Steps[s]]) << s;
    }
    return this->Shares[corners];
  }

private:
  const std::array<int, 8> Steps;
  const std::vector<std::uint8_t>& Inside;
  std::array<int, 256> Shares;
};
}

//------------------------------------------------------------------------------
std::array<int, 8> FreudenthalGrid::cornerSteps() const
{
  std::array<int, 8> steps;
  for (int s = 0; s < 8; ++s)
  {
    steps[s] = this->node(s & 1, (s >> 1) & 1, s >> 2);
  }
  return steps;
}

//------------------------------------------------------------------------------
std::array<int, 14> FreudenthalGrid::neighborSteps() const
{
  const std::array<int, 8> corner = this->cornerSteps();
  std::array<int, 14> steps;
  for (int s = 1; s < 8; ++s)
  {
    steps[s - 1] = corner[s];
    steps[s + 6] = -corner[s];
  }
  return steps;
}

//------------------------------------------------------------------------------
void forInnerRows(
  const FreudenthalGrid& grid, const Run& run, const std::function<void(int, int)>& body)
{
  constexpr Index blockSize = 16;
  const int width = grid.Size[1] - 2;
  forBlocksReporting(run, static_cast<Index>(width) * (grid.Size[2] - 2), blockSize,
    [&](Index begin, Index end)
    {
      for (Index row = begin; row < end; ++row)
      {
        const int first =
          grid.node(1, 1 + static_cast<int>(row % width), 1 + static_cast<int>(row / width));
        body(first, first + grid.Size[0] - 2);
      }
    });
}

//------------------------------------------------------------------------------
void markPiece(const FreudenthalGrid& grid, std::vector<std::uint8_t>& marks, int start,
  std::uint8_t mark, std::vector<int>& reached, const Run& run)
{
  constexpr std::size_t nodesPerReport = 1 << 18;
  const std::array<int, 14> steps = grid.neighborSteps();
  const std::uint8_t old = marks[start];
  reached.assign(1, start);
  marks[start] = mark;
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    const int node = reached[next];
    for (const int step : steps)
    {
      if (marks[node + step] == old)
      {
        marks[node + step] = mark;
        reached.push_back(node + step);
      }
    }
    if ((next + 1) % nodesPerReport == 0)
    {
      run.report(static_cast<double>(next) / static_cast<double>(marks.size()));
    }
  }
}

//------------------------------------------------------------------------------
Index eulerNumber(
  const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside, const Run& run)
{
  const EulerShares shares(grid, inside);
  Index sum = 0;
  forInnerRows(grid, run.inOrder(),
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        sum += shares.of(node);
      }
    });
  return sum;
}

//------------------------------------------------------------------------------
Index eulerNumberAround(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<int>& nodes)
{
  // A node contributes to the lowest corners of all cubes that contain it.
  std::vector<int> corners;
  for (const int node : nodes)
  {
    for (const int step : grid.cornerSteps())
    {
      corners.push_back(node - step);
    }
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  const EulerShares shares(grid, inside);
  Index sum = 0;
  for (const int corner : corners)
  {
    sum += shares.of(corner);
  }
  return sum;
}

//------------------------------------------------------------------------------
bool isSimpleNode(unsigned int neighbors)
{
  static const std::vector<bool> table = makeSimpleNodeTable();
  return table[neighbors];
}
}
