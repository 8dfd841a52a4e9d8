#include "TriangleTree.h"

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

// Parameter in [0, 1] of the point of the segment from a to b closest to x.
double closestOnSegment(const Vector3& x, const Vector3& a, const Vector3& b)
{
  const double length2 = (b - a).squaredNorm();
  return length2 > 0.0 ? std::clamp((x - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
}
}

FootPoint closestPointOfTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c)
{
  // Voronoi regions of the corners, the edges and the inside, told apart by the projections of x
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
  // Twice the signed areas opposite c, b and a, times the triangle's.
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
  // Rounding in a sliver: the nearest of its edges is as good as its inside.
  const double s = closestOnSegment(x, a, b), t = closestOnSegment(x, b, c),
               u = closestOnSegment(x, c, a);
  const std::array<FootPoint, 3> feet = { footAt(x, a, b, c, Vector3(1 - s, s, 0)),
    footAt(x, a, b, c, Vector3(0, 1 - t, t)), footAt(x, a, b, c, Vector3(u, 0, 1 - u)) };
  return *std::min_element(feet.begin(), feet.end(),
    [](const FootPoint& p, const FootPoint& q) { return p.SquareDistance < q.SquareDistance; });
}

TriangleTree::TriangleTree(const Points& positions, const Triangles& faces)
  : Faces(faces)
{
  std::vector<Box> boxes(faces.rows());
  for (Index r = 0; r < faces.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      boxes[r].extend(Vector3(positions.row(faces(r, k))));
    }
  }
  this->Tree = buildBoxTree(boxes);
  this->Placed.resize(faces.rows());
  this->PlaceOf.resize(faces.rows());
  for (int place = 0; place < faces.rows(); ++place)
  {
    this->PlaceOf[this->Tree.Items[place]] = place;
  }
  this->refit(positions);
}

void TriangleTree::refit(const Points& positions)
{
  refitBoxTree(this->Tree,
    [&](int place)
    {
      const auto ids = this->Faces.row(this->Tree.Items[place]);
      this->Placed[place] = { positions.row(ids[0]), positions.row(ids[1]), positions.row(ids[2]) };
      Box box;
      box.extend(this->Placed[place].A);
      box.extend(this->Placed[place].B);
      box.extend(this->Placed[place].C);
      return box;
    });
}

void TriangleTree::update(FootPoint& best, const Vector3& x, int place) const
{
  const Corners& corners = this->Placed[place];
  FootPoint foot = closestPointOfTriangle(x, corners.A, corners.B, corners.C);
  foot.Triangle = this->Tree.Items[place];
  if (foot.SquareDistance < best.SquareDistance ||
    (foot.SquareDistance == best.SquareDistance && foot.Triangle < best.Triangle))
  {
    best = foot;
  }
}

FootPoint TriangleTree::closestPoint(const Vector3& x, int hint) const
{
  FootPoint best;
  if (this->Tree.Nodes.empty())
  {
    return best;
  }
  if (hint >= 0)
  {
    this->update(best, x, this->PlaceOf[hint]);
  }
  // The depth is the logarithm of an int, so the stack cannot overflow.
  std::array<std::pair<int, double>, 64> stack;
  int depth = 0;
  stack[depth++] = { 0, 0.0 };
  while (depth > 0)
  {
    const auto [index, distance] = stack[--depth];
    if (distance > best.SquareDistance)
    {
      continue;
    }
    const BoxTree::Node& node = this->Tree.Nodes[index];
    if (node.Count > 0)
    {
      for (int place = node.First; place < node.First + node.Count; ++place)
      {
        this->update(best, x, place);
      }
      continue;
    }
    const int near = index + 1, far = node.Second;
    const double nearDistance = this->Tree.Nodes[near].Bounds.squareDistance(x);
    const double farDistance = this->Tree.Nodes[far].Bounds.squareDistance(x);
    if (nearDistance <= farDistance)
    {
      stack[depth++] = { far, farDistance };
      stack[depth++] = { near, nearDistance };
    }
    else
    {
      stack[depth++] = { near, nearDistance };
      stack[depth++] = { far, farDistance };
    }
  }
  return best;
}
}
