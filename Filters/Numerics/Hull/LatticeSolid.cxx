#include "Hull/LatticeSolid.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace conformal
{
namespace
{
constexpr Index NodesPerReport = 1 << 16;

// A node that waits to be added; the lowest key first, then the lowest node.
struct Waiting
{
  float Key;
  int Node;
  bool operator<(const Waiting& other) const
  {
    return this->Key > other.Key || (this->Key == other.Key && this->Node > other.Node);
  }
};
}

//------------------------------------------------------------------------------
Index keepLargestPiece(
  const FreudenthalLattice& lattice, std::vector<std::uint8_t>& inside, const Progress& progress)
{
  constexpr std::uint8_t unseen = 1, seen = 2, kept = 3;
  std::vector<int> piece, largest;
  for (int node = 0; node < static_cast<int>(inside.size()); ++node)
  {
    if (inside[node] == unseen)
    {
      markPiece(lattice, inside, node, seen, piece, progress);
      if (piece.size() > largest.size())
      {
        piece.swap(largest);
      }
    }
  }
  for (const int node : largest)
  {
    inside[node] = kept;
  }
  for (std::uint8_t& mark : inside)
  {
    mark = mark == kept;
  }
  return static_cast<Index>(largest.size());
}

//------------------------------------------------------------------------------
Index cutHandles(const FreudenthalLattice& lattice, std::vector<std::uint8_t>& inside,
  const std::vector<float>& distances, double offset, HandleCut place, const Progress& progress)
{
  const std::array<int, 14> steps = lattice.neighborSteps();
  std::array<float, 14> lengths;
  for (int i = 0; i < 14; ++i)
  {
    const int corner = i % 7 + 1;
    lengths[i] = std::sqrt(static_cast<float>((corner & 1) + (corner >> 1 & 1) + (corner >> 2)));
  }
  int deepest = -1;
  Index total = 0;
  for (int node = 0; node < static_cast<int>(inside.size()); ++node)
  {
    total += inside[node];
    if (inside[node] && (deepest < 0 || distances[node] > distances[deepest]))
    {
      deepest = node;
    }
  }
  if (deepest < 0)
  {
    return 0;
  }
  std::vector<std::uint8_t> grown(inside.size(), 0);
  std::vector<std::uint8_t> waits(inside.size(), 0);
  std::priority_queue<Waiting> queue;
  // Below 0 beyond the offset, by depth; above, the way from there or the distance to the data.
  const auto push = [&](int node, float way)
  {
    const float later = place == HandleCut::HalfWay ? std::max(0.0F, way) : distances[node];
    const float key = distances[node] > offset ? -distances[node] : later;
    waits[node] = 1;
    queue.push({ key, node });
  };
  Index count = 0, looks = 0;
  push(deepest, 0.0F);
  while (!queue.empty())
  {
    const Waiting next = queue.top();
    queue.pop();
    waits[next.Node] = 0;
    if (++looks % NodesPerReport == 0)
    {
      report(progress, std::min(1.0, count / static_cast<double>(total)));
    }
    unsigned int neighbors = 0;
    for (int i = 0; i < 14; ++i)
    {
      neighbors |= static_cast<unsigned int>(grown[next.Node + steps[i]]) << i;
    }
    if (count > 0 && !isSimpleNode(neighbors))
    {
      continue; // a neighbor added later brings it back
    }
    grown[next.Node] = 1;
    ++count;
    for (int i = 0; i < 14; ++i)
    {
      const int node = next.Node + steps[i];
      if (inside[node] && !grown[node] && !waits[node])
      {
        push(node, std::max(0.0F, next.Key) + lengths[i]);
      }
    }
  }
  inside.swap(grown);
  return total - count;
}

//------------------------------------------------------------------------------
Index largestCutNearData(const FreudenthalLattice& lattice, const std::vector<std::uint8_t>& uncut,
  const std::vector<std::uint8_t>& cut, const std::vector<float>& distances, double nearness)
{
  constexpr std::uint8_t unseen = 1, seen = 2;
  std::vector<std::uint8_t> nodes(uncut.size());
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    nodes[node] = uncut[node] && !cut[node];
  }
  Index most = 0;
  std::vector<int> piece;
  for (int node = 0; node < static_cast<int>(nodes.size()); ++node)
  {
    if (nodes[node] == unseen)
    {
      markPiece(lattice, nodes, node, seen, piece);
      most = std::max<Index>(most,
        std::count_if(
          piece.begin(), piece.end(), [&](int of) { return distances[of] <= nearness; }));
    }
  }
  return most;
}
}
