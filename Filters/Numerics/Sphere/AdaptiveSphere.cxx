#include "Sphere/AdaptiveSphere.h"

#include "Base/Random.h"
#include "Base/Steps.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <stdexcept>
#include <string>
#include <utility>

namespace conformal
{
namespace
{
constexpr double MinimumRadius = 1e-7; // minimum circumradius of a triangle to divide
// Minimum density, divided by the mean density, so that target sizes are finite
constexpr double MinimumDensity = 1e-9;
constexpr double SizeSpread = 3.0;    // maximum random factor of areas
constexpr double GoodAngle = 35.0;    // smoothing makes no angle smaller than this [degrees]
constexpr double SmoothingStep = 0.7; // length of a move, divided by the distance to the centroid
constexpr int SmoothingTries = 3;     // number of tries, each with half the step of the one before
// Maximum edge length for which a triangle and its neighbors are regarded as flat
constexpr double LargeEdge = 0.01;
// Squared sine of the minimum angle below which a triangle has no plane
constexpr double FlatSquaredSine = 1e-6;
constexpr double LeastGain = 1e-9;
constexpr int ReportEvery = 1024; // points

double squaredSine(double degrees)
{
  const double sine = std::sin(degrees * Pi / 180.0);
  return sine * sine;
}

/// Compute twice the area of a triangle, negative if clockwise seen from outside. Differences
/// preserve the digits of small triangles.
double side(const Vector3& a, const Vector3& b, const Vector3& p)
{
  return (a - p).cross(b - p).dot(p);
}

/// Shape of a triangle.
struct Shape
{
  /// Squared sine of the minimum angle; 0 for a triangle without area and for a flipped triangle
  double SquaredSine = 0.0;
  double SquaredRadius = 0.0;
  double Area = 0.0;

  Shape(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    std::array<double, 3> squares = { (b - a).squaredNorm(), (c - b).squaredNorm(),
      (a - c).squaredNorm() };
    std::sort(squares.begin(), squares.end());
    const Vector3 area = (b - a).cross(c - a);
    const double square = area.squaredNorm(), longer = squares[1] * squares[2];
    if (square > 0.0 && longer > 0.0 && area.dot(a + b + c) > 0.0)
    {
      this->SquaredSine = square / longer;
      this->SquaredRadius = squares[0] / (4.0 * this->SquaredSine);
      this->Area = 0.5 * std::sqrt(square);
    }
  }
};

class Refinement
{
public:
  Refinement(const SphereDensity& density, Index numberOfPoints, const Run& run)
    : Density(density)
    , ProbeDensities(densitiesOf(density, run))
    , NextProbe(density.Areas.size(), -1)
  {
    const Mesh start = makeGeodesicSphere(1);
    const double all = integralOf(density, this->ProbeDensities);
    const double area = std::accumulate(density.Areas.begin(), density.Areas.end(), 0.0);
    this->Floor = MinimumDensity * all / area;
    this->AreaUnit = 4.0 * Pi / area;
    // Sizes up to 2 % above the target are accepted
    const Index maximum = numberOfPoints + numberOfPoints / 50;
    this->Positions.reserve(maximum);
    this->Sizes.reserve(maximum);
    this->Items.reserve(2 * maximum);
    for (Index i = 0; i < start.Positions.rows(); ++i)
    {
      this->addPoint(start.Positions.row(i));
    }
    const Triangles neighbors = triangleNeighbors(start.Triangles, start.Positions.rows());
    for (Index r = 0; r < start.Triangles.rows(); ++r)
    {
      Item item;
      for (int k = 0; k < 3; ++k)
      {
        item.Ids[k] = start.Triangles(r, k);
        item.Across[k] = neighbors(r, k);
      }
      this->Items.push_back(item);
    }
    for (Index i = 0; i < density.Directions.rows(); ++i)
    {
      this->give(this->find(density.Directions.row(i), 0), static_cast<int>(i));
    }
    for (int t = 0; t < static_cast<int>(this->Items.size()); ++t)
    {
      this->changed(t);
    }
  }

