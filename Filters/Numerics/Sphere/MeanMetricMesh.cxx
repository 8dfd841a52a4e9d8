#include "Sphere/MeanMetricMesh.h"

#include "Base/Steps.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/VertexRings.h"
#include "Search/SelfIntersections.h"
#include "Sphere/SphereOrientation.h"
#include "Sphere/SphereStar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace conformal
{
namespace
{
// Measured on maps of four-legged animals: later rounds change neither angles nor folds.
constexpr int NumberOfRounds = 5;
// Bounds of the side lengths, divided by the target length: a split or a collapse brings a side of
// this length closer to the target length.
constexpr double LongSide = 4.0 / 3.0, ShortSide = 4.0 / 5.0;
// Shortest side that is split because its triangle crosses another one, divided by the target
// length. Where the map is too rough for the mesh, ever smaller triangles would cross, too.
constexpr double ShortestSplit = 0.4;
// Minimum area of a triangle of the sphere, divided by the square of its longest side. Flatter
// triangles are not made, since rounding of positions could turn them over.
constexpr double MinimumFlatness = 1e-7;
constexpr double LeastChange = 1e-6; // minimum gain of a flip
constexpr double Tolerance = 0.01;   // relative deviation from the target number of points

// Points of all surfaces with one direction: 3 coordinates for each surface.
using Coordinates = Eigen::VectorXd;

// Side of a triangle, with its length in the mean metric.
struct Side
{
  double Length;
  int A, B;
  bool operator<(const Side& other) const
  {
    return std::tie(this->Length, this->A, this->B) < std::tie(other.Length, other.A, other.B);
  }
};

class Remesher
{
public:
  Remesher(const std::vector<LocatedSurface>& surfaces, const Mesh& start, Index numberOfPoints,
    const Run& run)
    : Surfaces(surfaces)
    , Dimension(3 * static_cast<Index>(surfaces.size()))
    , Target(numberOfPoints)
    , Rings(start.Triangles, start.Positions.rows())
    , Places(start.Positions.rows())
    , Hints(start.Positions.rows(), std::vector<int>(surfaces.size(), -1))
    , Coords(Dimension, start.Positions.rows())
    , Used(start.Positions.rows())
  {
    for (const LocatedSurface& surface : surfaces)
    {
      double area = 0.0;
      for (Index r = 0; r < surface.Triangles->rows(); ++r)
      {
        area += areaVector(surface.Surface->Positions, *surface.Triangles, r).norm();
      }
      this->Scales.push_back(
        area > 0.0 ? 1.0 / std::sqrt(area * static_cast<double>(surfaces.size())) : 0.0);
    }
    for (std::size_t v = 0; v < this->Places.size(); ++v)
    {
      this->Places[v] = start.Positions.row(static_cast<Index>(v));
    }
    forBlocks(run, start.Positions.rows(), HeavyBlock,
      [&](Index begin, Index end)
      {
        for (Index v = begin; v < end; ++v)
        {
          this->locate(static_cast<int>(v));
        }
      });
  }

  Mesh remesh(const Run& run)
  {
    // Progress: rounds, then the number of points, then crossing triangles.
    std::vector<double> shares(NumberOfRounds, 0.16);
    shares.front() = 0.3; // splits most sides
    shares.insert(shares.end(), { 0.06, 0.06 });
    Steps steps(run, shares);
    for (int round = 0; round < NumberOfRounds; ++round)
    {
      const Run part = steps.next();
      if (round > 1)
      {
        this->Factor *=
          std::sqrt(static_cast<double>(this->Used) / static_cast<double>(this->Target));
      }
      this->Length = this->Factor * this->targetLength();
      this->splitLong(part.part(0.0, 0.3));
      this->collapseShort(part.part(0.3, 0.5));
      for (const double done : { 0.5, 0.75 })
      {
        this->flipAll(part.part(done, done + 0.1));
        this->smooth(part.part(done + 0.1, done + 0.25));
      }
    }
    const Run last = steps.next();
    this->adjustNumber(last.part(0.0, 0.7));
    this->flipAll(last.part(0.7, 0.8));
    this->smooth(last.part(0.8, 0.9));
    this->flipAll(last.part(0.9, 1.0));
    Mesh result = this->refineCrossings(steps.next());
    run.report(1.0);
    return result;
  }

private:
  // Estimate the progress after a number of passes, most of which are not necessary.
  static double doneAfter(int passes) { return 1.0 - std::pow(0.5, passes); }

  Mesh mesh() const
  {
    std::vector<int> ids(this->Places.size(), -1);
    Mesh mesh;
    mesh.Positions.resize(this->Used, 3);
    int count = 0;
    for (std::size_t v = 0; v < this->Places.size(); ++v)
    {
      if (!this->Rings[static_cast<int>(v)].empty())
      {
        mesh.Positions.row(count) = this->Places[v];
        ids[v] = count++;
      }
    }
    mesh.Triangles = this->Rings.triangles();
    for (Index k = 0; k < mesh.Triangles.size(); ++k)
    {
      mesh.Triangles.data()[k] = ids[mesh.Triangles.data()[k]];
    }
    return mesh;
  }

  Coordinates coordinatesAt(const Vector3& place, std::vector<int>& hints) const
  {
    Coordinates x(this->Dimension);
    for (std::size_t s = 0; s < this->Surfaces.size(); ++s)
    {
      const LocatedSurface& surface = this->Surfaces[s];
      const SphereLocation at = surface.Locator->locate(place, hints[s]);
      hints[s] = at.Triangle;
      Vector3 sum = Vector3::Zero();
      for (int k = 0; k < 3; ++k)
      {
        sum += at.Barycentric[k] *
          surface.Surface->Positions.row((*surface.Triangles)(at.Triangle, k)).transpose();
      }
      x.segment<3>(3 * static_cast<Index>(s)) = this->Scales[s] * sum;
    }
    return x;
  }

  void locate(int v) { this->Coords.col(v) = this->coordinatesAt(this->Places[v], this->Hints[v]); }

  double square(int a, int b) const
  {
    return (this->Coords.col(a) - this->Coords.col(b)).squaredNorm();
  }
  double length(int a, int b) const { return std::sqrt(this->square(a, b)); }

  // Four times the area of a triangle with the given squared sides.
  static double fourAreas(double p, double q, double r)
  {
    const double sum = p + q - r;
    return std::sqrt(std::max(0.0, 4.0 * p * q - sum * sum));
  }

  // Area of a triangle in the mean metric.
  double area(int a, int b, int c) const
  {
    return 0.25 * fourAreas(this->square(a, b), this->square(b, c), this->square(c, a));
  }

  static bool isValid(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const double longest =
      std::max({ (a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm() });
    return determinant(a, b, c) > std::max(MinimumFlatness * longest, 1e-22) &&
      orientation(a, b, c) > 0;
  }
  bool isValid(int a, int b, int c) const
  {
    return isValid(this->Places[a], this->Places[b], this->Places[c]);
  }

  // Side length at which triangles with equal sides fill the area.
  double targetLength() const
  {
    double sum = 0.0;
    for (int v = 0; v < static_cast<int>(this->Places.size()); ++v)
    {
      const Ring& ring = this->Rings[v];
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        sum += this->area(v, ring[i], ring[(i + 1) % ring.size()]) / 3.0;
      }
    }
    return std::sqrt(2.0 * sum / (std::sqrt(3.0) * static_cast<double>(this->Target)));
  }

  std::vector<Side> sides() const
  {
    std::vector<Side> sides;
    for (int a = 0; a < static_cast<int>(this->Places.size()); ++a)
    {
      for (const int b : this->Rings[a])
      {
        if (a < b)
        {
          sides.push_back({ this->length(a, b), a, b });
        }
      }
    }
    return sides;
  }

  bool isSide(int a, int b) const
  {
    const Ring& ring = this->Rings[a];
    return std::find(ring.begin(), ring.end(), b) != ring.end();
  }

  // Find the point on a side of the sphere whose distances to both ends are equal.
  Vector3 middle(int a, int b, std::vector<int>& hints, Coordinates& x) const
  {
    double low = 0.0, high = 1.0, t = 0.5;
    Vector3 place;
    for (int attempt = 0; attempt < 6; ++attempt)
    {
      place = (this->Places[a] + t * (this->Places[b] - this->Places[a])).normalized();
      x = this->coordinatesAt(place, hints);
      const double toA = (x - this->Coords.col(a)).norm(), toB = (x - this->Coords.col(b)).norm();
      if (std::min(toA, toB) > 0.7 * std::max(toA, toB))
      {
        break;
      }
      (toA < toB ? low : high) = t;
      t = 0.5 * (low + high);
    }
    return place;
  }

  bool split(int a, int b)
  {
    std::vector<int> hints = this->Hints[a];
    Coordinates x(this->Dimension);
    const Vector3 place = this->middle(a, b, hints, x);
    const VertexRings::Across across = this->Rings.across(a, b);
    const auto at = [&](int v) -> const Vector3& { return this->Places[v]; };
    if (!isValid(at(a), place, at(across.Left)) || !isValid(place, at(b), at(across.Left)) ||
      !isValid(at(b), place, at(across.Right)) || !isValid(place, at(a), at(across.Right)))
    {
      return false;
    }
    int m = static_cast<int>(this->Places.size());
    if (!this->Free.empty())
    {
      m = this->Free.back();
      this->Free.pop_back();
    }
    else
    {
      this->Rings.resize(m + 1);
      this->Places.emplace_back();
      this->Hints.emplace_back();
      if (this->Coords.cols() <= m)
      {
        this->Coords.conservativeResize(this->Dimension, 2 * m + 8);
      }
    }
    this->Rings.splitEdge(a, b, m);
    this->Places[m] = place;
    this->Hints[m] = std::move(hints);
    this->Coords.col(m) = x;
    ++this->Used;
    return true;
  }

  void splitLong(const Run& run)
  {
    constexpr int maximum = 30;
    for (int pass = 0; pass < maximum && this->Used < 2 * this->Target + 100; ++pass)
    {
      std::vector<Side> tooLong;
      for (const Side& side : this->sides())
      {
        if (side.Length > LongSide * this->Length)
        {
          tooLong.push_back(side);
        }
      }
      std::sort(tooLong.rbegin(), tooLong.rend());
      Index count = 0;
      for (const Side& side : tooLong)
      {
        count += this->split(side.A, side.B) ? 1 : 0;
      }
      run.report(doneAfter(pass + 1));
      if (count == 0)
      {
        return;
      }
    }
  }

  // Test whether a can move to the place of its neighbor b.
  bool canCollapse(int a, int b, double maximum) const
  {
    if (!this->Rings.canCollapse(a, b))
    {
      return false;
    }
    const Ring& ring = this->Rings[a];
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const int p = ring[i], q = ring[(i + 1) % ring.size()];
      if (p != b && this->length(p, b) > maximum)
      {
        return false;
      }
      if (p != b && q != b && !this->isValid(b, p, q))
      {
        return false;
      }
      if (p != b && q != b && this->turns(a, b, p, q))
      {
        return false;
      }
    }
    return true;
  }

  // Test whether triangle (from, p, q) turns by more than a right angle on a surface if its first
  // corner moves.
  bool turns(int from, int to, int p, int q) const
  {
    const auto at = [&](int v) { return this->Coords.col(v); };
    for (Index s = 0; 3 * s < this->Dimension; ++s)
    {
      if (normalOf(at(from), at(p), at(q), s).dot(normalOf(at(to), at(p), at(q), s)) < 0.0)
      {
        return true;
      }
    }
    return false;
  }

  bool collapse(int a, int b, double maximum)
  {
    for (int turn = 0; turn < 2; ++turn, std::swap(a, b))
    {
      if (this->canCollapse(a, b, maximum))
      {
        this->Rings.collapse(a, b);
        this->Free.push_back(a);
        --this->Used;
        return true;
      }
    }
    return false;
  }

  void collapseShort(const Run& run)
  {
    constexpr int maximum = 6;
    for (int pass = 0; pass < maximum; ++pass)
    {
      std::vector<Side> small;
      for (const Side& side : this->sides())
      {
        if (side.Length < ShortSide * this->Length)
        {
          small.push_back(side);
        }
      }
      std::sort(small.begin(), small.end());
      Index count = 0;
      for (const Side& side : small)
      {
        if (this->isSide(side.A, side.B) && this->length(side.A, side.B) < ShortSide * this->Length)
        {
          count += this->collapse(side.A, side.B, LongSide * this->Length) ? 1 : 0;
        }
      }
      run.report(doneAfter(pass + 1));
      if (count == 0)
      {
        return;
      }
    }
  }

  // Cotangent of the angle between two sides of a triangle, from the squares of the sides.
  static double cotangent(double side, double otherSide, double opposite)
  {
    constexpr double flat = 1e-12;
    return (side + otherSide - opposite) /
      std::max(fourAreas(side, otherSide, opposite), flat * (side + otherSide) + 1e-300);
  }

  // Normal of a triangle on surface s, not normalized.
  template <typename A, typename B, typename C>
  static Vector3 normalOf(const A& a, const B& b, const C& c, Index s)
  {
    const Vector3 p = a.template segment<3>(3 * s), q = b.template segment<3>(3 * s),
                  r = c.template segment<3>(3 * s);
    return (q - p).cross(r - p);
  }

  // Count the surfaces on which the triangles (a, b, c) and (b, a, d) form an angle of less than 90
  // degrees.
  int folds(int a, int b, int c, int d) const
  {
    int count = 0;
    const auto at = [&](int v) { return this->Coords.col(v); };
    for (Index s = 0; 3 * s < this->Dimension; ++s)
    {
      count += normalOf(at(a), at(b), at(c), s).dot(normalOf(at(b), at(a), at(d), s)) < 0.0;
    }
    return count;
  }

  // Count the folds between the triangles around a point, over all surfaces.
  int foldsAround(const Coordinates& center, const Ring& ring) const
  {
    int count = 0;
    const auto at = [&](std::size_t i) { return this->Coords.col(ring[i % ring.size()]); };
    for (Index s = 0; 3 * s < this->Dimension; ++s)
    {
      const Vector3 first = normalOf(center, at(0), at(1), s);
      Vector3 last = first;
      for (std::size_t i = 1; i < ring.size(); ++i)
      {
        const Vector3 normal = normalOf(center, at(i), at(i + 1), s);
        count += normal.dot(last) < 0.0;
        last = normal;
      }
      count += first.dot(last) < 0.0;
    }
    return count;
  }

  enum class Flip
  {
    None,
    ToDelaunay, // made the triangles Delaunay triangles
    OfFold      // only made fewer surfaces fold between the triangles
  };

  // Flip a side if that makes its triangles Delaunay triangles without a fold on a further surface,
  // or if the side is then folded on fewer surfaces.
  Flip flip(int a, int b)
  {
    if (!this->Rings.canFlip(a, b))
    {
      return Flip::None;
    }
    const VertexRings::Across across = this->Rings.across(a, b);
    const int c = across.Left, d = across.Right;
    const double ab = this->square(a, b), cd = this->square(c, d), ac = this->square(a, c),
                 bc = this->square(b, c), ad = this->square(a, d), bd = this->square(b, d);
    const double before = cotangent(ac, bc, ab) + cotangent(ad, bd, ab);
    const double after = cotangent(ac, ad, cd) + cotangent(bc, bd, cd);
    const int foldsBefore = this->folds(a, b, c, d), foldsAfter = this->folds(c, d, b, a);
    const bool isDelaunay = !(before < -LeastChange && after > before + LeastChange);
    if (foldsAfter > foldsBefore || (foldsAfter == foldsBefore && isDelaunay))
    {
      return Flip::None;
    }
    if (!this->isValid(c, a, d) || !this->isValid(d, b, c))
    {
      return Flip::None;
    }
    this->Rings.flip(a, b);
    return isDelaunay ? Flip::OfFold : Flip::ToDelaunay;
  }

  void flipAll(const Run& run)
  {
    std::vector<std::pair<int, int>> pending;
    for (int a = 0; a < static_cast<int>(this->Places.size()); ++a)
    {
      for (const int b : this->Rings[a])
      {
        if (a < b)
        {
          pending.emplace_back(a, b);
        }
      }
    }
    this->flip(std::move(pending), run);
  }

  // Flip sides, and sides around flipped ones, until the triangles are Delaunay triangles.
  void flip(std::vector<std::pair<int, int>> pending, const Run& run)
  {
    constexpr std::size_t sidesPerReport = 4096;
    // Ends the loop if flips go round in a circle.
    const std::size_t maximum = 6 * pending.size() + 1000;
    for (std::size_t done = 0; !pending.empty() && done < maximum; ++done)
    {
      if (done % sidesPerReport == 0)
      {
        run.report(static_cast<double>(done) / static_cast<double>(maximum));
      }
      const auto [a, b] = pending.back();
      pending.pop_back();
      if (!this->isSide(a, b))
      {
        continue;
      }
      const VertexRings::Across across = this->Rings.across(a, b);
      // Flips of folds could go round in a circle, so that they are not continued.
      if (this->flip(a, b) == Flip::ToDelaunay)
      {
        for (const int end : { a, b })
        {
          pending.emplace_back(end, across.Left);
          pending.emplace_back(end, across.Right);
        }
      }
    }
  }

  void smooth(const Run& run)
  {
    std::vector<int> used;
    for (int v = 0; v < static_cast<int>(this->Places.size()); ++v)
    {
      if (!this->Rings[v].empty())
      {
        used.push_back(v);
      }
    }
    const auto colors = independentSets(used, static_cast<int>(this->Places.size()),
      [&](int v, const std::function<void(int)>& visit)
      {
        for (const int other : this->Rings[v])
        {
          visit(other);
        }
      });
    Index done = 0;
    for (const std::vector<int>& color : colors)
    {
      forBlocks(run, static_cast<Index>(color.size()), HeavyBlock,
        [&](Index begin, Index end)
        {
          for (Index i = begin; i < end; ++i)
          {
            this->smooth(color[i]);
          }
        });
      done += static_cast<Index>(color.size());
      run.report(static_cast<double>(done) / static_cast<double>(used.size()));
    }
  }

  // Move a point to the centroid of its triangles in the mean metric.
  void smooth(int v)
  {
    const Ring& ring = this->Rings[v];
    const Vector3 from = this->Places[v];
    Vector3 sum = Vector3::Zero();
    double areas = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const int p = ring[i], q = ring[(i + 1) % ring.size()];
      const double weight = this->area(v, p, q);
      sum += weight / 3.0 * ((this->Places[p] - from) + (this->Places[q] - from));
      areas += weight;
    }
    if (!(areas > 0.0))
    {
      return;
    }
    const int before = this->foldsAround(this->Coords.col(v), ring);
    Vector3 step = sum / areas;
    for (int attempt = 0; attempt < 3; ++attempt, step *= 0.5)
    {
      const Vector3 to = (from + step).normalized();
      bool isGood = true;
      for (std::size_t i = 0; i < ring.size() && isGood; ++i)
      {
        isGood = isValid(to, this->Places[ring[i]], this->Places[ring[(i + 1) % ring.size()]]);
      }
      if (!isGood)
      {
        continue;
      }
      std::vector<int> hints = this->Hints[v];
      const Coordinates x = this->coordinatesAt(to, hints);
      if (this->foldsAround(x, ring) > before)
      {
        continue;
      }
      this->Places[v] = to;
      this->Hints[v] = std::move(hints);
      this->Coords.col(v) = x;
      return;
    }
  }

  // Split the longest or collapse the shortest sides until the number of points is close to the
  // target.
  void adjustNumber(const Run& run)
  {
    const auto target = static_cast<double>(this->Target);
    constexpr int maximum = 40;
    for (int pass = 0; pass < maximum; ++pass)
    {
      const double excess = static_cast<double>(this->Used) - target;
      if (std::abs(excess) <= Tolerance * target)
      {
        return;
      }
      std::vector<Side> all = this->sides();
      std::sort(all.begin(), all.end());
      auto missing = static_cast<Index>(std::abs(excess));
      if (excess < 0.0)
      {
        std::reverse(all.begin(), all.end());
      }
      Index count = 0;
      for (const Side& side : all)
      {
        if (missing == 0)
        {
          break;
        }
        if (!this->isSide(side.A, side.B) || this->length(side.A, side.B) != side.Length)
        {
          continue;
        }
        const bool done = excess < 0.0
          ? this->split(side.A, side.B)
          : this->collapse(side.A, side.B, std::numeric_limits<double>::infinity());
        count += done ? 1 : 0;
        missing -= done ? 1 : 0;
      }
      this->flipAll(run.unwatched());
      run.report(doneAfter(pass + 1));
      if (count == 0)
      {
        return;
      }
    }
  }

  // Split sides of triangles that cross each other on a surface. The surfaces themselves rarely
  // cross, so that smaller triangles do not. Keep the mesh with the fewest crossing triangles:
  // where the map is folded by rounding, splits only add further ones.
  Mesh refineCrossings(const Run& run)
  {
    constexpr int maximum = 8;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    Mesh best;
    for (int pass = 0; pass <= maximum; ++pass)
    {
      const std::vector<std::array<int, 3>> crossing =
        this->crossingTriangles(run.part(doneAfter(pass), doneAfter(pass + 1)));
      if (crossing.size() >= fewest)
      {
        break;
      }
      fewest = crossing.size();
      best = this->mesh();
      if (crossing.empty() || pass == maximum)
      {
        break;
      }
      std::vector<std::pair<int, int>> touched;
      for (const std::array<int, 3>& ids : crossing)
      {
        if (static_cast<double>(this->Used) >= (1.0 + 2.0 * Tolerance) * this->Target - 1.0)
        {
          break;
        }
        Side longest{ -1.0, 0, 0 };
        for (int k = 0; k < 3; ++k)
        {
          const int a = ids[k], b = ids[next(k)];
          if (this->isSide(a, b))
          {
            longest = std::max(longest, { this->length(a, b), std::min(a, b), std::max(a, b) });
          }
        }
        if (longest.Length > ShortestSplit * this->Length && this->split(longest.A, longest.B))
        {
          for (const int v : { longest.A, longest.B })
          {
            for (const int other : this->Rings[v])
            {
              touched.emplace_back(v, other);
            }
          }
        }
      }
      if (touched.empty())
      {
        break;
      }
      this->flip(std::move(touched), run.unwatched());
    }
    return best;
  }

  std::vector<std::array<int, 3>> crossingTriangles(const Run& run) const
  {
    const Triangles triangles = this->Rings.triangles();
    std::vector<char> isCrossing(triangles.rows(), 0);
    for (Index s = 0; s < this->Dimension; s += 3)
    {
      const Points shape =
        this->Coords.middleRows(s, 3).leftCols(static_cast<Index>(this->Places.size())).transpose();
      for (const std::array<int, 2>& pair : selfIntersections(shape, triangles, run.unwatched()))
      {
        isCrossing[pair[0]] = isCrossing[pair[1]] = 1;
      }
      run.report(static_cast<double>(s + 3) / static_cast<double>(this->Dimension));
    }
    std::vector<std::array<int, 3>> crossing;
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      if (isCrossing[r] != 0)
      {
        crossing.push_back({ triangles(r, 0), triangles(r, 1), triangles(r, 2) });
      }
    }
    return crossing;
  }

  const std::vector<LocatedSurface>& Surfaces;
  const Index Dimension;      // number of coordinates of a point
  const Index Target;         // number of points
  std::vector<double> Scales; // of the surfaces, to a total area of 1
  VertexRings Rings;
  std::vector<Vector3> Places;         // on the sphere
  std::vector<std::vector<int>> Hints; // triangle of each surface that contains each point
  Columns Coords;                      // Coordinates of each point
  std::vector<int> Free;               // ids of points that are not in use
  Index Used = 0;                      // number of points in use
  double Length = 0.0;                 // target length of a side
  double Factor = 1.0;                 // of the length, so that the number of points is the target
};
}

//------------------------------------------------------------------------------
Mesh remeshByMeanMetric(const std::vector<LocatedSurface>& surfaces, const Mesh& start,
  Index numberOfPoints, const Run& run)
{
  Remesher remesher(surfaces, start, numberOfPoints, run.unwatched());
  return remesher.remesh(run);
}
}
