#include "Geodesics/IntrinsicTriangulation.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Tolerance of the sum of both cotangents, below which an edge is flipped.
constexpr double Tolerance = 1e-9;
// Smallest excess of the sum of two edges over the third one, in mean edge lengths.
constexpr double MinimumExcess = 1e-5;
// Number of vertices of the result, in those of the mesh, above which no edges are divided.
constexpr Index MaximumGrowth = 2;

// Edge of a triangle: triangle * 3 + corner at which the edge starts.
using Side = int;

// Edges of a triangulation.
struct Edges
{
  std::vector<Side> Glued; // for each side, that of the neighboring triangle; -1 if it is kept
  std::vector<int> Kept;   // for each side, number of its edge; -1 if it is glued
  int NumberOfKept = 0;
};

// Glue each two sides of opposite orientation to each other. All other edges are kept.
Edges edgesOf(const Triangles& triangles)
{
  struct Edge
  {
    int Low, High;
    Side Here;
    bool Forward;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.rows());
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int from = triangles(t, k), to = triangles(t, next(k));
      edges.push_back(
        { std::min(from, to), std::max(from, to), static_cast<Side>(3 * t + k), from < to });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b) {
      return a.Low != b.Low ? a.Low < b.Low : a.High != b.High ? a.High < b.High : a.Here < b.Here;
    });
  Edges result;
  result.Glued.assign(edges.size(), -1);
  result.Kept.assign(edges.size(), -1);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
  {
    while (end < edges.size() && edges[end].Low == edges[begin].Low &&
      edges[end].High == edges[begin].High)
    {
      ++end;
    }
    if (end - begin == 2 && edges[begin].Forward != edges[begin + 1].Forward)
    {
      result.Glued[edges[begin].Here] = edges[begin + 1].Here;
      result.Glued[edges[begin + 1].Here] = edges[begin].Here;
      continue;
    }
    for (std::size_t e = begin; e < end; ++e)
    {
      result.Kept[edges[e].Here] = result.NumberOfKept;
    }
    ++result.NumberOfKept;
  }
  return result;
}

std::vector<int> partsOf(const Triangles& triangles, Index numberOfVertices)
{
  DisjointSets sets(numberOfVertices);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    sets.unite(triangles(t, 0), triangles(t, 1));
    sets.unite(triangles(t, 0), triangles(t, 2));
  }
  std::vector<int> parts(numberOfVertices);
  for (Index v = 0; v < numberOfVertices; ++v)
  {
    parts[v] = sets.find(static_cast<int>(v));
  }
  return parts;
}

Points edgeLengths(const Mesh& mesh)
{
  Points lengths(mesh.Triangles.rows(), 3);
  for (Index t = 0; t < lengths.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      lengths(t, k) =
        (mesh.Positions.row(mesh.Triangles(t, next(k))) - mesh.Positions.row(mesh.Triangles(t, k)))
          .norm();
    }
  }
  return lengths;
}

// Lengthen all edges of a part if one of its triangles has almost no area.
void lengthen(IntrinsicTriangulation& surface)
{
  const SidesOfParts sides = sidesOfParts(surface);
  std::vector<double> missing(surface.Parts.size(), 0.0);
  const auto partOf = [&](Index t) { return surface.Parts[surface.Triangles(t, 0)]; };
  for (Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    const int part = partOf(t);
    const double excess = surface.Lengths.row(t).sum() - 2.0 * surface.Lengths.row(t).maxCoeff();
    missing[part] =
      std::max(missing[part], MinimumExcess * sides.Lengths[part] / sides.Counts[part] - excess);
  }
  for (Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    surface.Lengths.row(t).array() += missing[partOf(t)];
  }
}

// Triangulation whose edges can be flipped, or divided.
class Flips
{
public:
  explicit Flips(IntrinsicTriangulation& result)
    : Of(edgesOf(result.Triangles))
    , Result(result)
    , IsWaiting(this->Of.Glued.size(), 0)
  {
    for (Side side = 0; side < static_cast<Side>(this->Of.Glued.size()); ++side)
    {
      this->wait(side);
    }
  }

