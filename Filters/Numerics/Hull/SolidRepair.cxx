#include "Hull/SolidRepair.h"

#include "Base/Steps.h"
#include "Hull/GridSolid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace conformal
{
namespace
{
/// Base cost of changing a node. The difference of the node's indicator from the level is added.
constexpr double NodeCost = 0.02;

/// Maximum size of a tiny component, relative to all nodes inside.
constexpr double TinyPiece = 0.0005;
/// Maximum path length, in sides of a cube of equally many nodes.
constexpr double ReachOfPiece = 1.0;
constexpr double FarthestReach = 0.1; ///< maximum path length, in units of the maximum radius
/// Maximum path length across a hole, in units of the maximum radius, and minimum indicator on the
/// path, in levels. The indicator is high between the open ends of a limb, and about 0 between
/// separate objects, whose ends are closed.
constexpr double FarthestAcrossHole = 0.5, AcrossHole = 0.15;
/// Minimum indicator of nodes that fill a hole, relative to the minimum on the path across the
/// hole. All shortest paths have the same cost, so the path may be at the side of the hole.
constexpr double WideAcrossHole = 0.7;
constexpr int NumberOfRounds = 3;
/// Minimum difference from the level of a node clearly inside or outside.
constexpr double Definite = 0.25;

/// Node with its path cost; ordered by the lowest cost, then by the lowest node.
struct Reached
{
  float Cost;
  int Node;
  bool operator<(const Reached& other) const
  {
    return this->Cost > other.Cost || (this->Cost == other.Cost && this->Node > other.Node);
  }
};

/// Shortest paths through the outside from a growing solid.
class Ways
{
public:
  Ways(const FreudenthalGrid& grid, const Indicator& indicator)
    : Steps(grid.neighborSteps())
    , Field(indicator)
    , Costs(indicator.Values.size(), std::numeric_limits<float>::infinity())
    , From(indicator.Values.size(), -1)
    , Faces(grid)
  {
  }

  void start(const std::vector<int>& nodes)
  {
    for (const int node : nodes)
    {
      this->Costs[node] = 0.0F;
      this->From[node] = -1;
      this->Queue.push({ 0.0F, node });
    }
  }

  /// Return the next node reached that has the mark, or -1.
  int next(const std::vector<std::uint8_t>& marks, std::uint8_t mark, const Run& run)
  {
    constexpr Index nodesPerReport = 1 << 16;
    while (!this->Queue.empty())
    {
      const Reached at = this->Queue.top();
      this->Queue.pop();
      if (at.Cost > this->Costs[at.Node])
      {
        continue;
      }
      if (marks[at.Node] == mark)
      {
        return at.Node;
      }
      if (++this->Looks % nodesPerReport == 0)
      {
        run.report(
          std::min(1.0, static_cast<double>(this->Looks) / static_cast<double>(marks.size())));
      }
      for (const int step : this->Steps)
      {
        const int node = at.Node + step;
        const double missing = std::max(0.0, this->Field.Level - this->Field.Values[node]);
        const float cost = at.Cost + static_cast<float>(NodeCost + missing);
        if (cost < this->Costs[node] && !this->Faces.near(node))
        {
          this->Costs[node] = cost;
          this->From[node] = at.Node;
          this->Queue.push({ cost, node });
        }
      }
    }
    return -1;
  }

  /// Return the path from a node to the solid, both ends included.
  std::vector<int> way(int node) const
  {
    std::vector<int> nodes;
    for (; node >= 0; node = this->From[node])
    {
      nodes.push_back(node);
    }
    return nodes;
  }

private:
  /// Test for nodes in the three outer layers of the grid. Paths, and the neighbors of their nodes,
  /// avoid these layers.
  struct FaceTest
  {
    explicit FaceTest(const FreudenthalGrid& grid)
      : Grid(grid)
    {
    }
    bool near(int node) const
    {
      const Eigen::Vector3i x = this->Grid.coordinates(node);
      const Eigen::Map<const Eigen::Vector3i> size(this->Grid.Size.data());
      return x.minCoeff() < 3 || (size - x).minCoeff() < 4;
    }
    const FreudenthalGrid& Grid;
  };

  const std::array<int, 14> Steps;
  const Indicator& Field;
  std::vector<float> Costs;
  std::vector<int> From;
  FaceTest Faces;
  std::priority_queue<Reached> Queue;
  Index Looks = 0;
};

/// Change of some connected nodes that would open a handle.
struct Repair
{
  std::vector<int> Nodes;
  double Cost = 0.0;
};

/// Append the connected components of the difference between two sets.
void addRepairs(const FreudenthalGrid& grid, const Indicator& indicator,
  const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& after,
  std::vector<Repair>& repairs)
{
  constexpr std::uint8_t unseen = 1, seen = 2;
  std::vector<std::uint8_t> marks(before.size());
  for (std::size_t node = 0; node < marks.size(); ++node)
  {
    marks[node] = before[node] != after[node] ? unseen : 0;
  }
  for (int node = 0; node < static_cast<int>(marks.size()); ++node)
  {
    if (marks[node] == unseen)
    {
      Repair repair;
      markPiece(grid, marks, node, seen, repair.Nodes);
      for (const int changed : repair.Nodes)
      {
        repair.Cost += std::abs(indicator.Values[changed] - indicator.Level) + NodeCost;
      }
      repairs.push_back(std::move(repair));
    }
  }
}

/// Join the components of a solid into one, whose nodes are marked Joined.
class PieceJoin
{
public:
  static constexpr std::uint8_t Outside = 0, Unseen = 1, Apart = 2, Joined = 3;

  PieceJoin(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
    const std::function<bool(int node)>& hasSamples)
    : Grid(grid)
    , Inside(inside)
    , HasSamples(hasSamples)
  {
  }

  /// Remove tiny components. Mark the largest component as Joined, the others as Apart. Return the
  /// components, the largest first. Among equal components, the one with the lowest node is first.
  std::vector<std::vector<int>> largePieces()
  {
    std::vector<std::vector<int>> pieces;
    std::size_t total = 0;
    for (int node = 0; node < static_cast<int>(this->Inside.size()); ++node)
    {
      if (this->Inside[node] == Unseen)
      {
        pieces.emplace_back();
        markPiece(this->Grid, this->Inside, node, Apart, pieces.back());
        total += pieces.back().size();
      }
    }
    std::stable_sort(pieces.begin(), pieces.end(),
      [](const auto& a, const auto& b) { return a.size() > b.size(); });
    while (!pieces.empty() &&
      static_cast<double>(pieces.back().size()) < TinyPiece * static_cast<double>(total))
    {
      this->mark(pieces.back(), Outside);
      pieces.pop_back();
    }
    if (!pieces.empty())
    {
      this->mark(pieces.front(), Joined);
    }
    return pieces;
  }

  /// Join each component to the first one by the cheapest path. If the path is too long, remove the
  /// component.
  /// @return the number of nodes added
  Index joinToFirst(
    const std::vector<std::vector<int>>& pieces, const Indicator& indicator, const Run& run)
  {
    Index count = 0;
    Ways ways(this->Grid, indicator);
    ways.start(pieces.front());
    for (std::size_t left = pieces.size() - 1; left > 0; --left)
    {
      const int end = ways.next(this->Inside, Apart, run);
      if (end < 0)
      {
        break;
      }
      std::vector<int> piece;
      markPiece(this->Grid, this->Inside, end, Joined, piece);
      const std::vector<int> way = ways.way(end);
      const double side = std::cbrt(static_cast<double>(piece.size()));
      const double length = this->lengthOutside(way);
      if (length <= std::min(ReachOfPiece * side, FarthestReach / this->Grid.Spacing))
      {
        count += this->fill(way);
      }
      else if (this->leadsAcrossHole(way, length, indicator))
      {
        count += this->fillWide(way, indicator, static_cast<int>(side)) + this->fill(way);
      }
      else
      {
        this->mark(piece, Outside);
        continue;
      }
      ways.start(piece);
      ways.start(way);
    }
    return count;
  }

private:
  void mark(const std::vector<int>& nodes, std::uint8_t as)
  {
    for (const int node : nodes)
    {
      this->Inside[node] = as;
    }
  }

  double lengthOutside(const std::vector<int>& way) const
  {
    return static_cast<double>(std::count_if(
      way.begin(), way.end(), [&](int node) { return this->Inside[node] == Outside; }));
  }

  bool leadsAcrossHole(const std::vector<int>& way, double length, const Indicator& indicator) const
  {
    if (length > FarthestAcrossHole / this->Grid.Spacing ||
      lowestOn(way, indicator) < AcrossHole * indicator.Level)
    {
      return false;
    }
    const auto isOutside = [&](int node) { return this->Inside[node] == Outside; };
    const auto first = std::find_if(way.begin(), way.end(), isOutside);
    const auto last = std::find_if(way.rbegin(), way.rend(), isOutside);
    return !this->HasSamples || !(this->HasSamples(*first) || this->HasSamples(*last));
  }

  static double lowestOn(const std::vector<int>& way, const Indicator& indicator)
  {
    float lowest = std::numeric_limits<float>::infinity();
    for (const int node : way)
    {
      lowest = std::min(lowest, indicator.Values[node]);
    }
    return lowest;
  }

  /// Fill nodes around a path, up to a distance in nodes, where the indicator is about as high as
  /// on the path. The three outer layers of the grid stay outside.
  Index fillWide(const std::vector<int>& way, const Indicator& indicator, int distance)
  {
    Index count = 0;
    const float enough = static_cast<float>(WideAcrossHole) * lowestOn(way, indicator);
    for (const int center : way)
    {
      const Vector3 at = this->Grid.coordinates(center).cast<double>();
      forNodesNear(this->Grid, at, distance, 3,
        [&](int node)
        {
          if (this->Inside[node] == Outside && indicator.Values[node] >= enough)
          {
            this->Inside[node] = Joined;
            ++count;
          }
        });
    }
    return count;
  }

  Index fill(const std::vector<int>& way)
  {
    Index count = 0;
    for (const int node : way)
    {
      count += this->Inside[node] == Outside;
      this->Inside[node] = Joined;
      for (const int step : this->Steps)
      {
        std::uint8_t& neighbor = this->Inside[node + step];
        count += neighbor == Outside;
        neighbor = neighbor == Outside ? Joined : neighbor;
      }
    }
    return count;
  }

  const FreudenthalGrid& Grid;
  std::vector<std::uint8_t>& Inside;
  const std::function<bool(int node)>& HasSamples;
  const std::array<int, 14> Steps = Grid.neighborSteps();
};
}

//------------------------------------------------------------------------------
Index joinPieces(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const std::function<bool(int node)>& hasSamples,
  const Run& run)
{
  PieceJoin join(grid, inside, hasSamples);
  std::vector<std::vector<int>> pieces = join.largePieces();
  const Index count = pieces.size() > 1 ? join.joinToFirst(pieces, indicator, run) : 0;
  for (std::uint8_t& node : inside)
  {
    node = node == PieceJoin::Joined;
  }
  return count;
}

//------------------------------------------------------------------------------
Index fillCavities(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run)
{
  constexpr std::uint8_t unseen = 0, solid = 1, face = 2, open = 3, cavity = 4;
  for (int z = 0; z < grid.Size[2]; ++z)
  {
    for (int y = 0; y < grid.Size[1]; ++y)
    {
      const bool all = z == 0 || y == 0 || z + 1 == grid.Size[2] || y + 1 == grid.Size[1];
      for (int x = 0; x < grid.Size[0]; x += all ? 1 : grid.Size[0] - 1)
      {
        inside[grid.node(x, y, z)] = face;
      }
    }
  }
  std::vector<int> nodes;
  markPiece(grid, inside, grid.node(1, 1, 1), open, nodes, run);
  Index count = 0;
  for (int node = 0; node < static_cast<int>(inside.size()); ++node)
  {
    if (inside[node] == unseen)
    {
      markPiece(grid, inside, node, cavity, nodes);
      ++count;
    }
  }
  for (std::uint8_t& mark : inside)
  {
    mark = mark == solid || mark == cavity;
  }
  return count;
}

//------------------------------------------------------------------------------
HandleRepair openHandles(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const std::function<bool(const std::vector<int>&)>& isKept,
  const Run& run)
{
  HandleRepair done;
  const std::vector<std::uint8_t> before = inside;
  Index euler = eulerNumber(grid, inside);
  for (int round = 0; round < NumberOfRounds && euler < 1; ++round)
  {
    constexpr double share = 1.0 / (NumberOfRounds + 1);
    Steps steps(run.part(round * share, (round + 1) * share), { 1.0, 1.0 });
    std::vector<Repair> repairs;
    std::vector<std::uint8_t> changed = inside;
    cutHandles(grid, changed, indicator.Values, indicator.Level, HandleCut::HalfWay, steps.next());
    addRepairs(grid, indicator, inside, changed, repairs);
    changed = inside;
    fillHandles(grid, changed, indicator.Values, steps.next());
    addRepairs(grid, indicator, inside, changed, repairs);
    std::stable_sort(repairs.begin(), repairs.end(),
      [](const Repair& a, const Repair& b) { return a.Cost < b.Cost; });
    const auto change = [&](const Repair& repair)
    {
      for (const int node : repair.Nodes)
      {
        inside[node] = !inside[node];
      }
    };
    for (const Repair& repair : repairs)
    {
      if (isKept && isKept(repair.Nodes))
      {
        continue;
      }
      const Index around = eulerNumberAround(grid, inside, repair.Nodes);
      change(repair);
      const Index gain = eulerNumberAround(grid, inside, repair.Nodes) - around;
      if (gain > 0 && euler + gain <= 1)
      {
        euler += gain;
      }
      else
      {
        change(repair);
      }
    }
  }
  // Remove components that the rounds left, or that simultaneous changes may have created.
  keepLargestPiece(grid, inside);
  fillCavities(grid, inside);
  if (!isKept && eulerNumber(grid, inside) != 1)
  {
    cutHandles(grid, inside, indicator.Values, indicator.Level, HandleCut::HalfWay);
  }
  run.report(1.0);
  for (std::size_t node = 0; node < inside.size(); ++node)
  {
    if (inside[node] != before[node])
    {
      done.NumberOfCutNodes += before[node];
      done.NumberOfFilledNodes += inside[node];
      done.NumberOfDefiniteNodes += std::abs(indicator.Values[node] - indicator.Level) > Definite;
    }
  }
  return done;
}
}
