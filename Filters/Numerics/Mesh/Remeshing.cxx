#include "Mesh/Remeshing.h"

#include "Base/MortonOrder.h"
#include "Base/Steps.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/VertexRings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Limits of edge lengths, divided by the target length. Their ratio is large enough that no edge is
// split and collapsed again and again.
constexpr double LongestEdge = 4.0 / 3.0, ShortestEdge = 4.0 / 5.0;
constexpr double CoarseEdge = 8.0;    // longest edge of a coarse mesh, divided by the target length
constexpr double MinimumCosine = 0.5; // minimum cosine of the rotation of a triangle's normal
// Minimum quality of a triangle after a collapse; 1 if equilateral
constexpr double MinimumQuality = 0.05;
constexpr double SmoothingStep = 0.7; // length of a move, divided by the distance to the centroid
constexpr int SmoothingTries = 3;     // number of tries, each with half the step of the one before
constexpr int MaximumRounds = 100;    // maximum number of rounds of one kind of operation
constexpr int FinalSmoothings = 3;
constexpr Index ManyVertices = 20000; // number of vertices above which data exceed the cache

/// Maximum number of vertices after splits, divided by the target number. The limit is necessary
/// for surfaces of vanishing area.
constexpr Index MaximumSplit = 4;

// Minimum cosines between the normals of the two triangles of a flipped edge
constexpr double EdgeCosine = 0.7, DelaunayCosine = 0.5;

/// Operation on the edge between A and B. Operations are sorted by descending priority.
struct Operation
{
  int A, B;
  double Priority;

  bool operator<(const Operation& other) const
  {
    return this->Priority != other.Priority ? this->Priority > other.Priority
      : this->A != other.A                  ? this->A < other.A
                                            : this->B < other.B;
  }
};

class Remesher
{
public:
  Remesher(Points& points, Triangles& triangles, const Run& run)
    : Places(points)
    , Triangles(triangles)
    , Threads(run.unwatched())
    , Rings(triangles, points.rows())
    , Count(points.rows())
  {
  }

  Index count() const { return this->Count; }

  /// Set the Run to which operations report progress after each round.
  void reportTo(const Run& run) { this->Step = run; }

