#include "Learn/Fit/Slivers.h"

#include "Mesh/VertexRings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace conformal
{
namespace
{
constexpr double SliverQuality = 0.1;
constexpr double MinimumCosine = 0.9; // minimum cosine of the rotation of other triangles
// Factor by which a change must increase the minimum quality of the changed triangles
constexpr double Gain = 1.05;
constexpr int MinimumNeighbors = 4; // of the vertices that lose one
// Largest part that is cut off, as a fraction of the vertices. Larger parts belong to the object.
constexpr double LargestCutPart = 0.005;
// Largest length of a part that is cut off, in edges of its loop. The tails and ears of objects
// are longer.
constexpr double LargestCutLength = 1.5;

using Corners = std::array<int, 3>;

Index countSlivers(const Mesh& mesh)
{
  Index count = 0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const auto ids = mesh.Triangles.row(r);
    count += triangleQuality(mesh.Positions.row(ids[0]), mesh.Positions.row(ids[1]),
               mesh.Positions.row(ids[2])) < SliverQuality;
  }
  return count;
}

/// Edge, the longest first.
struct Long
{
  double Square;
  int A, B;
  bool operator<(const Long& other) const
  {
    return this->Square != other.Square ? this->Square < other.Square
      : this->A != other.A              ? this->A > other.A
                                        : this->B > other.B;
  }
};

/// Sliver with its quality, the worst first.
struct Sliver
{
  double Quality;
  Corners Ids; // the smallest first
  bool operator<(const Sliver& other) const
  {
    return this->Quality != other.Quality ? this->Quality > other.Quality : this->Ids > other.Ids;
  }
};

class Remover
{
public:
  Remover(Mesh& mesh, SliverRemoval& removal)
    : Surface(mesh)
    , Removal(removal)
    , Rings(mesh.Triangles, mesh.Positions.rows())
    , CutLength(mesh.Positions.rows(), 0.0)
  {
    removal.Sources.resize(mesh.Positions.rows());
    for (int v = 0; v < static_cast<int>(removal.Sources.size()); ++v)
    {
      removal.Sources[v] = { v, v };
    }
  }

  /// Cut off small parts of the surface that are joined to the rest by three edges.
  void cutPinches()
  {
    for (int a = 0; a < this->Rings.size(); ++a)
    {
      while (this->cutPinchAt(a))
      {
      }
    }
  }

  bool hasChanged() const { return this->Changed; }

  void removeAll()
  {
    for (int v = 0; v < this->Rings.size(); ++v)
    {
      this->enqueueAround(v);
    }
    while (!this->Queue.empty())
    {
      const Sliver sliver = this->Queue.top();
      this->Queue.pop();
      if (this->exists(sliver.Ids) && !this->flipLongest(sliver))
      {
        this->collapseOne(sliver);
      }
    }
  }

  /// Split the longest edges until each removed vertex is in use again.
  void refill()
  {
    std::priority_queue<Long> edges;
    const auto add = [&](int a, int b) {
      edges.push({ (this->place(a) - this->place(b)).squaredNorm(), a, b });
    };
    for (int a = 0; !this->Free.empty() && a < this->Rings.size(); ++a)
    {
      for (const int b : this->Rings[a])
      {
        if (a < b)
        {
          add(a, b);
        }
      }
    }
    for (const int m : this->Free)
    {
      const Long edge = edges.top();
      edges.pop();
      const auto [left, right] = this->Rings.across(edge.A, edge.B);
      this->Rings.splitEdge(edge.A, edge.B, m);
      this->Surface.Positions.row(m) = 0.5 * (this->place(edge.A) + this->place(edge.B));
      this->Removal.Sources[m] = { this->Removal.Sources[edge.A][0],
        this->Removal.Sources[edge.B][0] };
      for (const int v : { edge.A, edge.B, left, right })
      {
        add(std::min(v, m), std::max(v, m));
      }
    }
  }

  Triangles triangles() const { return this->Rings.triangles(); }

private:
  Vector3 place(int v) const { return this->Surface.Positions.row(v); }

  double qualityOf(int a, int b, int c) const
  {
    return triangleQuality(this->place(a), this->place(b), this->place(c));
  }

  void enqueueAround(int v)
  {
    const Ring& ring = this->Rings[v];
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      Corners ids = { v, ring[i], ring[(i + 1) % ring.size()] };
      std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
      const double value = this->qualityOf(ids[0], ids[1], ids[2]);
      if (value < SliverQuality)
      {
        this->Queue.push({ value, ids });
      }
    }
  }

  bool exists(const Corners& ids) const
  {
    const Ring& ring = this->Rings[ids[0]];
    const auto at = std::find(ring.begin(), ring.end(), ids[1]);
    return at != ring.end() && (at + 1 == ring.end() ? ring.front() : *(at + 1)) == ids[2];
  }

  /// Cut one part off at three edges with a as smallest vertex. Return false if there is none.
  bool cutPinchAt(int a)
  {
    const Ring ring = this->Rings[a];
    const std::size_t size = ring.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      for (std::size_t j = i + 2; j < size; ++j)
      {
        const int b = ring[i], c = ring[j];
        const Ring& ofB = this->Rings[b];
        const bool isTriangle = i == 0 && j + 1 == size;
        if (b < a || c < a || isTriangle || std::find(ofB.begin(), ofB.end(), c) == ofB.end())
        {
          continue;
        }
        const Corners loop = { a, b, c };
        if (this->cutOff(loop, ring[i + 1]) || this->cutOff(loop, ring[(j + 1) % size]))
        {
          return true;
        }
      }
    }
    return false;
  }

  double longestEdge(const Corners& loop) const
  {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest, (this->place(loop[k]) - this->place(loop[next(k)])).norm());
    }
    return longest;
  }

  /// Return how far a part reaches beyond its loop, with what was cut off from it before.
  /// Otherwise, repeated cuts would shorten a tail.
  double lengthBeyond(const Corners& loop, const std::vector<int>& part) const
  {
    double length = 0.0;
    for (const int v : part)
    {
      double nearest = std::numeric_limits<double>::max();
      for (const int corner : loop)
      {
        nearest = std::min(nearest, (this->place(v) - this->place(corner)).norm());
      }
      length = std::max(length, nearest + this->CutLength[v]);
    }
    return length;
  }

  /// Collapse the part of the surface that contains a vertex and ends at a loop. Return false if
  /// the part is not small.
  bool cutOff(const Corners& loop, int start)
  {
    const auto maximum =
      static_cast<std::size_t>(LargestCutPart * static_cast<double>(this->Rings.size()));
    std::vector<int> part = { start };
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      if (part.size() > maximum)
      {
        return false;
      }
      for (const int v : this->Rings[part[i]])
      {
        if (std::find(loop.begin(), loop.end(), v) == loop.end() &&
          std::find(part.begin(), part.end(), v) == part.end())
        {
          part.push_back(v);
        }
      }
    }
    const double length = this->lengthBeyond(loop, part);
    if (length > LargestCutLength * this->longestEdge(loop))
    {
      return false;
    }
    for (const int v : loop)
    {
      this->CutLength[v] = std::max(this->CutLength[v], length);
    }
    bool any = false;
    for (std::size_t before = part.size() + 1; part.size() < before;)
    {
      before = part.size();
      part.erase(std::remove_if(part.begin(), part.end(),
                   [&](int v)
                   {
                     const Ring& ring = this->Rings[v];
                     const auto target = std::find_if(ring.begin(), ring.end(),
                       [&](int u) { return this->Rings.canCollapse(v, u); });
                     if (target == ring.end())
                     {
                       return false;
                     }
                     this->Rings.collapse(v, *target);
                     this->Free.push_back(v);
                     return true;
                   }),
        part.end());
      any = any || part.size() < before;
    }
    this->Changed = this->Changed || any;
    return any && part.empty();
  }

  bool flipLongest(const Sliver& sliver)
  {
    int k = 0;
    double longest = -1.0;
    for (int i = 0; i < 3; ++i)
    {
      const double square =
        (this->place(sliver.Ids[i]) - this->place(sliver.Ids[next(i)])).squaredNorm();
      k = square > longest ? i : k;
      longest = std::max(longest, square);
    }
    const int a = sliver.Ids[k], b = sliver.Ids[next(k)], left = sliver.Ids[previous(k)],
              right = this->Rings.across(a, b).Right;
    if (!this->Rings.canFlip(a, b))
    {
      return false;
    }
    const double before = std::min(sliver.Quality, this->qualityOf(b, a, right));
    const double after = std::min(this->qualityOf(a, right, left), this->qualityOf(b, left, right));
    const Vector3 pa = this->place(a), pb = this->place(b), pl = this->place(left),
                  pr = this->place(right);
    const Vector3 mean = twiceAreaVector(pa, pb, pl) + twiceAreaVector(pb, pa, pr);
    if (after <= Gain * before ||
      cosineBetween(twiceAreaVector(pa, pr, pl), mean) < MinimumCosine ||
      cosineBetween(twiceAreaVector(pb, pl, pr), mean) < MinimumCosine)
    {
      return false;
    }
    this->Rings.flip(a, b);
    this->Changed = true;
    for (const int v : { a, b })
    {
      this->enqueueAround(v);
    }
    return true;
  }

  /// Collapse the shortest edge that can collapse, into an end or the middle.
  void collapseOne(const Sliver& sliver)
  {
    std::array<Long, 3> edges;
    for (int i = 0; i < 3; ++i)
    {
      const int a = std::min(sliver.Ids[i], sliver.Ids[next(i)]),
                b = std::max(sliver.Ids[i], sliver.Ids[next(i)]);
      edges[i] = { (this->place(a) - this->place(b)).squaredNorm(), a, b };
    }
    std::sort(edges.begin(), edges.end());
    for (const Long& edge : edges)
    {
      if (this->collapse(edge.A, edge.B))
      {
        return;
      }
    }
  }

  bool collapse(int a, int b)
  {
    const auto [left, right] = this->Rings.across(a, b);
    if (this->Rings[left].size() < MinimumNeighbors ||
      this->Rings[right].size() < MinimumNeighbors || !this->Rings.canCollapse(b, a))
    {
      return false;
    }
    const double before = std::min(this->worstAround(a), this->worstAround(b));
    double best = Gain * before;
    Vector3 chosen = this->place(a);
    for (const Vector3& to :
      { Vector3(0.5 * (this->place(a) + this->place(b))), this->place(a), this->place(b) })
    {
      const double after = std::min(this->worstAfter(a, b, to), this->worstAfter(b, a, to));
      if (after > best)
      {
        best = after;
        chosen = to;
      }
    }
    if (!(best > Gain * before))
    {
      return false;
    }
    this->Removal.Sources[a] = { a, b };
    this->Rings.collapse(b, a);
    this->Changed = true;
    this->Surface.Positions.row(a) = chosen;
    this->Free.push_back(b);
    this->enqueueAround(a);
    return true;
  }

  double worstAround(int v) const
  {
    const Ring& ring = this->Rings[v];
    double worst = 1.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      worst = std::min(worst, this->qualityOf(v, ring[i], ring[(i + 1) % ring.size()]));
    }
    return worst;
  }

  /// Return the minimum quality of the triangles of v without u after v moved, or 0 if a triangle
  /// that is no sliver turns too far.
  double worstAfter(int v, int u, const Vector3& to) const
  {
    const Ring& ring = this->Rings[v];
    double worst = 1.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const int p = ring[i], q = ring[(i + 1) % ring.size()];
      if (p == u || q == u)
      {
        continue;
      }
      const Vector3 old = twiceAreaVector(this->place(v), this->place(p), this->place(q)),
                    moved = twiceAreaVector(to, this->place(p), this->place(q));
      if (this->qualityOf(v, p, q) >= SliverQuality && cosineBetween(old, moved) < MinimumCosine)
      {
        return 0.0;
      }
      worst = std::min(worst, triangleQuality(to, this->place(p), this->place(q)));
    }
    return worst;
  }

  Mesh& Surface;
  SliverRemoval& Removal;
  VertexRings Rings;
  std::vector<double> CutLength; ///< of what was cut off at each vertex
  std::priority_queue<Sliver> Queue;
  bool Changed = false;
  std::vector<int> Free; ///< vertices not in use, in the sequence of their removal
};
}

//------------------------------------------------------------------------------
SliverRemoval removeSlivers(Mesh& mesh, const Run& run)
{
  SliverRemoval removal;
  removal.Before = removal.After = countSlivers(mesh);
  Remover remover(mesh, removal);
  remover.cutPinches();
  run.report(0.3);
  if (removal.Before > 0 || remover.hasChanged())
  {
    remover.removeAll();
    remover.cutPinches(); // what could not collapse
    remover.removeAll();
  }
  run.report(0.6);
  if (remover.hasChanged())
  {
    remover.refill();
    mesh.Triangles = remover.triangles();
    removal.After = countSlivers(mesh);
  }
  else
  {
    removal.Sources.clear();
  }
  run.report(1.0);
  return removal;
}
}
