#include "Search/TriangleTree.h"

#include "Base/Steps.h"

#include <algorithm>
#include <array>
#include <utility>

namespace conformal
{
namespace
{
FootPoint footAt(const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c,
  const Vector3& barycentric)
{
  FootPoint foot;
  foot.Barycentric = barycentric;
  foot.Position = barycentric[0] * a + barycentric[1] * b + barycentric[2] * c;
  foot.SquareDistance = (x - foot.Position).squaredNorm();
  return foot;
}

// Compute the parameter in [0, 1] of the point of the segment from a to b closest to x.
double closestOnSegment(const Vector3& x, const Vector3& a, const Vector3& b)
{
  const double length2 = (b - a).squaredNorm();
  return length2 > 0.0 ? std::clamp((x - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
}
}

FootPoint closestPointOfTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  // Classify the Voronoi regions of the corners, the edges and the interior by the projections of x
  // on the edges.
  const Vector3 ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const double abx = ab.dot(ax), acx = ac.dot(ax);
  if (abx <= 0.0 && acx <= 0.0)
  {
    return footAt(x, a, b, c, Vector3(1, 0, 0));
  }
  const double abxb = ab.dot(bx), acxb = ac.dot(bx);
  if (abxb >= 0.0 && acxb <= abxb)
  {
    return footAt(x, a, b, c, Vector3(0, 1, 0));
  }
  const double abxc = ab.dot(cx), acxc = ac.dot(cx);
  if (acxc >= 0.0 && abxc <= acxc)
  {
    return footAt(x, a, b, c, Vector3(0, 0, 1));
  }
  // Twice the signed areas of the triangles of x with the edges opposite c, b and a, each times
  // twice the area of the triangle.
  const double areaC = abx * acxb - abxb * acx;
  if (areaC <= 0.0 && abx >= 0.0 && abxb <= 0.0 && abx - abxb > 0.0)
  {
    const double t = abx / (abx - abxb);
    return footAt(x, a, b, c, Vector3(1 - t, t, 0));
  }
  const double areaB = abxc * acx - abx * acxc;
  if (areaB <= 0.0 && acx >= 0.0 && acxc <= 0.0 && acx - acxc > 0.0)
  {
    const double t = acx / (acx - acxc);
    return footAt(x, a, b, c, Vector3(1 - t, 0, t));
  }
  const double areaA = abxb * acxc - abxc * acxb;
  const double fromB = acxb - abxb, fromC = abxc - acxc;
  if (areaA <= 0.0 && fromB >= 0.0 && fromC >= 0.0 && fromB + fromC > 0.0)
  {
    const double t = fromB / (fromB + fromC);
    return footAt(x, a, b, c, Vector3(0, 1 - t, t));
  }
  const double area = areaA + areaB + areaC;
  if (area > 0.0 && areaA >= 0.0 && areaB >= 0.0 && areaC >= 0.0)
  {
    const double u = areaB / area, v = areaC / area;
    return footAt(x, a, b, c, Vector3(1 - u - v, u, v));
  }
  // Rounding error in a sliver: the nearest edge is as close as the interior.
  const double s = closestOnSegment(x, a, b), t = closestOnSegment(x, b, c),
               u = closestOnSegment(x, c, a);
  const std::array<FootPoint, 3> feet = { footAt(x, a, b, c, Vector3(1 - s, s, 0)),
    footAt(x, a, b, c, Vector3(0, 1 - t, t)), footAt(x, a, b, c, Vector3(u, 0, 1 - u)) };
  return *std::min_element(feet.begin(), feet.end(),
    [](const FootPoint& p, const FootPoint& q) { return p.SquareDistance < q.SquareDistance; });
}

TriangleTree::TriangleTree(const Points& positions, const Triangles& triangles, const Run& run)
{
  Steps steps(run, { 0.06, 0.6, 0.14, 0.08, 0.12 });
  steps.next();
  std::vector<Box> boxes(triangles.rows());
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      boxes[r].extend(Vector3(positions.row(triangles(r, k))));
    }
  }
  BoxTree tree = buildBoxTree(boxes, steps.next());
  const Run joining = steps.next();
  if (triangles.rows() > 0)
  {
    this->addQuad(tree, 0, joining);
  }
  steps.next();
  this->Items.swap(tree.Items);
  this->Placed.resize(triangles.rows());
  this->PlaceOf.resize(triangles.rows());
  for (int place = 0; place < triangles.rows(); ++place)
  {
    this->PlaceOf[this->Items[place]] = place;
  }
  steps.next();
  this->refit(positions, triangles, run);
  run.report(1.0);
}

int TriangleTree::addQuad(const BoxTree& tree, int node, const Run& run)
{
  const int self = static_cast<int>(this->Quads.size());
  constexpr int chunk = 1 << 12;
  if (self % chunk == 0)
  {
    // Half of all nodes have children. A quad combines at most three of them.
    run.report(std::min(1.0, 4.0 * self / static_cast<double>(tree.Nodes.size())));
  }
  this->Quads.emplace_back();
  std::array<int, DoubleLanes> nodes;
  nodes.fill(-1);
  nodes[0] = node;
  for (int filled = 1, widened = 1; widened > 0 && filled < DoubleLanes;)
  {
    widened = 0;
    for (int i = filled; i-- > 0 && filled < DoubleLanes;)
    {
      const BoxTree::Node& inner = tree.Nodes[nodes[i]];
      if (inner.Count == 0)
      {
        nodes[filled++] = inner.Second;
        ++nodes[i]; // the first child is the next node
        ++widened;
      }
    }
  }
  for (int k = 0; k < DoubleLanes; ++k)
  {
    const bool used = nodes[k] >= 0;
    const BoxTree::Node leaf = used ? tree.Nodes[nodes[k]] : BoxTree::Node();
    const int next = used && leaf.Count == 0 ? this->addQuad(tree, nodes[k], run) : -1;
    this->Quads[self].Next[k] = next;
    this->Quads[self].First[k] = leaf.First;
    this->Quads[self].Count[k] = leaf.Count;
  }
  return self;
}