  /// Compute the edge length of equilateral triangles that have the area of the surface and the
  /// given number of vertices.
  double lengthFor(Index numberOfVertices) const
  {
    double area = 0.0;
    for (int a = 0; a < this->Rings.size(); ++a)
    {
      const Ring& ring = this->Rings[a];
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        const int b = ring[i], c = ring[(i + 1) % ring.size()];
        area += a < b && a < c
          ? 0.5 * twiceAreaVector(this->place(a), this->place(b), this->place(c)).norm()
          : 0.0;
      }
    }
    return std::sqrt(2.0 * area / (std::sqrt(3.0) * static_cast<double>(numberOfVertices)));
  }

  /// Return the length of the longest edge.
  double longestEdge() const
  {
    double square = 0.0;
    for (int a = 0; a < this->Rings.size(); ++a)
    {
      for (const int b : this->Rings[a])
      {
        square = std::max(square, (this->place(a) - this->place(b)).squaredNorm());
      }
    }
    return std::sqrt(square);
  }

  /// Split edges longer than a limit, the longest first, until the mesh has the given number of
  /// vertices.
  /// @param[in] longestOnly  split only edges that are the longest of both triangles. Edges much
  ///   longer than the limit are divided in many rounds, and others would leave slivers.
  void split(double limit, Index maximum, bool longestOnly)
  {
    const double squareLimit = limit * limit;
    const auto proposed = [&](int a, int b, Operation& operation)
    {
      operation.Priority = (this->place(a) - this->place(b)).squaredNorm();
      return operation.Priority > squareLimit && (!longestOnly || this->isLongest(a, b));
    };
    this->perform(
      proposed,
      [&](const Operation& operation, std::vector<int>& touched)
      {
        const int m = static_cast<int>(this->Rings.size());
        const auto across = this->Rings.across(operation.A, operation.B);
        this->Rings.resize(m + 1);
        this->reserve(m + 1);
        this->Rings.splitEdge(operation.A, operation.B, m);
        this->Places.row(m) = 0.5 * (this->place(operation.A) + this->place(operation.B));
        ++this->Count;
        touched = { operation.A, operation.B, across.Left, across.Right, m };
        return true;
      },
      [&] { return this->Count < maximum; });
  }

  /// Collapse edges shorter than `limit`, until the mesh has the given number of vertices. A
  /// collapse that results in an edge longer than `longest` is skipped.
  /// @param[in] anyway  accept any shape of the triangles that preserves the topology
  void collapse(double limit, double longest, Index minimum = 4, bool anyway = false)
  {
    const double squareLimit = limit * limit;
    const auto proposed = [&](int a, int b, Operation& operation)
    {
      const double square = (this->place(a) - this->place(b)).squaredNorm();
      operation.Priority = -square;
      return square < squareLimit;
    };
    this->perform(
      proposed,
      [&](const Operation& operation, std::vector<int>& touched)
      {
        Vector3 place;
        if (!this->canCollapse(operation.A, operation.B, longest, anyway, place))
        {
          return false;
        }
        const Ring& ring = this->Rings[operation.A];
        touched.assign(ring.begin(), ring.end()); // including B
        touched.push_back(operation.A);
        const Ring lost = this->Rings.collapse(operation.B, operation.A);
        touched.insert(touched.end(), lost.begin(), lost.end());
        this->Places.row(operation.A) = place;
        --this->Count;
        return true;
      },
      [&] { return this->Count > minimum; });
  }

  /// Flip edges as long as flips make the numbers of neighbors of vertices closer to six.
  void flipForValence()
  {
    const auto excess = [&](int v, int change)
    {
      const double difference = static_cast<double>(this->Rings[v].size()) + change - 6.0;
      return difference * difference;
    };
    this->flip(EdgeCosine, 0.5,
      [&](int a, int b, int left, int right)
      {
        return excess(a, 0) + excess(b, 0) + excess(left, 0) + excess(right, 0) - excess(a, -1) -
          excess(b, -1) - excess(left, 1) - excess(right, 1);
      });
  }

  /// Flip edges whose two opposite angles have a sum above pi.
  void flipForAngles()
  {
    this->flip(DelaunayCosine, 0.0,
      [&](int a, int b, int left, int right)
      {
        const auto angle = [&](int corner)
        {
          const Vector3 u = this->place(a) - this->place(corner),
                        v = this->place(b) - this->place(corner);
          return std::atan2(u.cross(v).norm(), u.dot(v));
        };
        constexpr double rounding = 1e-9;
        return angle(left) + angle(right) - Pi - rounding;
      });
  }

  /// Move vertices along the surface towards the centroid of their triangles. Two neighbors never
  /// move at the same time, so that the result does not depend on the number of threads.
  void smooth()
  {
    for (const std::vector<int>& color : this->colors())
    {
      forBlocks(this->Threads, static_cast<Index>(color.size()), HeavyBlock,
        [&](Index begin, Index end)
        {
          for (Index i = begin; i < end; ++i)
          {
            this->smooth(color[i]);
          }
        });
    }
  }

  /// Replace the mesh by the remeshed one, without unused ids. Many vertices are numbered along a
  /// Morton curve, and triangles by their vertices, so that later loops over the mesh read memory
  /// that is in the cache. After splits, neighbors have distant ids.
  void finish()
  {
    std::vector<int> used;
    std::size_t corners = 0;
    for (int v = 0; v < this->Rings.size(); ++v)
    {
      if (!this->Rings[v].empty())
      {
        used.push_back(v);
        corners += this->Rings[v].size();
      }
    }
    const auto count = static_cast<Index>(used.size());
    if (count > ManyVertices)
    {
      used = this->alongCurve(used);
    }
    std::vector<int> ids(this->Rings.size(), -1);
    Points places(count, 3);
    for (int i = 0; i < count; ++i)
    {
      places.row(i) = this->Places.row(used[i]);
      ids[used[i]] = i;
    }
    this->Places = std::move(places);
    this->Triangles.resize(static_cast<Index>(corners / 3), 3);
    Index next = 0;
    for (int a = 0; a < count; ++a)
    {
      const Ring& ring = this->Rings[used[a]];
      for (std::size_t k = 0; k < ring.size(); ++k)
      {
        const int b = ids[ring[k]], c = ids[ring[(k + 1) % ring.size()]];
        if (a < b && a < c)
        {
          this->Triangles.row(next++) << a, b, c;
        }
      }
    }
  }

