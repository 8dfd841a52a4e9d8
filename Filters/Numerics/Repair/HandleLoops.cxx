#include "Repair/HandleLoops.h"

#include "Base/DisjointSets.h"
#include "Base/Steps.h"

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <utility>

namespace conformal
{
namespace
{
/// Homology class of a loop: the sum, modulo 2, of the classes of its edges, which is invariant
/// when the loop moves over triangles. It is 0 for separating loops. The exact class has 2 g bits.
/// These are hashed to a fixed number of bits, which preserves sums: loops with different hashes
/// have different classes.
using LoopClass = std::bitset<256>;

// Adjacent vertices of each vertex, with the connecting edges.
struct SidesOfVertices
{
  std::vector<int> Begin, Sides; // those from vertex v: Sides[Begin[v]] to Sides[Begin[v + 1] - 1]

  explicit SidesOfVertices(const GluedSurface& surface)
    : Begin(surface.numberOfVertices() + 1, 0)
    , Sides(surface.numberOfSides())
  {
    for (const int vertex : surface.Corners)
    {
      ++this->Begin[vertex + 1];
    }
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    std::vector<int> end(this->Begin.begin(), this->Begin.end() - 1);
    for (int side = 0; side < surface.numberOfSides(); ++side)
    {
      this->Sides[end[surface.from(side)]++] = side;
    }
  }
};

// Surface with the lengths and classes of its edges.
struct LoopSpace
{
  LoopSpace(const GluedSurface& surface, const std::vector<double>& lengths)
    : Surface(surface)
    , Lengths(lengths)
    , Around(surface)
    , ClassOf(surface.numberOfSides(), 0)
    , Classes(1)
  {
  }

  const LoopClass& classOf(int side) const { return this->Classes[this->ClassOf[side]]; }

  const GluedSurface& Surface;
  const std::vector<double>& Lengths;
  SidesOfVertices Around;
  std::vector<int> ClassOf; // of each side, in Classes; 0 for most
  std::vector<LoopClass> Classes;
};

using Place = std::pair<double, int>; // distance and vertex
using Queue = std::priority_queue<Place, std::vector<Place>, std::greater<Place>>;

// Shortest paths from one vertex to all others.
struct PathTree
{
  std::vector<double> Distances;
  std::vector<int> SidesTo; // side by which each vertex is reached; -1 for the first
};

PathTree shortestPaths(const LoopSpace& space, int root)
{
  const auto size = static_cast<std::size_t>(space.Surface.numberOfVertices());
  PathTree tree = { std::vector<double>(size, std::numeric_limits<double>::infinity()),
    std::vector<int>(size, -1) };
  Queue queue;
  tree.Distances[root] = 0.0;
  queue.emplace(0.0, root);
  while (!queue.empty())
  {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > tree.Distances[vertex])
    {
      continue;
    }
    for (int i = space.Around.Begin[vertex]; i < space.Around.Begin[vertex + 1]; ++i)
    {
      const int side = space.Around.Sides[i], other = space.Surface.to(side);
      const double reached = distance + space.Lengths[side];
      if (reached < tree.Distances[other])
      {
        tree.Distances[other] = reached;
        tree.SidesTo[other] = side;
        queue.emplace(reached, other);
      }
    }
  }
  return tree;
}

// Return the loop of a side and the paths to its ends, without their common part.
HandleLoop loopOf(const LoopSpace& space, const std::vector<int>& sidesTo, int side)
{
  const auto pathTo = [&](int vertex)
  {
    std::vector<int> path;
    for (int last = sidesTo[vertex]; last >= 0; last = sidesTo[space.Surface.from(last)])
    {
      path.push_back(last);
    }
    std::reverse(path.begin(), path.end());
    return path;
  };
  const std::vector<int> to = pathTo(space.Surface.from(side)),
                         back = pathTo(space.Surface.to(side));
  std::size_t common = 0;
  while (common < std::min(to.size(), back.size()) && to[common] == back[common])
  {
    ++common;
  }
  HandleLoop loop;
  loop.Sides.assign(to.begin() + static_cast<std::ptrdiff_t>(common), to.end());
  loop.Sides.push_back(side);
  for (std::size_t i = back.size(); i > common; --i)
  {
    loop.Sides.push_back(space.Surface.Across[back[i - 1]]);
  }
  for (const int each : loop.Sides)
  {
    loop.Length += space.Lengths[each];
  }
  return loop;
}

// Return one side of each of the 2 g edges outside of both trees: the tree of paths, and a tree of
// triangles across the other edges. Edges of long loops are added to the second tree first, so that
// those of short loops remain.
std::vector<int> looseEdges(
  const LoopSpace& space, const PathTree& paths, std::vector<char>& isCrossed)
{
  const GluedSurface& surface = space.Surface;
  std::vector<char> isPath(surface.numberOfSides(), 0);
  for (const int side : paths.SidesTo)
  {
    if (side >= 0)
    {
      isPath[side] = isPath[surface.Across[side]] = 1;
    }
  }
  std::vector<std::pair<double, int>> others;
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    if (side < surface.Across[side] && !isPath[side])
    {
      others.emplace_back(-(paths.Distances[surface.from(side)] + space.Lengths[side] +
                            paths.Distances[surface.to(side)]),
        side);
    }
  }
  std::sort(others.begin(), others.end());
  DisjointSets sets(surface.numberOfTriangles());
  std::vector<int> loose;
  for (const auto& [length, side] : others)
  {
    if (sets.unite(side / 3, surface.Across[side] / 3))
    {
      isCrossed[side] = isCrossed[surface.Across[side]] = 1;
    }
    else
    {
      loose.push_back(side);
    }
  }
  return loose;
}