  void flipToDelaunay(const Run& run)
  {
    constexpr Index interval = 1 << 16;
    for (; !this->Waiting.empty(); ++this->Count)
    {
      const Side side = this->Waiting.front();
      this->Waiting.pop_front();
      this->IsWaiting[side] = 0;
      if (this->Count % interval == 0)
      {
        const auto size = static_cast<double>(this->Of.Glued.size());
        run.report(std::min(0.99, static_cast<double>(this->Count) / (2.0 * size)));
      }
      if (this->cotangentSum(side) < -Tolerance)
      {
        for (const Side outer : this->flip(side))
        {
          this->wait(outer);
        }
      }
    }
  }

  // Divide edges that are kept and have a negative weight, but not two edges of a triangle. Return
  // whether there are any.
  bool divideKept()
  {
    std::vector<double> weights(this->Of.NumberOfKept, 0.0);
    std::vector<std::vector<Side>> sides(this->Of.NumberOfKept);
    for (Side side = 0; side < static_cast<Side>(this->Of.Kept.size()); ++side)
    {
      const int edge = this->Of.Kept[side];
      if (edge >= 0)
      {
        weights[edge] += this->cotangent(side);
        sides[edge].push_back(side);
      }
    }
    std::vector<char> isChanged(this->Result.Triangles.rows(), 0);
    std::vector<std::size_t> chosen;
    Index count = 0;
    for (std::size_t edge = 0; edge < weights.size(); ++edge)
    {
      const auto isUnchanged = [&](Side side) { return !isChanged[side / 3]; };
      if (weights[edge] < -Tolerance &&
        std::all_of(sides[edge].begin(), sides[edge].end(), isUnchanged))
      {
        for (const Side side : sides[edge])
        {
          isChanged[side / 3] = 1;
        }
        chosen.push_back(edge);
        count += static_cast<Index>(sides[edge].size());
      }
    }
    auto vertex = static_cast<int>(this->Result.Positions.rows());
    Index triangle = this->Result.Triangles.rows();
    this->Result.Positions.conservativeResize(vertex + static_cast<Index>(chosen.size()), 3);
    this->Result.Triangles.conservativeResize(triangle + count, 3);
    this->Result.Lengths.conservativeResize(triangle + count, 3);
    for (const std::size_t edge : chosen)
    {
      this->divide(sides[edge], vertex, triangle);
      ++vertex;
      triangle += static_cast<Index>(sides[edge].size());
    }
    return !chosen.empty();
  }

private:
  void wait(Side side)
  {
    const Side across = this->Of.Glued[side];
    if (across >= 0 && !this->IsWaiting[side] && !this->IsWaiting[across])
    {
      this->IsWaiting[side] = 1;
      this->Waiting.push_back(side);
    }
  }

  // Return the sum of the cotangents of the angles opposite an edge; 0 if it must be kept.
  double cotangentSum(Side side) const
  {
    const Side across = this->Of.Glued[side];
    if (across < 0 || across / 3 == side / 3)
    {
      return 0.0;
    }
    return this->cotangent(side) + this->cotangent(across);
  }

  // Cotangent of the angle opposite a side.
  double cotangent(Side side) const
  {
    return cotangentsOf(this->Result.Lengths.row(side / 3))[previous(side % 3)];
  }

  // Position of the opposite corner of a side, along the side and perpendicular to it.
  Eigen::Vector2d opposite(Side side) const
  {
    const Vector3 lengths = this->Result.Lengths.row(side / 3);
    const double ab = lengths[side % 3], bc = lengths[next(side % 3)],
                 ca = lengths[previous(side % 3)];
    return { (ab * ab + ca * ca - bc * bc) / (2.0 * ab), 2.0 * areaOf(lengths) / ab };
  }