private:
  /// Return vertices sorted along a Morton curve.
  std::vector<int> alongCurve(const std::vector<int>& vertices) const
  {
    Vector3 lower = this->place(vertices.front()), upper = lower;
    for (const int v : vertices)
    {
      lower = lower.cwiseMin(this->place(v));
      upper = upper.cwiseMax(this->place(v));
    }
    const double size = std::max((upper - lower).maxCoeff(), std::numeric_limits<double>::min());
    std::vector<int> sorted = mortonOrder(
      static_cast<Index>(vertices.size()),
      [&](Index i) { return Vector3((this->place(vertices[i]) - lower) / size); }, this->Threads);
    for (int& v : sorted)
    {
      v = vertices[v];
    }
    return sorted;
  }

  /// Test whether an edge is the longest of its two triangles, up to rounding.
  bool isLongest(int a, int b) const
  {
    constexpr double rounding = 1e-7;
    const Vector3 pa = this->place(a), pb = this->place(b);
    const auto across = this->Rings.across(a, b);
    double others = 0.0;
    for (const int c : { across.Left, across.Right })
    {
      const Vector3 pc = this->place(c);
      others = std::max({ others, (pc - pa).squaredNorm(), (pc - pb).squaredNorm() });
    }
    return (pa - pb).squaredNorm() >= (1.0 - rounding) * others;
  }

  Vector3 place(int v) const { return this->Places.row(v); }

  /// Apply operations in rounds. First propose operations, on all threads, for edges with an end
  /// touched in the last round. Then apply them by priority, except those on vertices touched in
  /// this round.
  /// @param[in] proposed   function that returns whether to operate on an edge, and sets the
  ///   priority and position of the operation
  /// @param[in] operate    function that applies an operation and lists the touched vertices. If
  ///   the operation is not possible, it returns false.
  /// @param[in] wanted     function that returns whether to continue
  void perform(const std::function<bool(int, int, Operation&)>& proposed,
    const std::function<bool(const Operation&, std::vector<int>&)>& operate,
    const std::function<bool()>& wanted)
  {
    std::vector<char> active(this->Rings.size(), 1), taken;
    std::vector<int> touched;
    for (int round = 0; round < MaximumRounds && wanted(); ++round)
    {
      const std::vector<Operation> operations = this->proposals(active, proposed);
      taken.assign(active.size(), 0);
      bool any = false;
      for (const Operation& operation : operations)
      {
        if (!wanted())
        {
          break;
        }
        if (taken[operation.A] || taken[operation.B] || !operate(operation, touched))
        {
          continue;
        }
        any = true;
        taken.resize(this->Rings.size(), 0);
        for (const int v : touched)
        {
          taken[v] = 1;
        }
      }
      active.swap(taken);
      this->Step.report(1.0 - 1.0 / (round + 2.0));
      if (!any)
      {
        break;
      }
    }
  }

  /// Return the operations in sorted order.
  std::vector<Operation> proposals(const std::vector<char>& active,
    const std::function<bool(int, int, Operation&)>& proposed) const
  {
    const Index size = this->Rings.size();
    std::vector<std::vector<Operation>> found((size + HeavyBlock - 1) / HeavyBlock);
    forBlocks(this->Threads, size, HeavyBlock,
      [&](Index begin, Index end)
      {
        std::vector<Operation>& ours = found[begin / HeavyBlock];
        for (int a = static_cast<int>(begin); a < end; ++a)
        {
          if (!active[a])
          {
            continue; // after the first round, most vertices are not active
          }
          for (const int b : this->Rings[a])
          {
            // An edge with two active ends belongs to the one with the smaller id.
            Operation operation = { std::min(a, b), std::max(a, b), 0.0 };
            if ((a < b || !active[b]) && proposed(operation.A, operation.B, operation))
            {
              ours.push_back(operation);
            }
          }
        }
        std::sort(ours.begin(), ours.end());
      });
    std::vector<Operation> operations;
    std::vector<Index> offsets = { 0 };
    for (const std::vector<Operation>& some : found)
    {
      operations.insert(operations.end(), some.begin(), some.end());
      offsets.push_back(static_cast<Index>(operations.size()));
    }
    found = {};
    this->merge(operations, offsets);
    return operations;
  }

  /// Merge sorted parts.
  /// @param[in] offsets  first index of each part, then the end of the last part
  void merge(std::vector<Operation>& operations, const std::vector<Index>& offsets) const
  {
    const auto parts = static_cast<Index>(offsets.size()) - 1;
    std::vector<Operation> merged(parts > 1 ? operations.size() : 0);
    for (Index width = 1; width < parts; width *= 2)
    {
      this->Threads.forEach((parts + 2 * width - 1) / (2 * width),
        [&](Index pair)
        {
          const auto part = [&](Index i)
          { return operations.begin() + offsets[std::min(2 * width * pair + i * width, parts)]; };
          std::merge(
            part(0), part(1), part(1), part(2), merged.begin() + (part(0) - operations.begin()));
        });
      operations.swap(merged);
    }
  }

  /// Enlarge the array of positions to at least a given number, plus half of this number.
  void reserve(Index count)
  {
    if (count > this->Places.rows())
    {
      this->Places.conservativeResize(count + count / 2, 3);
    }
  }

  /// Test whether b may collapse into a, and choose the position of the result.
  bool canCollapse(int a, int b, double longest, bool anyway, Vector3& place) const
  {
    const auto across = this->Rings.across(a, b);
    if (this->Rings[across.Left].size() <= 3 || this->Rings[across.Right].size() <= 3 ||
      !this->Rings.canCollapse(b, a) || (!anyway && this->Rings.collapsePinches(b, a)))
    {
      return false;
    }
    for (const Vector3& candidate :
      { Vector3(0.5 * (this->place(a) + this->place(b))), this->place(a), this->place(b) })
    {
      if (anyway ||
        (this->staysGood(a, b, candidate, longest) && this->staysGood(b, a, candidate, longest)))
      {
        place = candidate;
        return true;
      }
    }
    return false;
  }

  /// Test whether the triangles of v without u stay valid when v moves.
  bool staysGood(int v, int u, const Vector3& to, double longest) const
  {
    const Ring& ring = this->Rings[v];
    const Vector3 from = this->place(v);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const int id = ring[i], nextId = ring[(i + 1) % ring.size()];
      const Vector3 p = this->place(id), q = this->place(nextId);
      if (id != u && (p - to).squaredNorm() > longest * longest)
      {
        return false;
      }
      if (id != u && nextId != u &&
        (cosineBetween(twiceAreaVector(from, p, q), twiceAreaVector(to, p, q)) < MinimumCosine ||
          triangleQuality(to, p, q) <= MinimumQuality))
      {
        return false;
      }
    }
    return true;
  }

  /// Flip edges of positive gain if the surface keeps its shape.
  /// @param[in] minimumQuality  minimum quality of the new triangles, divided by that of the old
  ///   ones
  template <typename Gain>
  void flip(double minimumDihedral, double minimumQuality, const Gain& gain)
  {
    const auto proposed = [&](int a, int b, Operation& operation)
    {
      const auto [left, right] = this->Rings.across(a, b);
      operation.Priority = gain(a, b, left, right);
      if (!(operation.Priority > 0.0) || !this->Rings.canFlip(a, b))
      {
        return false;
      }
      const Vector3 pa = this->place(a), pb = this->place(b), pl = this->place(left),
                    pr = this->place(right);
      const Vector3 oldLeft = twiceAreaVector(pa, pb, pl), oldRight = twiceAreaVector(pb, pa, pr);
      const Vector3 newA = twiceAreaVector(pa, pr, pl), newB = twiceAreaVector(pb, pl, pr);
      const Vector3 mean = oldLeft + oldRight;
      const double dihedral = cosineBetween(newA, newB);
      return cosineBetween(newA, mean) > MinimumCosine &&
        cosineBetween(newB, mean) > MinimumCosine &&
        (dihedral >= minimumDihedral || dihedral >= cosineBetween(oldLeft, oldRight)) &&
        std::min(triangleQuality(pa, pr, pl), triangleQuality(pb, pl, pr)) >=
        minimumQuality * std::min(triangleQuality(pa, pb, pl), triangleQuality(pb, pa, pr)) &&
        !this->Rings.flipPinches(a, b);
    };
    this->perform(
      proposed,
      [&](const Operation& operation, std::vector<int>& touched)
      {
        const auto across = this->Rings.across(operation.A, operation.B);
        touched = { operation.A, operation.B, across.Left, across.Right };
        Operation still = operation; // another flip may have changed the opposite vertices
        if (!proposed(operation.A, operation.B, still))
        {
          return false;
        }
        this->Rings.flip(operation.A, operation.B);
        return true;
      },
      [] { return true; });
  }

  /// Partition the vertices into sets of which no two members are neighbors.
  std::vector<std::vector<int>> colors() const
  {
    std::vector<int> used;
    for (int v = 0; v < this->Rings.size(); ++v)
    {
      if (!this->Rings[v].empty())
      {
        used.push_back(v);
      }
    }
    return independentSets(used, this->Rings.size(),
      [&](int v, const std::function<void(int)>& visit)
      { std::for_each(this->Rings[v].begin(), this->Rings[v].end(), visit); });
  }

  void smooth(int v)
  {
    const Ring& ring = this->Rings[v];
    const Vector3 from = this->place(v);
    Vector3 normal = Vector3::Zero(), middle = Vector3::Zero();
    double area = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Vector3 p = this->place(ring[i]), q = this->place(ring[(i + 1) % ring.size()]);
      const Vector3 vector = twiceAreaVector(from, p, q);
      const double share = vector.norm();
      normal += vector;
      middle += share / 3.0 * (from + p + q);
      area += share;
    }
    if (!(area > 0.0) || !(normal.squaredNorm() > 0.0))
    {
      return;
    }
    normal.normalize();
    Vector3 step = SmoothingStep * (middle / area - from);
    step -= step.dot(normal) * normal;
    for (int attempt = 0; attempt < SmoothingTries; ++attempt, step *= 0.5)
    {
      if (this->keepsNormals(v, from + step))
      {
        this->Places.row(v) = from + step;
        return;
      }
    }
  }

  bool keepsNormals(int v, const Vector3& to) const
  {
    const Ring& ring = this->Rings[v];
    const Vector3 from = this->place(v);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Vector3 p = this->place(ring[i]), q = this->place(ring[(i + 1) % ring.size()]);
      if (cosineBetween(twiceAreaVector(from, p, q), twiceAreaVector(to, p, q)) <= MinimumCosine)
      {
        return false;
      }
    }
    return true;
  }

  Points& Places;
  conformal::Triangles& Triangles;
  const Run Threads; // threads without progress reports
  VertexRings Rings;
  Index Count;
  Run Step; // receives the progress of the current remeshing step
};