// Set the classes of edges. Each remaining edge defines a dual loop, which crosses this edge and
// edges of the tree of triangles. The dual loop crosses no other remaining edge. The class of an
// edge is the sum of the classes of the dual loops that cross it.
void setClasses(LoopSpace& space, const std::vector<int>& loose, const std::vector<char>& isCrossed)
{
  const GluedSurface& surface = space.Surface;
  std::mt19937_64 bits(1);
  std::vector<LoopClass> sums(surface.numberOfTriangles());
  const auto set = [&](int side, const LoopClass& value)
  {
    space.ClassOf[side] = space.ClassOf[surface.Across[side]] =
      static_cast<int>(space.Classes.size());
    space.Classes.push_back(value);
  };
  for (const int side : loose)
  {
    LoopClass own;
    for (std::size_t word = 0; word < own.size() / 64; ++word)
    {
      own = (own << 64) | LoopClass(bits());
    }
    set(side, own);
    sums[side / 3] ^= own;
    sums[surface.Across[side] / 3] ^= own;
  }
  std::vector<int> order = { 0 }; // of triangles, each after its predecessor
  std::vector<int> entries(surface.numberOfTriangles(), -1); // side to each triangle
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const int triangle = order[i];
    for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
    {
      const int across = surface.Across[side];
      if (isCrossed[side] && side != entries[triangle])
      {
        entries[across / 3] = across;
        order.push_back(across / 3);
      }
    }
  }
  for (std::size_t i = order.size(); i-- > 1;)
  {
    const int entry = entries[order[i]];
    const LoopClass sum = sums[order[i]];
    if (sum.any())
    {
      set(entry, sum);
      sums[surface.Across[entry] / 3] ^= sum;
    }
  }
}

// Search for short nonseparating loops through given vertices.
class LoopSearch
{
public:
  explicit LoopSearch(const LoopSpace& space)
    : Space(space)
    , SidesTo(space.Surface.numberOfVertices())
    , Visits(space.Surface.numberOfVertices())
  {
  }

  /// Find the shortest nonseparating loop through a vertex, or a nonseparating part of this loop.
  /// @param[in,out] best  replaced by a shorter loop
  bool shorten(int root, HandleLoop& best)
  {
    this->Number += 2;
    Queue queue;
    this->visit(root, 0.0, -1, {});
    queue.emplace(0.0, root);
    double length = best.Length;
    int found = -1;
    while (!queue.empty())
    {
      const auto [distance, vertex] = queue.top();
      queue.pop();
      if (2.0 * distance >= length)
      {
        break;
      }
      Visit& here = this->Visits[vertex];
      if (here.Number == this->Number + 1)
      {
        continue;
      }
      here.Number = this->Number + 1; // the distance is final
      for (int i = this->Space.Around.Begin[vertex]; i < this->Space.Around.Begin[vertex + 1]; ++i)
      {
        const int side = this->Space.Around.Sides[i], other = this->Space.Surface.to(side);
        const double reached = distance + this->Space.Lengths[side];
        const Visit& there = this->Visits[other];
        const LoopClass sum = here.Class ^ this->Space.classOf(side);
        if (there.Number == this->Number + 1)
        {
          if (reached + there.Distance < length && sum != there.Class)
          {
            length = reached + there.Distance;
            found = side;
          }
        }
        else if (2.0 * reached < length &&
          (there.Number != this->Number || reached < there.Distance))
        {
          this->visit(other, reached, side, sum);
          queue.emplace(reached, other);
        }
      }
    }
    if (found < 0)
    {
      return false;
    }
    HandleLoop loop = loopOf(this->Space, this->SidesTo, found);
    const bool isShorter = loop.Length < best.Length;
    if (isShorter)
    {
      best = std::move(loop);
    }
    return isShorter;
  }

private:
  struct Visit
  {
    // Number of the search that reached the vertex; plus 1 if the distance is final.
    int Number = -1;
    double Distance = 0.0;
    LoopClass Class; // class of the path to the vertex
  };

  void visit(int vertex, double distance, int side, const LoopClass& ofPath)
  {
    this->SidesTo[vertex] = side;
    this->Visits[vertex] = { this->Number, distance, ofPath };
  }

  const LoopSpace& Space;
  std::vector<int> SidesTo;
  std::vector<Visit> Visits;
  int Number = 0;
};

