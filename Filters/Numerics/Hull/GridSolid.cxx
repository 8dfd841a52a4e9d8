#include "Hull/GridSolid.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace conformal
{
namespace
{
constexpr Index NodesPerReport = 1 << 16;

// Candidate node; ordered by the lowest key, then by the lowest node.
struct Waiting
{
  float Key;
  int Node;
  bool operator<(const Waiting& other) const
  {
    return this->Key > other.Key || (this->Key == other.Key && this->Node > other.Node);
  }
};

// Maximum of the values in keys; less than 1, the difference between layers.
constexpr float MaximumValue = 0.99F;

// Compute the number of steps from each node to a set. The number is 0 in the set and on the faces
// of the grid.
std::vector<int> layersAround(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside)
{
  const std::array<int, 14> steps = grid.neighborSteps();
  std::vector<int> layers(inside.size(), 0);
  forInnerRows(grid, {},
    [&](int first, int last)
    {
      for (int node = first; node < last; ++node)
      {
        layers[node] = inside[node] ? 0 : -1; // not yet computed
      }
    });
  std::vector<int> front, next;
  for (int node = 0; node < static_cast<int>(inside.size()); ++node)
  {
    if (inside[node])
    {
      front.push_back(node);
    }
  }
  for (int layer = 1; !front.empty(); ++layer)
  {
    next.clear();
    for (const int node : front)
    {
      for (const int step : steps)
      {
        if (layers[node + step] < 0)
        {
          layers[node + step] = layer;
          next.push_back(node + step);
        }
      }
    }
    front.swap(next);
  }
  return layers;
}

// Grow a set of nodes within another set. Only simple nodes are added, which preserve the topology
// of the growing set. The node with the lowest key is first. The key of a node may depend on the
// path to the node.
template <typename KeyOf>
class Growth
{
public:
  Growth(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& within, const KeyOf& keyOf)
    : Grid(grid)
    , Within(within)
    , Key(keyOf)
    , Grown(within.size(), 0)
    , Waits(within.size(), 0)
  {
    for (int i = 0; i < 14; ++i)
    {
      const int corner = i % 7 + 1;
      this->Lengths[i] =
        std::sqrt(static_cast<float>((corner & 1) + (corner >> 1 & 1) + (corner >> 2)));
    }
  }

  void begin(int node)
  {
    this->Grown[node] = 1;
    this->Count = 1;
    this->pushAround(node, this->Key(node, 0.0F));
  }

  // Start with all nodes on the faces of the grid. Return their number.
  Index beginAtFaces()
  {
    const std::array<int, 3>& size = this->Grid.Size;
    Index count = 0;
    const auto layer = [&](int x, int y, int z) {
      return std::min({ x, y, z, size[0] - 1 - x, size[1] - 1 - y, size[2] - 1 - z });
    };
    for (int node = 0; node < static_cast<int>(this->Within.size()); ++node)
    {
      const Eigen::Vector3i x = this->Grid.coordinates(node);
      const int depth = layer(x[0], x[1], x[2]);
      if (depth == 0)
      {
        this->Grown[node] = 1;
        ++count;
      }
      else if (depth == 1 && this->Within[node])
      {
        this->push(node, 0.0F);
      }
    }
    return count;
  }

  // Add simple nodes until none is left. Return the final number of nodes, including the node of
  // begin().
  Index grow(Index total, const Run& run)
  {
    Index looks = 0;
    while (!this->Queue.empty())
    {
      const Waiting next = this->Queue.top();
      this->Queue.pop();
      this->Waits[next.Node] = 0;
      if (++looks % NodesPerReport == 0)
      {
        run.report(std::min(1.0, static_cast<double>(this->Count) / static_cast<double>(total)));
      }
      unsigned int neighbors = 0;
      for (int i = 0; i < 14; ++i)
      {
        neighbors |= static_cast<unsigned int>(this->Grown[next.Node + this->Steps[i]]) << i;
      }
      if (isSimpleNode(neighbors)) // otherwise, a neighbor added later inserts it again
      {
        this->Grown[next.Node] = 1;
        ++this->Count;
        this->pushAround(next.Node, next.Key);
      }
    }
    return this->Count;
  }

  std::vector<std::uint8_t>& grown() { return this->Grown; }

private:
  void push(int node, float way)
  {
    this->Waits[node] = 1;
    this->Queue.push({ this->Key(node, way), node });
  }

  void pushAround(int node, float key)
  {
    for (int i = 0; i < 14; ++i)
    {
      const int other = node + this->Steps[i];
      if (this->Within[other] && !this->Grown[other] && !this->Waits[other])
      {
        this->push(other, std::max(0.0F, key) + this->Lengths[i]);
      }
    }
  }

  const FreudenthalGrid& Grid;
  const std::vector<std::uint8_t>& Within;
  const KeyOf Key;
  const std::array<int, 14> Steps = Grid.neighborSteps();
  std::array<float, 14> Lengths;
  std::vector<std::uint8_t> Grown, Waits;
  std::priority_queue<Waiting> Queue;
  Index Count = 0;
};
}

//------------------------------------------------------------------------------
Index keepLargestPiece(
  const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run)
{
  constexpr std::uint8_t unseen = 1, seen = 2, kept = 3;
  std::vector<int> piece, largest;
  for (int node = 0; node < static_cast<int>(inside.size()); ++node)
  {
    if (inside[node] == unseen)
    {
      markPiece(grid, inside, node, seen, piece, run);
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
Index cutHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& distances, double offset, HandleCut place, const Run& run)
{
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
  // The key of an enclosed node is its negative depth. The key of another node is the path length
  // from the enclosed nodes, or the distance to the data.
  const auto keyOf = [&](int node, float way)
  {
    const float later = place == HandleCut::HalfWay ? std::max(0.0F, way) : distances[node];
    return distances[node] > offset ? -distances[node] : later;
  };
  Growth growth(grid, inside, keyOf);
  growth.begin(deepest);
  const Index count = growth.grow(total, run);
  inside.swap(growth.grown());
  return total - count;
}

//------------------------------------------------------------------------------
Index fillHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, const Run& run)
{
  std::vector<std::uint8_t> outside(inside.size());
  Index total = 0;
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    outside[node] = !inside[node];
    total += outside[node];
  }
  const std::vector<int> layers = layersAround(grid, inside);
  const auto keyOf = [&](int node, float)
  { return std::clamp(values[node], 0.0F, MaximumValue) - static_cast<float>(layers[node]); };
  Growth growth(grid, outside, keyOf);
  const Index count = growth.beginAtFaces() + growth.grow(total, run);
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    inside[node] = !growth.grown()[node];
  }
  return total - count;
}

//------------------------------------------------------------------------------
Index maximumCutNearData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& uncut,
  const std::vector<std::uint8_t>& cut, const std::vector<float>& distances, double nearness)
{
  constexpr std::uint8_t unseen = 1, seen = 2;
  std::vector<std::uint8_t> nodes(uncut.size());
  for (std::size_t node = 0; node < nodes.size(); ++node)
  {
    nodes[node] = uncut[node] && !cut[node];
  }
  Index maximum = 0;
  std::vector<int> piece;
  for (int node = 0; node < static_cast<int>(nodes.size()); ++node)
  {
    if (nodes[node] == unseen)
    {
      markPiece(grid, nodes, node, seen, piece);
      maximum = std::max<Index>(maximum,
        std::count_if(
          piece.begin(), piece.end(), [&](int of) { return distances[of] <= nearness; }));
    }
  }
  return maximum;
}
}
