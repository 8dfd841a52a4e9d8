#include "Search/TriangleTree.h"

#include "Base/Steps.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace conformal
{
namespace
{
// Square distances in the tree's frame are floats, which are rounded: margins make them lower
// bounds. Farther points are moved to the cube of this size, since floats would overflow.
constexpr double Slack = 0x1p-22, Larger = 1.0 + 0x1p-20, Smallest = 1e-30, Farthest = 1e15;
constexpr double Largest = 1e38; // square distance that is less than that of unused boxes

using Mask = int __attribute__((vector_size(32), aligned(4)));

/// Point of a triangle with given barycentric coordinates
Vector3 pointAt(const Vector3& barycentric, const Vector3& a, const Vector3& b, const Vector3& c)
{
  return barycentric[0] * a + barycentric[1] * b + barycentric[2] * c;
}

// Compute the parameter in [0, 1] of the point of the segment from a to b closest to x.
double closestOnSegment(const Vector3& x, const Vector3& a, const Vector3& b)
{
  const double length2 = (b - a).squaredNorm();
  return length2 > 0.0 ? std::clamp((x - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
}

/// Compute the barycentric coordinates of the point of a triangle's edges that is closest to x.
Vector3 closestOnEdges(const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double s = closestOnSegment(x, a, b), t = closestOnSegment(x, b, c),
               u = closestOnSegment(x, c, a);
  const std::array<Vector3, 3> feet = { Vector3(1 - s, s, 0), Vector3(0, 1 - t, t),
    Vector3(u, 0, 1 - u) };
  const auto distance = [&](const Vector3& foot)
  { return (x - pointAt(foot, a, b, c)).squaredNorm(); };
  return *std::min_element(feet.begin(), feet.end(),
    [&](const Vector3& p, const Vector3& q) { return distance(p) < distance(q); });
}

/// Compute the barycentric coordinates of the point of a triangle that is closest to x.
inline Vector3 closestBarycentric(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  // Classify the Voronoi regions of the corners, the edges and the interior by the projections of x
  // on the edges.
  const Vector3 ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const double abx = ab.dot(ax), acx = ac.dot(ax);
  if (abx <= 0.0 && acx <= 0.0)
  {
    return { 1, 0, 0 };
  }
  const double abxb = ab.dot(bx), acxb = ac.dot(bx);
  if (abxb >= 0.0 && acxb <= abxb)
  {
    return { 0, 1, 0 };
  }
  const double abxc = ab.dot(cx), acxc = ac.dot(cx);
  if (acxc >= 0.0 && abxc <= acxc)
  {
    return { 0, 0, 1 };
  }
  // Twice the signed areas of the triangles of x with the edges opposite c, b and a, each times
  // twice the area of the triangle.
  const double areaC = abx * acxb - abxb * acx;
  if (areaC <= 0.0 && abx >= 0.0 && abxb <= 0.0 && abx - abxb > 0.0)
  {
    const double t = abx / (abx - abxb);
    return { 1 - t, t, 0 };
  }
  const double areaB = abxc * acx - abx * acxc;
  if (areaB <= 0.0 && acx >= 0.0 && acxc <= 0.0 && acx - acxc > 0.0)
  {
    const double t = acx / (acx - acxc);
    return { 1 - t, 0, t };
  }
  const double areaA = abxb * acxc - abxc * acxb;
  const double fromB = acxb - abxb, fromC = abxc - acxc;
  if (areaA <= 0.0 && fromB >= 0.0 && fromC >= 0.0 && fromB + fromC > 0.0)
  {
    const double t = fromB / (fromB + fromC);
    return { 0, 1 - t, t };
  }
  const double area = areaA + areaB + areaC;
  if (area > 0.0 && areaA >= 0.0 && areaB >= 0.0 && areaC >= 0.0)
  {
    const double u = areaB / area, v = areaC / area;
    return { 1 - u - v, u, v };
  }
  // Rounding error in a sliver: the nearest edge is as close as the interior.
  return closestOnEdges(x, a, b, c);
}

// A leaf has a negative code, with the place of its first triangle and their number, 0, 1 or 2.
int leafCode(int first, int count)
{
  return ~(3 * first + count);
}
int firstOf(int code)
{
  return code < 0 ? ~code / 3 : 0;
}
int countOf(int code)
{
  return code < 0 ? ~code % 3 : 0;
}

/// Bits of the lanes of a mask whose elements are 0 or -1
unsigned int bitsOf(const Mask& mask)
{
  const Mask bits = mask & Mask{ 1, 2, 4, 8, 16, 32, 64, 128 };
  std::array<std::uint64_t, 4> pairs;
  std::memcpy(pairs.data(), &bits, sizeof(bits));
  const std::uint64_t pair = pairs[0] | pairs[1] | pairs[2] | pairs[3];
  return static_cast<unsigned int>(pair | pair >> 32U);
}
}

struct TriangleTree::Branch
{
  int Node, First, Count;
};

FootPoint closestPointOfTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  FootPoint foot;
  foot.Barycentric = closestBarycentric(x, a, b, c);
  foot.Position = pointAt(foot.Barycentric, a, b, c);
  foot.SquareDistance = (x - foot.Position).squaredNorm();
  return foot;
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
    this->addNode(tree, 0, joining);
  }
  steps.next();
  this->Items.swap(tree.Items);
  this->Corners.resize(triangles.rows(), 3);
  this->PlaceOf.resize(triangles.rows());
  for (int place = 0; place < triangles.rows(); ++place)
  {
    this->Corners.row(place) = triangles.row(this->Items[place]);
    this->PlaceOf[this->Items[place]] = place;
  }
  steps.next();
  this->refit(positions, run);
  run.report(1.0);
}

TriangleTree::Branch TriangleTree::branchAt(const BoxTree& tree, int node)
{
  const BoxTree::Node& own = tree.Nodes[node];
  return { own.Count > 0 ? -1 : node, own.First, own.Count };
}

int TriangleTree::addNode(const BoxTree& tree, int node, const Run& run)
{
  const int self = static_cast<int>(this->Nodes.size());
  constexpr int chunk = 1 << 12;
  if (self % chunk == 0)
  {
    // Half of all nodes have children. A node here combines at most seven of them.
    run.report(std::min(1.0, 8.0 * self / static_cast<double>(tree.Nodes.size())));
  }
  this->Nodes.emplace_back();
  // Branches of the binary tree: nodes, or ranges of items of a divided leaf
  std::array<Branch, FloatLanes> branches;
  branches[0] = branchAt(tree, node);
  int filled = 1;
  for (int widened = 1; widened > 0 && filled < FloatLanes;)
  {
    widened = 0;
    for (int i = filled; i-- > 0 && filled < FloatLanes;)
    {
      Branch& branch = branches[i];
      if (branch.Node >= 0)
      {
        branches[filled++] = branchAt(tree, tree.Nodes[branch.Node].Second);
        branch = branchAt(tree, branch.Node + 1); // the first child is the next node
        ++widened;
      }
      else if (branch.Count > 1)
      {
        branches[filled++] = { -1, branch.First + 1, branch.Count - 1 };
        branch.Count = 1;
        ++widened;
      }
    }
  }
  for (int k = 0; k < FloatLanes; ++k)
  {
    const Branch& branch = branches[k];
    const int code = k >= filled ? leafCode(0, 0)
      : branch.Node >= 0         ? this->addNode(tree, branch.Node, run)
                                 : leafCode(branch.First, branch.Count);
    this->Nodes[self].Code[k] = code;
  }
  return self;
}

void TriangleTree::refit(const Points& positions, const Run& run)
{
  this->Positions = positions;
  Box all;
  for (Index i = 0; i < positions.rows(); ++i)
  {
    all.extend(Vector3(positions.row(i)));
  }
  this->Center = 0.5 * all.Lower + 0.5 * all.Upper;
  const double half = (0.5 * all.Upper - 0.5 * all.Lower).maxCoeff();
  constexpr double smallest = 1e-300;
  this->Scale = half > smallest ? 1.0 / half : 1.0;

  constexpr Index blockSize = 256;
  forBlocks(run, static_cast<Index>(this->Nodes.size()), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        this->refitLeaves(this->Nodes[i]);
      }
    });
  std::for_each(
    this->Nodes.rbegin(), this->Nodes.rend(), [&](Node& node) { this->joinBoxes(node); });
}