// Select vertices along a loop at a given spacing.
std::vector<int> placesAlong(const LoopSpace& space, const HandleLoop& loop, double spacing)
{
  std::vector<int> places;
  double since = spacing;
  for (const int side : loop.Sides)
  {
    if (since >= spacing)
    {
      places.push_back(space.Surface.from(side));
      since = 0.0;
    }
    since += space.Lengths[side];
  }
  return places;
}

// Find the shortest loop near the loop of a remaining edge. Every shorter loop of the same handle
// crosses this loop, so the searches start at its vertices. The best loop then slides along the
// handle to where it is shortest.
HandleLoop shortestAlong(
  const LoopSpace& space, const PathTree& paths, int edge, LoopSearch& search)
{
  constexpr double firstSpacing = 0.25, slidingSpacing = 0.125; // in lengths of the loop so far
  constexpr int maximumSlides = 16;
  const HandleLoop own = loopOf(space, paths.SidesTo, edge);
  HandleLoop best = own;
  // The edge is far from the root, where handles are narrow.
  search.shorten(space.Surface.from(edge), best);
  for (const int place : placesAlong(space, own, firstSpacing * best.Length))
  {
    search.shorten(place, best);
  }
  bool slides = true;
  for (int i = 0; i < maximumSlides && slides; ++i)
  {
    slides = false;
    for (const int place : placesAlong(space, best, slidingSpacing * best.Length))
    {
      slides = search.shorten(place, best) || slides;
    }
  }
  return best;
}

// Let a loop begin at its vertex of lowest id and run toward the neighbor of lower id. The loop
// thus does not depend on the start of the search.
void order(const GluedSurface& surface, HandleLoop& loop)
{
  const auto bySmallest = [&]()
  {
    std::rotate(loop.Sides.begin(),
      std::min_element(loop.Sides.begin(), loop.Sides.end(),
        [&](int a, int b) { return surface.from(a) < surface.from(b); }),
      loop.Sides.end());
  };
  bySmallest();
  if (surface.from(loop.Sides.back()) < surface.to(loop.Sides.front()))
  {
    std::reverse(loop.Sides.begin(), loop.Sides.end());
    for (int& side : loop.Sides)
    {
      side = surface.Across[side];
    }
    bySmallest();
  }
}

// Linear span of the classes added.
class ClassBasis
{
public:
  /// Return false if the class is already in the span.
  bool add(LoopClass value)
  {
    for (const auto& [pivot, row] : this->Rows)
    {
      if (value[pivot])
      {
        value ^= row;
      }
    }
    for (std::size_t bit = 0; bit < value.size(); ++bit)
    {
      if (value[bit])
      {
        this->Rows.emplace_back(bit, value);
        return true;
      }
    }
    return false;
  }

private:
  std::vector<std::pair<std::size_t, LoopClass>> Rows;
};
}

//------------------------------------------------------------------------------
Index numberOfHandles(const GluedSurface& surface)
{
  // A triangle has three sides, an edge two.
  const Index euler = surface.numberOfVertices() - surface.numberOfTriangles() / 2;
  return (2 - euler) / 2;
}

//------------------------------------------------------------------------------
std::vector<HandleLoop> findHandleLoops(
  const GluedSurface& surface, const std::vector<double>& lengths, const Run& run)
{
  if (numberOfHandles(surface) == 0)
  {
    return {};
  }
  Steps steps(run, { 0.2, 0.3, 0.4, 0.1 }); // paths, classes, loops, selection
  steps.next();
  LoopSpace space(surface, lengths);
  const PathTree paths = shortestPaths(space, 0);
  steps.next();
  std::vector<char> isCrossed(surface.numberOfSides(), 0);
  const std::vector<int> loose = looseEdges(space, paths, isCrossed);
  setClasses(space, loose, isCrossed);

  std::vector<HandleLoop> loops(loose.size());
  const Index blockSize = 8;
  forBlocksReporting(steps.next(), static_cast<Index>(loose.size()), blockSize,
    [&](Index begin, Index end)
    {
      LoopSearch search(space);
      for (Index i = begin; i < end; ++i)
      {
        loops[i] = shortestAlong(space, paths, loose[i], search);
      }
    });
  std::stable_sort(loops.begin(), loops.end(),
    [](const HandleLoop& a, const HandleLoop& b) { return a.Length < b.Length; });

  const Run ofSelection = steps.next();
  std::size_t visited = 0;
  std::vector<HandleLoop> taken;
  std::vector<char> isUsed(surface.numberOfVertices(), 0);
  ClassBasis basis;
  for (const HandleLoop& loop : loops)
  {
    ofSelection.report(static_cast<double>(visited++) / static_cast<double>(loops.size()));
    LoopClass sum;
    bool isFree = true;
    for (const int side : loop.Sides)
    {
      sum ^= space.classOf(side);
      isFree = isFree && !isUsed[surface.from(side)];
    }
    if (isFree && basis.add(sum))
    {
      for (const int side : loop.Sides)
      {
        isUsed[surface.from(side)] = 1;
      }
      taken.push_back(loop);
      order(surface, taken.back());
    }
  }
  return taken;
}
}