Box TriangleTree::boxOf(const Quad& quad, int lane) const
{
  Box box;
  for (int place = quad.First[lane]; place < quad.First[lane] + quad.Count[lane]; ++place)
  {
    box.extend(this->Placed[place].A);
    box.extend(this->Placed[place].B);
    box.extend(this->Placed[place].C);
  }
  for (int k = 0; quad.Next[lane] >= 0 && k < DoubleLanes; ++k)
  {
    const Quad& below = this->Quads[quad.Next[lane]];
    Box part;
    for (int c = 0; c < 3; ++c)
    {
      part.Lower[c] = below.Lower[c][k];
      part.Upper[c] = below.Upper[c][k];
    }
    box.extend(part);
  }
  return box;
}

void TriangleTree::refit(const Points& positions, const Triangles& triangles, const Run& run)
{
  const Index blockSize = 4096;
  forBlocks(run, static_cast<Index>(this->Placed.size()), blockSize,
    [&](Index begin, Index end)
    {
      for (Index place = begin; place < end; ++place)
      {
        const auto ids = triangles.row(this->Items[place]);
        this->Placed[place] = { positions.row(ids[0]), positions.row(ids[1]),
          positions.row(ids[2]) };
      }
    });
  for (auto quad = this->Quads.rbegin(); quad != this->Quads.rend(); ++quad)
  {
    for (int k = 0; k < DoubleLanes; ++k)
    {
      const Box box = this->boxOf(*quad, k);
      for (int c = 0; c < 3; ++c)
      {
        quad->Lower[c][k] = box.Lower[c];
        quad->Upper[c][k] = box.Upper[c];
      }
    }
  }
}

void TriangleTree::update(FootPoint& best, const Vector3& x, int place) const
{
  const Corners& corners = this->Placed[place];
  FootPoint foot = closestPointOfTriangle(x, corners.A, corners.B, corners.C);
  foot.Triangle = this->Items[place];
  if (foot.SquareDistance < best.SquareDistance ||
    (foot.SquareDistance == best.SquareDistance && foot.Triangle < best.Triangle))
  {
    best = foot;
  }
}

// Compute the square distances of x from the four boxes of a quad. The axes are written out, since
// compilers keep the sum of a loop in memory.
inline void TriangleTree::measure(const Quad& quad, const double* x, double* distances)
{
  const Doubles zero = {};
  const auto square = [&](int axis, Doubles& result)
  {
    const Doubles below = quad.Lower[axis] - x[axis], above = x[axis] - quad.Upper[axis];
    const Doubles outside = below > above ? below : above;
    const Doubles length = outside > zero ? outside : zero;
    result = length * length;
  };
  Doubles x2, y2, z2;
  square(0, x2);
  square(1, y2);
  square(2, z2);
  const Doubles sum = x2 + y2 + z2;
  for (int k = 0; k < DoubleLanes; ++k)
  {
    distances[k] = sum[k];
  }
}

// The loops over lanes are inlined into both clones.
__attribute__((target_clones("avx2", "default"))) FootPoint TriangleTree::closestPoint(
  const Vector3& x, int hint) const
{
  FootPoint best;
  if (this->Quads.empty())
  {
    return best;
  }
  if (hint >= 0)
  {
    this->update(best, x, this->PlaceOf[hint]);
  }
  struct Waiting
  {
    double SquareDistance;
    int Quad;         ///< -1 for a leaf
    int First, Count; ///< range of positions in Items
  };
  // At most three quads per level are on the stack. The depth of the tree is at most half the
  // number of bits of an int.
  std::array<Waiting, 3 * 32> stack;
  int depth = 0;
  stack[depth++] = { 0.0, 0, 0, 0 };
  while (depth > 0)
  {
    const Waiting next = stack[--depth];
    if (next.SquareDistance > best.SquareDistance)
    {
      continue;
    }
    if (next.Quad < 0)
    {
      for (int place = next.First; place < next.First + next.Count; ++place)
      {
        this->update(best, x, place);
      }
      continue;
    }
    const Quad& quad = this->Quads[next.Quad];
    double distances[DoubleLanes];
    measure(quad, x.data(), distances);
    // Unused boxes have an infinite distance, and no triangles. Bits of lanes avoid branches that
    // cannot be predicted.
    unsigned int lanes = 0;
    for (int k = 0; k < DoubleLanes; ++k)
    {
      lanes |= static_cast<unsigned int>(distances[k] <= best.SquareDistance) << k;
    }
    // Insert boxes sorted by distance, so that the closest one is visited first.
    const int bottom = depth;
    for (; lanes != 0; lanes &= lanes - 1)
    {
      const int k = __builtin_ctz(lanes);
      if (quad.Next[k] >= 0 || quad.Count[k] > 0)
      {
        int at = depth++;
        for (; at > bottom && stack[at - 1].SquareDistance < distances[k]; --at)
        {
          stack[at] = stack[at - 1];
        }
        stack[at] = { distances[k], quad.Next[k], quad.First[k], quad.Count[k] };
      }
    }
  }
  return best;
}
}