void TriangleTree::refitLeaves(Node& node) const
{
  for (int lane = 0; lane < FloatLanes; ++lane)
  {
    Box box;
    const int first = firstOf(node.Code[lane]), last = first + countOf(node.Code[lane]);
    for (int place = first; place < last; ++place)
    {
      for (int k = 0; k < 3; ++k)
      {
        box.extend(Vector3(this->Positions.row(this->Corners(place, k))));
      }
    }
    const Vector3 lower = this->inFrame(box.Lower), upper = this->inFrame(box.Upper);
    for (int c = 0; c < 3; ++c)
    {
      node.Lower[c][lane] = static_cast<float>(lower[c]);
      node.Upper[c][lane] = static_cast<float>(upper[c]);
    }
  }
}

void TriangleTree::joinBoxes(Node& node) const
{
  for (int lane = 0; lane < FloatLanes; ++lane)
  {
    if (node.Code[lane] < 0)
    {
      continue;
    }
    const Node& below = this->Nodes[node.Code[lane]];
    for (int c = 0; c < 3; ++c)
    {
      float lower = below.Lower[c][0], upper = below.Upper[c][0];
      for (int k = 1; k < FloatLanes; ++k)
      {
        lower = std::min(lower, below.Lower[c][k]);
        upper = std::max(upper, below.Upper[c][k]);
      }
      node.Lower[c][lane] = lower;
      node.Upper[c][lane] = upper;
    }
  }
}

