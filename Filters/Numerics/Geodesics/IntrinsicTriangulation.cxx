#include "Geodesics/IntrinsicTriangulation.h"

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

// Edge of a triangle: triangle * 3 + corner at which the edge starts.
using Side = int;

// Find the side of the neighboring triangle for each side; -1 for sides that are kept.
std::vector<Side> gluedSides(const Triangles& triangles)
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
  std::vector<Side> glued(edges.size(), -1);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end)
  {
    while (end < edges.size() && edges[end].Low == edges[begin].Low &&
      edges[end].High == edges[begin].High)
    {
      ++end;
    }
    if (end - begin == 2 && edges[begin].Forward != edges[begin + 1].Forward)
    {
      glued[edges[begin].Here] = edges[begin + 1].Here;
      glued[edges[begin + 1].Here] = edges[begin].Here;
    }
  }
  return glued;
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

// Lengthen all edges if a triangle has almost no area.
void lengthen(Points& lengths)
{
  const double minimum = MinimumExcess * (lengths.size() > 0 ? lengths.mean() : 0.0);
  double missing = 0.0;
  for (Index t = 0; t < lengths.rows(); ++t)
  {
    const double excess = lengths.row(t).sum() - 2.0 * lengths.row(t).maxCoeff();
    missing = std::max(missing, minimum - excess);
  }
  lengths.array() += missing;
}

// Triangulation whose edges can be flipped.
class Flips
{
public:
  Flips(const Mesh& mesh, IntrinsicTriangulation& result)
    : Glued(gluedSides(mesh.Triangles))
    , Result(result)
  {
  }

  void flipToDelaunay(const Run& run)
  {
    const auto size = static_cast<Side>(this->Glued.size());
    std::deque<Side> waiting;
    std::vector<char> isWaiting(size, 0);
    const auto wait = [&](Side side)
    {
      const Side across = this->Glued[side];
      if (across >= 0 && !isWaiting[side] && !isWaiting[across])
      {
        isWaiting[side] = 1;
        waiting.push_back(side);
      }
    };
    for (Side side = 0; side < size; ++side)
    {
      wait(side);
    }
    constexpr Index interval = 1 << 16;
    for (Index count = 0; !waiting.empty(); ++count)
    {
      const Side side = waiting.front();
      waiting.pop_front();
      isWaiting[side] = 0;
      if (count % interval == 0)
      {
        run.report(std::min(0.99, static_cast<double>(count) / (2.0 * size)));
      }
      if (this->cotangentSum(side) < -Tolerance)
      {
        for (const Side outer : this->flip(side))
        {
          wait(outer);
        }
      }
    }
  }

private:
  // Return the sum of the cotangents of the angles opposite an edge; 0 if it must be kept.
  double cotangentSum(Side side) const
  {
    const Side across = this->Glued[side];
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

  // Flip an edge. Return the four sides around it.
  std::array<Side, 4> flip(Side side)
  {
    const Side across = this->Glued[side];
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
    const Side ofA = this->Glued[3 * t + previous(s)], ofD = this->Glued[3 * t + next(s)],
               ofAD = this->Glued[3 * u + next(r)], ofDB = this->Glued[3 * u + previous(r)];
    // Sides of the quadrilateral before and after the flip, since they can be glued to each other.
    const Side before[] = { 3 * t + previous(s), 3 * u + next(r), 3 * u + previous(r),
      3 * t + next(s) };
    const Side after[] = { 3 * t, 3 * t + 1, 3 * u, 3 * u + 1 };
    const Side others[] = { ofA, ofAD, ofDB, ofD };
    triangles.row(t) << c, a, d;
    triangles.row(u) << d, b, c;
    lengths.row(t) << ca, ad, cd;
    lengths.row(u) << db, bc, cd;
    for (int i = 0; i < 4; ++i)
    {
      const auto* const inside = std::find(std::begin(before), std::end(before), others[i]);
      const Side other =
        inside == std::end(before) ? others[i] : after[inside - std::begin(before)];
      this->Glued[after[i]] = other;
      if (other >= 0)
      {
        this->Glued[other] = after[i];
      }
    }
    this->Glued[3 * t + 2] = 3 * u + 2;
    this->Glued[3 * u + 2] = 3 * t + 2;
    return { after[0], after[1], after[2], after[3] };
  }

  std::vector<Side> Glued;
  IntrinsicTriangulation& Result;
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
IntrinsicTriangulation intrinsicDelaunay(const Mesh& mesh, const Run& run)
{
  IntrinsicTriangulation result{ mesh.Triangles, edgeLengths(mesh) };
  lengthen(result.Lengths);
  Flips(mesh, result).flipToDelaunay(run);
  run.report(1.0);
  return result;
}
}