  // Divide an edge, given its sides, at the foot of the opposite corner with the largest angle.
  // Assign the id `added` to the new vertex, and ids from `triangle` to new triangles.
  void divide(std::vector<Side> sides, int added, Index triangle)
  {
    const Side widest = *std::min_element(sides.begin(), sides.end(),
      [&](Side a, Side b) { return this->cotangent(a) < this->cotangent(b); });
    const int start = this->Result.Triangles(widest / 3, widest % 3),
              end = this->Result.Triangles(widest / 3, next(widest % 3));
    double fraction = this->opposite(widest).x() / this->Result.Lengths(widest / 3, widest % 3);
    fraction = fraction > 0.0 && fraction < 1.0 ? fraction : 0.5;
    Points& positions = this->Result.Positions;
    positions.row(added) = (1.0 - fraction) * positions.row(start) + fraction * positions.row(end);
    this->Result.Parts.push_back(this->Result.Parts[start]);
    const int first = this->Of.Kept[widest], second = this->Of.NumberOfKept++;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      const bool isForward = this->Result.Triangles(sides[i] / 3, sides[i] % 3) == start;
      const Side before = 3 * (sides[i] / 3) + next(sides[i] % 3);
      const Index half = triangle + static_cast<Index>(i);
      this->divideTriangle(sides[i], isForward ? fraction : 1.0 - fraction, added, half);
      this->Of.Kept[sides[i]] = isForward ? first : second;
      this->Of.Kept[3 * half] = isForward ? second : first;
      std::replace(sides.begin() + static_cast<std::ptrdiff_t>(i), sides.end(), before,
        static_cast<Side>(3 * half + 1));
    }
  }

  // Divide a triangle by an edge from the opposite corner of a side to a new vertex. The next side
  // becomes side 1 of a new triangle.
  void divideTriangle(Side side, double fraction, int added, Index newTriangle)
  {
    Triangles& triangles = this->Result.Triangles;
    Points& lengths = this->Result.Lengths;
    const int t = side / 3, k = side % 3, u = static_cast<int>(newTriangle);
    const Side afterSide = 3 * t + next(k);
    const double whole = lengths(t, k);
    const Eigen::Vector2d apex = this->opposite(side);
    const double middle = std::hypot(apex.x() - fraction * whole, apex.y());
    // Triangle (a, b, c) becomes (a, m, c) and (m, b, c).
    triangles.row(u) << added, triangles(t, next(k)), triangles(t, previous(k));
    lengths.row(u) << (1.0 - fraction) * whole, lengths(t, next(k)), middle;
    triangles(t, next(k)) = added;
    lengths(t, k) = fraction * whole;
    lengths(t, next(k)) = middle;
    const Side outer = this->Of.Glued[afterSide];
    this->Of.Glued.insert(this->Of.Glued.end(), { -1, outer, afterSide });
    this->Of.Kept.insert(this->Of.Kept.end(), { -1, this->Of.Kept[afterSide], -1 });
    this->IsWaiting.resize(this->Of.Glued.size(), 0);
    if (outer >= 0)
    {
      this->Of.Glued[outer] = 3 * u + 1;
    }
    this->Of.Glued[afterSide] = 3 * u + 2;
    this->Of.Kept[afterSide] = -1;
    for (const Side changed : { afterSide, 3 * t + previous(k), 3 * u + 1 })
    {
      this->wait(changed);
    }
  }

  // Flip an edge. Return the four sides around it.
  std::array<Side, 4> flip(Side side)
  {
    const Side across = this->Of.Glued[side];
    const int t = side / 3, u = across / 3, s = side % 3, r = across % 3;
    Triangles& triangles = this->Result.Triangles;
    Points& lengths = this->Result.Lengths;
    // Triangles (a, b, c) and (b, a, d) become (c, a, d) and (d, b, c).
    const int a = triangles(t, s), b = triangles(t, next(s)), c = triangles(t, previous(s)),
              d = triangles(u, previous(r));
    const double ab = lengths(t, s), bc = lengths(t, next(s)), ca = lengths(t, previous(s)),
                 ad = lengths(u, next(r)), db = lengths(u, previous(r));
    const double xOfC = (ab * ab + ca * ca - bc * bc) / (2.0 * ab),
                 xOfD = (ab * ab + ad * ad - db * db) / (2.0 * ab);
    const double heights = 2.0 * (areaOf({ ab, bc, ca }) + areaOf({ ab, ad, db })) / ab;
    const double cd = std::hypot(xOfC - xOfD, heights);
    const Side ofA = this->Of.Glued[3 * t + previous(s)], ofD = this->Of.Glued[3 * t + next(s)],
               ofAD = this->Of.Glued[3 * u + next(r)], ofDB = this->Of.Glued[3 * u + previous(r)];
    // Sides of the quadrilateral before and after the flip, since they can be glued to each other.
    const Side before[] = { 3 * t + previous(s), 3 * u + next(r), 3 * u + previous(r),
      3 * t + next(s) };
    const Side after[] = { 3 * t, 3 * t + 1, 3 * u, 3 * u + 1 };
    const Side others[] = { ofA, ofAD, ofDB, ofD };
    const int kept[] = { this->Of.Kept[before[0]], this->Of.Kept[before[1]],
      this->Of.Kept[before[2]], this->Of.Kept[before[3]] };
    triangles.row(t) << c, a, d;
    triangles.row(u) << d, b, c;
    lengths.row(t) << ca, ad, cd;
    lengths.row(u) << db, bc, cd;
    for (int i = 0; i < 4; ++i)
    {
      const auto* const inside = std::find(std::begin(before), std::end(before), others[i]);
      const Side other =
        inside == std::end(before) ? others[i] : after[inside - std::begin(before)];
      this->Of.Glued[after[i]] = other;
      this->Of.Kept[after[i]] = kept[i];
      if (other >= 0)
      {
        this->Of.Glued[other] = after[i];
      }
    }
    this->Of.Glued[3 * t + 2] = 3 * u + 2;
    this->Of.Glued[3 * u + 2] = 3 * t + 2;
    this->Of.Kept[3 * t + 2] = this->Of.Kept[3 * u + 2] = -1;
    return { after[0], after[1], after[2], after[3] };
  }

  Edges Of;
  IntrinsicTriangulation& Result;
  std::deque<Side> Waiting;
  std::vector<char> IsWaiting;
  Index Count = 0; // of edges that were checked
};
}