inline void TriangleTree::update(FootPoint& best, const Vector3& x, int place) const
{
  const Vector3 a = this->Positions.row(this->Corners(place, 0)),
                b = this->Positions.row(this->Corners(place, 1)),
                c = this->Positions.row(this->Corners(place, 2));
  const Vector3 barycentric = closestBarycentric(x, a, b, c),
                position = pointAt(barycentric, a, b, c);
  const double square = (x - position).squaredNorm();
  const int triangle = this->Items[place];
  if (square < best.SquareDistance || (square == best.SquareDistance && triangle < best.Triangle))
  {
    best = { triangle, barycentric, position, square };
  }
}

// The loops over lanes are inlined into both clones.
// Compile clones only with GCC and the GNU C library. Clang 14 compiles them, but other files
// cannot link to them.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
__attribute__((target_clones("avx2", "default")))
#endif
FootPoint
TriangleTree::closestPoint(const Vector3& x, int hint) const
{
  FootPoint best;
  if (this->Nodes.empty())
  {
    return best;
  }
  // Distances in the frame are lower bounds: the query point is replaced by a box of the size of
  // the rounding errors, and the square distance so far is enlarged.
  float limit = 0.0F;
  const auto setLimit = [&]()
  {
    const double square = best.SquareDistance * this->Scale * this->Scale;
    limit = static_cast<float>(std::min(square * Larger + Smallest, Largest));
  };
  if (hint >= 0)
  {
    this->update(best, x, this->PlaceOf[hint]);
  }
  setLimit();
  const Vector3 place = this->inFrame(x).cwiseMax(-Farthest).cwiseMin(Farthest);
  const double slack = Slack * std::max(1.0, place.cwiseAbs().maxCoeff());
  float low[3], high[3];
  for (int c = 0; c < 3; ++c)
  {
    low[c] = static_cast<float>(place[c] - slack);
    high[c] = static_cast<float>(place[c] + slack);
  }
  struct Waiting
  {
    float SquareDistance;
    int Code; // of Node
  };
  // At most seven nodes per level are on the stack. The depth of the tree is at most a third of the
  // number of bits of an int.
  std::array<Waiting, 7 * 11 + 1> stack;
  int depth = 0;
  stack[depth++] = { 0.0F, 0 };
  while (depth > 0)
  {
    const Waiting next = stack[--depth];
    if (next.SquareDistance > limit)
    {
      continue;
    }
    if (next.Code < 0)
    {
      const int first = firstOf(next.Code), last = first + countOf(next.Code);
      for (int i = first; i < last; ++i)
      {
        this->update(best, x, i);
      }
      setLimit();
      continue;
    }
    const Node& node = this->Nodes[next.Code];
    const Floats zero = {};
    // The axes are written out, since compilers keep the sum of a loop in memory.
    const auto addSquare = [&](int axis, Floats& sum)
    {
      const Floats below = node.Lower[axis] - high[axis], above = low[axis] - node.Upper[axis];
      const Floats outside = below > above ? below : above;
      const Floats length = outside > zero ? outside : zero;
      sum += length * length;
    };
    Floats distances = {};
    addSquare(0, distances);
    addSquare(1, distances);
    addSquare(2, distances);
    // Unused boxes have an infinite distance. Bits of lanes avoid branches that cannot be
    // predicted. Insert boxes sorted by distance, so that the closest is visited first.
    const int bottom = depth;
    for (unsigned int lanes = bitsOf(distances <= limit); lanes != 0; lanes &= lanes - 1)
    {
      const int k = __builtin_ctz(lanes);
      int at = depth++;
      for (; at > bottom && stack[at - 1].SquareDistance < distances[k]; --at)
      {
        stack[at] = stack[at - 1];
      }
      stack[at] = { distances[k], node.Code[k] };
    }
  }
  return best;
}
}