  /// Add points up to the given number. Then add points until no angle is below the bound.
  void refine(Index numberOfPoints, const Run& run)
  {
    const auto first = static_cast<double>(this->Positions.size());
    const double all = std::max(1.0, static_cast<double>(numberOfPoints) - first);
    std::size_t next = this->Positions.size();
    while (true)
    {
      const Index size = this->size();
      if (size < numberOfPoints && !this->hasBadAngles())
      {
        this->Before = size;
      }
      const int t = this->worst(size < numberOfPoints);
      if (t < 0 || size > 2 * numberOfPoints) // far too many points, none of which is kept
      {
        return;
      }
      this->divide(t);
      if (this->Positions.size() >= next)
      {
        next = this->Positions.size() + ReportEvery;
        run.report(std::min(1.0, (static_cast<double>(this->Positions.size()) - first) / all));
      }
    }
  }

  Index size() const { return static_cast<Index>(this->Positions.size()); }

  /// Return the last number of points, below the target number, at which no angle was below the
  /// bound.
  Index sizeBefore() const { return this->Before; }

  /// Move points towards the centroid of their triangles, then flip edges.
  void smooth(const Run& run)
  {
    for (const std::vector<int>& color : this->colors())
    {
      forBlocks(run, static_cast<Index>(color.size()), HeavyBlock,
        [&](Index begin, Index end)
        {
          for (Index i = begin; i < end; ++i)
          {
            this->smooth(color[i]);
          }
        });
    }
    forBlocksReporting(run, static_cast<Index>(this->Positions.size()), HeavyBlock,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          this->Sizes[i] = this->sizeAt(this->Positions[i]);
        }
      });
    std::vector<int> all(this->Items.size());
    std::iota(all.begin(), all.end(), 0);
    this->flipAround(all);
  }

  Mesh mesh() const
  {
    Mesh mesh;
    mesh.Positions.resize(static_cast<Index>(this->Positions.size()), 3);
    for (std::size_t i = 0; i < this->Positions.size(); ++i)
    {
      mesh.Positions.row(static_cast<Index>(i)) = this->Positions[i];
    }
    mesh.Triangles.resize(static_cast<Index>(this->Items.size()), 3);
    for (std::size_t t = 0; t < this->Items.size(); ++t)
    {
      mesh.Triangles.row(static_cast<Index>(t)) << this->Items[t].Ids[0], this->Items[t].Ids[1],
        this->Items[t].Ids[2];
    }
    return mesh;
  }

  /// Stop the division of triangles.
  void dropQueues()
  {
    this->IsRefining = false;
    this->BySize = {};
    this->ByAngle = {};
  }

private:
  struct Item
  {
    std::array<int, 3> Ids{};
    std::array<int, 3> Across{}; // triangle across each edge (k, k + 1 mod 3)
    int FirstProbe = -1; // first id in the list of sampled directions in this triangle, or -1
    int Version = 0;     // number of changes of the triangle
  };

  /// Entry of the queue: triangle to divide, with its state when queued.
  struct Entry
  {
    double Priority;
    int Triangle, Version;

    bool operator<(const Entry& other) const
    {
      return this->Priority != other.Priority ? this->Priority < other.Priority
                                              : this->Triangle < other.Triangle;
    }
  };

  const Vector3& corner(int t, int k) const { return this->Positions[this->Items[t].Ids[k % 3]]; }

  Shape shapeOf(int t) const
  {
    return { this->corner(t, 0), this->corner(t, 1), this->corner(t, 2) };
  }

  /// Return the target edge length at a direction, up to a constant factor.
  double sizeAt(const Vector3& direction) const
  {
    return 1.0 / std::sqrt(std::max(this->Density.At(direction), this->Floor));
  }

  int addPoint(const Vector3& position)
  {
    this->Positions.push_back(position);
    this->Sizes.push_back(this->sizeAt(position));
    return static_cast<int>(this->Positions.size()) - 1;
  }

  void give(int t, int probe)
  {
    this->NextProbe[probe] = this->Items[t].FirstProbe;
    this->Items[t].FirstProbe = probe;
  }