//------------------------------------------------------------------------------
double areaOf(const Vector3& lengths)
{
  // Heron's formula, in the sequence that is accurate for thin triangles, \cite Kahan2014.
  double a = lengths[0], b = lengths[1], c = lengths[2];
  if (a < b)
  {
    std::swap(a, b);
  }
  if (a < c)
  {
    std::swap(a, c);
  }
  if (b < c)
  {
    std::swap(b, c);
  }
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return 0.25 * std::sqrt(std::max(0.0, product));
}

//------------------------------------------------------------------------------
Vector3 cotangentsOf(const Vector3& lengths)
{
  const double area = areaOf(lengths);
  if (!(area > 0.0))
  {
    return Vector3::Zero();
  }
  const Vector3 squares = lengths.cwiseAbs2();
  Vector3 result;
  for (int k = 0; k < 3; ++k)
  {
    // The edges at corner k are edges k and k - 1.
    result[k] = (squares[k] + squares[previous(k)] - squares[next(k)]) / (4.0 * area);
  }
  return result;
}

//------------------------------------------------------------------------------
SidesOfParts sidesOfParts(const IntrinsicTriangulation& surface)
{
  const std::size_t size = surface.Parts.size();
  SidesOfParts sides{ std::vector<double>(size, 0.0), std::vector<double>(size, 0.0) };
  for (Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    const int part = surface.Parts[surface.Triangles(t, 0)];
    sides.Lengths[part] += surface.Lengths.row(t).sum();
    sides.Counts[part] += 3.0;
  }
  return sides;
}

//------------------------------------------------------------------------------
IntrinsicTriangulation intrinsicDelaunay(const Mesh& mesh, const Run& run)
{
  const Index size = mesh.Positions.rows();
  IntrinsicTriangulation result{ mesh.Triangles, edgeLengths(mesh), mesh.Positions,
    partsOf(mesh.Triangles, size) };
  lengthen(result);
  Flips flips(result);
  flips.flipToDelaunay(run);
  while (result.Positions.rows() < MaximumGrowth * size + 1000 && flips.divideKept())
  {
    flips.flipToDelaunay(run);
  }
  run.report(1.0);
  return result;
}
}
