#include "Mesh/QuadricCollapse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace conformal
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Penalties of unwanted collapses. They exceed all quadric errors of a mesh of size 1, so that
// unwanted collapses are made last.
constexpr double UnwantedCost = 1e3;
constexpr double TurnedOverCost = 1e6;

constexpr double ShapeWeight = 1e-4;
constexpr double WorstAspect = 8.0; // maximum aspect ratio of a triangle; 1 if equilateral
// Minimum cosine between the normals of a triangle before and after a collapse
constexpr double CollapseCosine = 0.2;
// Maximum number of neighbors of a vertex after a collapse
constexpr std::size_t MaximumNeighbors = 10;
constexpr std::size_t TooManyNeighbors = 24; // vertices with more neighbors are not removed yet

double aspectOf(const Vector3& a, const Vector3& b, const Vector3& c, double twiceArea)
{
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return sides > 1e4 * twiceArea ? 1e4 : sides / (2.0 * std::sqrt(3.0) * twiceArea);
}
}

//------------------------------------------------------------------------------
QuadricCollapse::QuadricCollapse(const Points& points, VertexRings& rings, Needles needles)
  : Places(points)
  , Rings(rings)
  , Quadrics(rings.size())
  , Aspects(rings.size(), WorstAspect)
  , Stamps(rings.size(), 0)
{
  for (int v = 0; v < rings.size(); ++v)
  {
    const Ring& ring = rings[v];
    const Vector3 x = this->point(v);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const Vector3 p = this->point(ring[i]), q = this->point(ring[(i + 1) % ring.size()]);
      const Vector3 normal = (p - x).cross(q - x); // twice area
      const double length = normal.norm();
      if (needles == Needles::Thin)
      {
        this->Aspects[v] = std::max(this->Aspects[v], aspectOf(x, p, q, length));
      }
      if (length > 0.0)
      {
        const Vector3 unit = normal / length;
        const double offset = -unit.dot(x);
        Quadric& quadric = this->Quadrics[v];
        quadric.A += length * unit * unit.transpose();
        quadric.B += length * offset * unit;
        quadric.C += length * offset * offset;
      }
    }
  }
  for (int v = 0; v < rings.size(); ++v)
  {
    if (!rings[v].empty())
    {
      this->enqueue(v);
    }
  }
}

//------------------------------------------------------------------------------
// Compute the part of the cost that depends on the shape of the triangles after a collapse.
double QuadricCollapse::shapeCost(int v, int u) const
{
  const Ring& ring = this->Rings[v];
  const Vector3 from = this->point(v), to = this->point(u);
  double area = 0.0, aspect = 1.0;
  bool turned = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const int first = ring[i], second = ring[(i + 1) % ring.size()];
    if (first == u || second == u)
    {
      continue;
    }
    const Vector3 p = this->point(first), q = this->point(second);
    const Vector3 before = (p - from).cross(q - from), after = (p - to).cross(q - to);
    const double length = after.norm();
    turned = turned || before.dot(after) < CollapseCosine * before.norm() * length;
    area += length;
    aspect = std::max(aspect, aspectOf(to, p, q, length));
  }
  return ShapeWeight * area * (to - from).squaredNorm() * aspect +
    (aspect > std::max(this->Aspects[v], this->Aspects[u]) ? UnwantedCost : 0.0) +
    (turned ? TurnedOverCost : 0.0);
}

//------------------------------------------------------------------------------
QuadricCollapse::Choice QuadricCollapse::bestTarget(int v) const
{
  Choice best = { Infinity, -1 };
  const Ring& ring = this->Rings[v];
  if (ring.size() > TooManyNeighbors)
  {
    return best;
  }
  // The costs without shapes are lower bounds and cheap. Evaluate shapes in ascending sequence of
  // these bounds.
  std::array<Choice, TooManyNeighbors> choices;
  std::size_t count = 0;
  for (int u : ring)
  {
    const Vector3 to = this->point(u);
    const double error = this->Quadrics[v].at(to) + this->Quadrics[u].at(to);
    const std::size_t neighbors = this->Rings[u].size() + ring.size() - 4;
    choices[count++] = { std::max(error, 0.0) + (neighbors > MaximumNeighbors ? UnwantedCost : 0.0),
      u };
  }
  std::sort(choices.begin(), choices.begin() + count,
    [](const Choice& a, const Choice& b)
    { return a.Cost != b.Cost ? a.Cost < b.Cost : a.Target < b.Target; });
  for (std::size_t i = 0; i < count && choices[i].Cost < best.Cost; ++i)
  {
    const int u = choices[i].Target;
    if (this->Rings.canCollapse(v, u))
    {
      const double cost = choices[i].Cost + this->shapeCost(v, u);
      if (cost < best.Cost)
      {
        best = { cost, u };
      }
    }
  }
  return best;
}

//------------------------------------------------------------------------------
void QuadricCollapse::enqueue(int v)
{
  ++this->Stamps[v];
  const double cost = this->bestTarget(v).Cost;
  if (cost < Infinity)
  {
    this->Queue.push({ cost, v, this->Stamps[v] });
  }
}

//------------------------------------------------------------------------------
QuadricCollapse::Collapse QuadricCollapse::next()
{
  for (;;)
  {
    const Candidate candidate = this->Queue.top();
    this->Queue.pop();
    const int v = candidate.Vertex;
    if (candidate.Stamp != this->Stamps[v])
    {
      continue;
    }
    // Neighbors of the target are updated only here.
    const Choice choice = this->bestTarget(v);
    if (choice.Cost > candidate.Cost)
    {
      this->enqueue(v);
      continue;
    }
    Ring ring = this->Rings.collapse(v, choice.Target);
    ++this->Stamps[v];
    this->Aspects[choice.Target] = std::max(this->Aspects[choice.Target], this->Aspects[v]);
    Quadric& target = this->Quadrics[choice.Target];
    target.A += this->Quadrics[v].A;
    target.B += this->Quadrics[v].B;
    target.C += this->Quadrics[v].C;
    for (int id : ring)
    {
      this->enqueue(id);
    }
    return { v, std::move(ring) };
  }
}
}