  /// Find the triangle that contains a direction by a walk from another triangle. If rounding leads
  /// in a circle, a nearby triangle is returned.
  int find(const Vector3& direction, int from) const
  {
    int t = from;
    const int farthest =
      3 * static_cast<int>(std::sqrt(static_cast<double>(this->Items.size()))) + 100;
    for (int step = 0; step < farthest; ++step)
    {
      int next = -1;
      double minimum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double itsSide = side(this->corner(t, k), this->corner(t, k + 1), direction);
        if (itsSide < minimum)
        {
          minimum = itsSide;
          next = this->Items[t].Across[k];
        }
      }
      if (next < 0)
      {
        return t;
      }
      t = next;
    }
    return t;
  }

  /// Queue a triangle that is to be divided.
  void changed(int t)
  {
    Item& item = this->Items[t];
    ++item.Version;
    if (!this->IsRefining)
    {
      return;
    }
    const Shape shape = this->shapeOf(t);
    if (shape.SquaredRadius < MinimumRadius * MinimumRadius)
    {
      return;
    }
    if (shape.SquaredSine < this->MinimumSquaredSine)
    {
      this->ByAngle.push({ -shape.SquaredRadius, t, item.Version });
      return;
    }
    const double size =
      (this->Sizes[item.Ids[0]] + this->Sizes[item.Ids[1]] + this->Sizes[item.Ids[2]]) / 3.0;
    double mass = 0.0;
    for (int probe = item.FirstProbe; probe >= 0; probe = this->NextProbe[probe])
    {
      mass += this->ProbeDensities[probe] *
        std::min(this->AreaUnit * this->Density.Areas[probe], shape.Area);
    }
    const double equilateral = 0.75 * std::sqrt(3.0); // area over the square of the radius
    const double priority = std::max(shape.SquaredRadius / (size * size), mass / equilateral);
    const double factor = std::pow(SizeSpread, this->Dice.uniform());
    this->BySize.push({ priority * factor, t, item.Version });
  }

  bool hasBadAngles()
  {
    while (!this->ByAngle.empty() && this->isOutdated(this->ByAngle.top()))
    {
      this->ByAngle.pop();
    }
    return !this->ByAngle.empty();
  }

  bool isOutdated(const Entry& entry) const
  {
    return entry.Version != this->Items[entry.Triangle].Version;
  }

  /// Find the next triangle to divide. Triangles with an angle below the bound come first, those
  /// with the smallest circumradius before others. If there are none and `wantsPoints` is true,
  /// find the triangle that is largest relative to its target size. If there is none, return -1.
  int worst(bool wantsPoints)
  {
    for (auto* queue : { &this->ByAngle, &this->BySize })
    {
      while (!queue->empty() && (queue == &this->ByAngle || wantsPoints))
      {
        const Entry entry = queue->top();
        queue->pop();
        if (!this->isOutdated(entry))
        {
          return entry.Triangle;
        }
      }
    }
    return -1;
  }

  /// Add a point at the center of the circumcircle of a triangle. The center may be in another
  /// triangle.
  void divide(int t)
  {
    const Vector3 a = this->corner(t, 0), ab = this->corner(t, 1) - a, ac = this->corner(t, 2) - a;
    const Vector3 normal = ab.cross(ac);
    const Vector3 offset =
      (ac.squaredNorm() * normal.cross(ab) + ab.squaredNorm() * ac.cross(normal)) /
      (2.0 * normal.squaredNorm());
    const Vector3 middle = (a + offset).normalized();
    this->insert(this->find(middle, t), middle);
  }

  /// Divide a triangle into three at an interior point, then flip edges until the mesh is Delaunay
  /// again.
  void insert(int t, const Vector3& position)
  {
    const int p = this->addPoint(position);
    const Item old = this->Items[t];
    const std::array<int, 3> parts = { t, static_cast<int>(this->Items.size()),
      static_cast<int>(this->Items.size()) + 1 };
    this->Items.resize(this->Items.size() + 2);
    for (int k = 0; k < 3; ++k)
    {
      Item& item = this->Items[parts[k]];
      item.Ids = { old.Ids[k], old.Ids[next(k)], p };
      item.Across = { old.Across[k], parts[next(k)], parts[previous(k)] };
      item.FirstProbe = -1;
      this->replaceNeighbor(old.Across[k], t, parts[k]);
    }
    for (int probe = old.FirstProbe; probe >= 0;)
    {
      const int next = this->NextProbe[probe];
      const Vector3 x = this->Density.Directions.row(probe);
      const auto leftOf = [&](int k)
      { return side(position, this->Positions[old.Ids[k]], x) >= 0.0; };
      const std::array<bool, 3> left = { leftOf(0), leftOf(1), leftOf(2) };
      const int part = left[0] && !left[1] ? 0 : left[1] && !left[2] ? 1 : 2;
      this->give(parts[part], probe);
      probe = next;
    }
    std::vector<int> touched(parts.begin(), parts.end());
    this->flipAround(touched);
    for (const int part : touched)
    {
      this->changed(part);
    }
  }

  void replaceNeighbor(int t, int from, int to)
  {
    for (int& across : this->Items[t].Across)
    {
      if (across == from)
      {
        across = to;
        return;
      }
    }
  }

  /// Flip edges of triangles, and of triangles changed by flips, while the minimum angle of both
  /// triangles of an edge increases.
  /// @param[in,out] triangles  triangles, each once. Changed triangles are appended.
  void flipAround(std::vector<int>& triangles)
  {
    this->Seen.resize(this->Items.size(), 0);
    std::vector<int> pending = triangles;
    for (const int t : triangles)
    {
      this->Seen[t] = 1;
    }
    while (!pending.empty())
    {
      const int t = pending.back();
      pending.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const int other = this->Items[t].Across[k];
        if (!this->flip(t, k))
        {
          continue;
        }
        for (const int both : { t, other })
        {
          pending.push_back(both);
          if (!this->Seen[both])
          {
            this->Seen[both] = 1;
            triangles.push_back(both);
          }
        }
        break;
      }
    }
    for (const int t : triangles)
    {
      this->Seen[t] = 0;
    }
  }

  /// Flip the edge (k, k + 1) of a triangle if that increases the minimum angle of both triangles.
  /// For large triangles, the criterion is that the opposite point is in the circumcircle.
  bool flip(int t, int k)
  {
    const int other = this->Items[t].Across[k];
    const int m = this->placeOf(other, t); // edge (m, m + 1) of the other triangle
    const Item first = this->Items[t], second = this->Items[other];
    const int a = first.Ids[k], b = first.Ids[next(k)], c = first.Ids[previous(k)],
              d = second.Ids[previous(m)];
    const Vector3 &pa = this->Positions[a], &pb = this->Positions[b], &pc = this->Positions[c],
                  &pd = this->Positions[d];
    const double before = std::min(Shape(pa, pb, pc).SquaredSine, Shape(pb, pa, pd).SquaredSine);
    const double after = std::min(Shape(pa, pd, pc).SquaredSine, Shape(pd, pb, pc).SquaredSine);
    const bool isLarge = (pa - pb).squaredNorm() > LargeEdge * LargeEdge;
    if (this->IsRefining && isLarge && before > FlatSquaredSine)
    {
      const Vector3 normal = (pb - pa).cross(pc - pa);
      if (!(after > 0.0) || normal.dot(pd - pa) <= LeastGain * normal.norm())
      {
        return false;
      }
    }
    else if (after <= before * (1.0 + LeastGain))
    {
      return false;
    }
    Item &left = this->Items[t], &right = this->Items[other];
    left.Ids = { a, d, c };
    left.Across = { second.Across[next(m)], other, first.Across[previous(k)] };
    right.Ids = { d, b, c };
    right.Across = { second.Across[previous(m)], first.Across[next(k)], t };
    this->replaceNeighbor(left.Across[0], other, t);
    this->replaceNeighbor(right.Across[1], t, other);
    left.FirstProbe = right.FirstProbe = -1;
    for (int probe : { first.FirstProbe, second.FirstProbe })
    {
      while (probe >= 0)
      {
        const int next = this->NextProbe[probe];
        this->give(side(pd, pc, this->Density.Directions.row(probe)) >= 0.0 ? t : other, probe);
        probe = next;
      }
    }
    return true;
  }

  int placeOf(int t, int neighbor) const
  {
    const auto& across = this->Items[t].Across;
    return across[0] == neighbor ? 0 : across[1] == neighbor ? 1 : 2;
  }

  /// Partition points into sets of which no two members are neighbors, and find a triangle of each
  /// point.
  std::vector<std::vector<int>> colors()
  {
    this->TriangleOf.resize(this->Positions.size());
    for (int t = 0; t < static_cast<int>(this->Items.size()); ++t)
    {
      for (const int v : this->Items[t].Ids)
      {
        this->TriangleOf[v] = t;
      }
    }
    std::vector<int> all(this->Positions.size());
    std::iota(all.begin(), all.end(), 0);
    return independentSets(all, static_cast<int>(all.size()),
      [&](int v, const std::function<void(int)>& visit)
      { this->forEachTriangle(v, [&](int t, int k) { visit(this->Items[t].Ids[next(k)]); }); });
  }

  /// Call visit(t, k) for each triangle t around a point, its corner k.
  template <typename Visit>
  void forEachTriangle(int v, Visit visit) const
  {
    const int first = this->TriangleOf[v];
    int t = first;
    do
    {
      const auto& ids = this->Items[t].Ids;
      const int k = ids[0] == v ? 0 : ids[1] == v ? 1 : 2;
      visit(t, k);
      t = this->Items[t].Across[k];
    } while (t != first);
  }

  /// Compute the minimum angle around a point for another position of the point.
  double squaredSineAround(int v, const Vector3& position) const
  {
    double minimum = 1.0;
    this->forEachTriangle(v,
      [&](int t, int k)
      {
        const Shape shape(position, this->corner(t, k + 1), this->corner(t, k + 2));
        minimum = std::min(minimum, shape.SquaredSine);
      });
    return minimum;
  }

  void smooth(int v)
  {
    const Vector3 from = this->Positions[v];
    Vector3 sum = Vector3::Zero();
    double weights = 0.0;
    this->forEachTriangle(v,
      [&](int t, int k)
      {
        const Vector3 p = this->corner(t, k + 1) - from, q = this->corner(t, k + 2) - from;
        const auto& ids = this->Items[t].Ids;
        const double size = this->Sizes[ids[0]] + this->Sizes[ids[1]] + this->Sizes[ids[2]];
        const double weight = p.cross(q).norm() / (size * size * size * size);
        sum += weight / 3.0 * (p + q);
        weights += weight;
      });
    Vector3 step = SmoothingStep / weights * sum;
    const double needed = std::min(this->squaredSineAround(v, from), this->GoodSquaredSine);
    for (int attempt = 0; attempt < SmoothingTries; ++attempt, step *= 0.5)
    {
      const Vector3 to = (from + step).normalized();
      if (this->squaredSineAround(v, to) >= needed)
      {
        this->Positions[v] = to;
        return;
      }
    }
  }

  const SphereDensity& Density;
  double Floor = 0.0;    // lower bound of the density
  double AreaUnit = 1.0; // scales areas to the total of the sphere
  const double MinimumSquaredSine = squaredSine(AdaptiveSphereLimits::MinimumAngle);
  const double GoodSquaredSine = squaredSine(GoodAngle);
  bool IsRefining = true;
  Index Before = 0;
  std::vector<Vector3> Positions;
  std::vector<double> Sizes; // target edge lengths at the points, up to a constant factor
  std::vector<Item> Items;
  std::vector<double> ProbeDensities;
  std::vector<int> NextProbe; // next id in the list of a triangle
  std::vector<char> Seen;     // visited triangles, while flipping
  std::vector<int> TriangleOf;
  std::priority_queue<Entry> BySize, ByAngle;
  Random Dice{ 1 };
};
}

