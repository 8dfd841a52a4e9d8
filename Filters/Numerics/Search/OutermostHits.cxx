#include "Search/OutermostHits.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
/// Intersect the part of a ray beyond hit.Distance with a triangle, and update the hit.
void update(RayHit& hit, const Points& points, const Triangles& triangles, int r,
  const Vector3& origin, const std::array<Vector3, 3>& axes)
{
  constexpr double tolerance = 1e-12; // for rays between two triangles by rounding
  std::array<Eigen::Vector2d, 3> flat;
  Vector3 along;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 p = points.row(triangles(r, k)).transpose() - origin;
    flat[k] = { p.dot(axes[0]), p.dot(axes[1]) };
    along[k] = p.dot(axes[2]);
  }
  Vector3 weights;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector2d &a = flat[next(k)], &b = flat[previous(k)];
    weights[k] = a[0] * b[1] - a[1] * b[0];
  }
  const double area = weights.sum();
  if (!(std::abs(area) > 0.0) || (weights / area).minCoeff() < -tolerance)
  {
    return;
  }
  weights = (weights / area).cwiseMax(0.0);
  weights /= weights.sum();
  if (weights.dot(along) > hit.Distance)
  {
    hit = { r, weights, weights.dot(along) };
  }
}

/// Return the largest distance along the ray inside of a box, or -1 if the ray misses the box. The
/// box is enlarged by rounding errors.
double exitOf(const Box& box, const Vector3& origin, const Vector3& direction)
{
  constexpr double margin = 1e-9;
  const double slack =
    margin * ((box.Upper - box.Lower).norm() + (box.Upper - origin).cwiseAbs().maxCoeff());
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = box.Lower[axis] - slack - origin[axis],
                 high = box.Upper[axis] + slack - origin[axis];
    if (direction[axis] == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return -1.0;
      }
      continue;
    }
    const double a = low / direction[axis], b = high / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? leave : -1.0;
}
}

//------------------------------------------------------------------------------
OutermostHits::OutermostHits(
  const Points& points, const conformal::Triangles& triangles, const Run& run)
  : Positions(points)
  , Triangles(triangles)
{
  std::vector<Box> boxes(triangles.rows());
  forBlocks(run, triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        for (int k = 0; k < 3; ++k)
        {
          boxes[r].extend(Vector3(points.row(triangles(r, k))));
        }
      }
    });
  this->Tree = buildBoxTree(boxes, run);
}

//------------------------------------------------------------------------------
RayHit OutermostHits::along(const Vector3& origin, const Vector3& direction) const
{
  RayHit best;
  if (this->Tree.Nodes.empty())
  {
    return best;
  }
  const Vector3 u = direction.unitOrthogonal();
  const std::array<Vector3, 3> axes{ u, direction.cross(u), direction };
  struct Entry
  {
    double Exit;
    int Node;
  };
  std::array<Entry, 128> stack; // the tree is balanced: its depth is the logarithm of its size
  int depth = 0;
  stack[depth++] = { exitOf(this->Tree.Nodes[0].Bounds, origin, direction), 0 };
  while (depth > 0)
  {
    const Entry entry = stack[--depth];
    if (entry.Exit < 0.0 || entry.Exit < best.Distance)
    {
      continue;
    }
    const BoxTree::Node& node = this->Tree.Nodes[entry.Node];
    if (node.Count > 0)
    {
      for (int i = node.First; i < node.First + node.Count; ++i)
      {
        update(best, this->Positions, this->Triangles, this->Tree.Items[i], origin, axes);
      }
      continue;
    }
    Entry far{ exitOf(this->Tree.Nodes[entry.Node + 1].Bounds, origin, direction), entry.Node + 1 };
    Entry near{ exitOf(this->Tree.Nodes[node.Second].Bounds, origin, direction), node.Second };
    if (far.Exit < near.Exit)
    {
      std::swap(far, near);
    }
    stack[depth++] = near;
    stack[depth++] = far;
  }
  return best;
}
}