/// Return the relative durations of all steps. Each iteration has splits, collapses, flips and
/// smoothing. MeetNumber adds collapses, splits, smoothings and flips.
std::vector<double> sharesOf(const RemeshingOptions& options)
{
  std::vector<double> shares;
  for (int iteration = 0; iteration < options.NumberOfIterations; ++iteration)
  {
    shares.insert(shares.end(), { 0.2, iteration == 0 ? 1.0 : 0.2, 0.4, 0.2 });
  }
  if (options.MeetNumber)
  {
    shares.insert(shares.end(), { 0.2, 0.2 });
    shares.insert(shares.end(), FinalSmoothings, 0.6);
    shares.push_back(0.4);
  }
  return shares;
}
}

//------------------------------------------------------------------------------
void remesh(Mesh& mesh, const RemeshingOptions& options, const Run& run)
{
  if (options.NumberOfVertices < 4 || options.NumberOfIterations < 0)
  {
    throw std::invalid_argument(
      "NumberOfVertices must be at least 4, and NumberOfIterations not negative");
  }
  const Index wanted = options.NumberOfVertices;
  Steps steps(run, sharesOf(options));
  Remesher remesher(mesh.Positions, mesh.Triangles, run);
  double length = remesher.lengthFor(wanted);
  const bool isCoarse = remesher.longestEdge() > CoarseEdge * length;
  for (int iteration = 0; iteration < options.NumberOfIterations; ++iteration)
  {
    remesher.reportTo(steps.next());
    remesher.split(
      LongestEdge * length, std::max(remesher.count(), MaximumSplit * wanted), isCoarse);
    remesher.reportTo(steps.next());
    remesher.collapse(ShortestEdge * length, LongestEdge * length);
    remesher.reportTo(steps.next());
    remesher.flipForValence();
    steps.next();
    remesher.smooth();
    const double ratio = static_cast<double>(remesher.count()) / static_cast<double>(wanted);
    length = remesher.lengthFor(wanted) * std::clamp(std::sqrt(ratio), 0.8, 1.25);
  }
  if (options.MeetNumber)
  {
    constexpr double any = std::numeric_limits<double>::max();
    remesher.reportTo(steps.next());
    remesher.collapse(any, any, wanted);
    remesher.collapse(any, any, wanted, true); // for strongly folded surfaces
    remesher.reportTo(steps.next());
    remesher.split(0.0, wanted, false);
    for (int i = 0; i < FinalSmoothings; ++i)
    {
      remesher.reportTo(steps.next());
      remesher.flipForValence();
      remesher.smooth();
    }
    remesher.reportTo(steps.next());
    remesher.flipForAngles();
  }
  remesher.finish();
  run.report(1.0);
}
}