//------------------------------------------------------------------------------
Mesh makeAdaptiveSphere(
  const SphereDensity& density, const AdaptiveSphereOptions& options, const Run& run)
{
  using Limits = AdaptiveSphereLimits;
  if (options.NumberOfPoints < Limits::MinimumPoints ||
    options.NumberOfPoints > Limits::MaximumPoints || options.SmoothingRounds < 0)
  {
    throw std::invalid_argument("NumberOfPoints must lie between " +
      std::to_string(Limits::MinimumPoints) + " and " + std::to_string(Limits::MaximumPoints) +
      ", and SmoothingRounds must not be negative");
  }
  const auto size = static_cast<double>(options.NumberOfPoints);
  std::vector<double> shares = { 0.02, 0.33 }; // density, refinement, each round
  shares.insert(shares.end(), options.SmoothingRounds, 0.13);
  Steps steps(run, shares);
  std::optional<Refinement> refinement(
    std::in_place, density, options.NumberOfPoints, steps.next());
  refinement->refine(options.NumberOfPoints, steps.next());
  if (static_cast<double>(refinement->size()) > (1.0 + Limits::Tolerance) * size)
  {
    // Many points were added after the last one to enlarge angles. Build the mesh without the last
    // point and these points.
    const Index fewer = refinement->sizeBefore();
    refinement.emplace(density, options.NumberOfPoints, run.unwatched());
    refinement->refine(fewer, {});
  }
  refinement->dropQueues();
  for (int round = 0; round < options.SmoothingRounds; ++round)
  {
    refinement->smooth(steps.next());
  }
  run.report(1.0);
  return refinement->mesh();
}
}
