#include "SphereLocator.h"

#include "TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace conformal
{
SphereLocator::SphereLocator(const Points& positions, const Triangles& faces)
{
  // A point p = p'/|p'| of the sphere lies 1 - |p'| above its flat triangle, and
  // |p'|^2 = 1 - sum l_i l_j |n_i - n_j|^2 >= 1 - (longest edge)^2 / 3.
  const double rounding = 1e-14;
  std::vector<Box> boxes(faces.rows());
  for (Index r = 0; r < faces.rows(); ++r)
  {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 from = positions.row(faces(r, k)), to = positions.row(faces(r, (k + 1) % 3));
      boxes[r].extend(from);
      longest = std::max(longest, (to - from).squaredNorm());
    }
    const double rise = 1.0 - std::sqrt(std::max(0.0, 1.0 - longest / 3.0)) + rounding;
    boxes[r].Lower.array() -= rise;
    boxes[r].Upper.array() += rise;
  }
  this->Tree = buildBoxTree(boxes);
  this->Placed.resize(faces.rows());
  for (Index place = 0; place < faces.rows(); ++place)
  {
    const auto ids = faces.row(this->Tree.Items[place]);
    for (int k = 0; k < 3; ++k)
    {
      this->Placed[place].Positions[k] = positions.row(ids[k]);
      this->Placed[place].Ascending[k] = ids[(k + 1) % 3] < ids[(k + 2) % 3];
    }
  }
}

// Entry k is the volume spanned by the direction and the edge opposite to corner k, positive
// inside. det(a, b, d) = det(a - d, b - d, d), whose differences are exact for small triangles.
Vector3 SphereLocator::sides(const Corners& corners, const Vector3& direction)
{
  const std::array<Vector3, 3> from{ corners.Positions[0] - direction,
    corners.Positions[1] - direction, corners.Positions[2] - direction };
  Vector3 volumes;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 &a = from[(k + 1) % 3], &b = from[(k + 2) % 3];
    volumes[k] = corners.Ascending[k] ? a.cross(b).dot(direction) : -(b.cross(a).dot(direction));
  }
  return volumes;
}

SphereLocation SphereLocator::locate(const Vector3& direction) const
{
  SphereLocation location;
  Vector3 volumes = Vector3::Zero();
  int best = -1;
  double leastMiss = -std::numeric_limits<double>::infinity(); // 0 means inside
  std::array<int, 64> stack; // the depth is the logarithm of an int
  int depth = 0;
  if (!this->Tree.Nodes.empty())
  {
    stack[depth++] = 0;
  }
  while (depth > 0)
  {
    const int index = stack[--depth];
    const BoxTree::Node& node = this->Tree.Nodes[index];
    if ((direction.array() < node.Bounds.Lower.array()).any() ||
      (direction.array() > node.Bounds.Upper.array()).any())
    {
      continue;
    }
    if (node.Count == 0)
    {
      stack[depth++] = node.Second;
      stack[depth++] = index + 1;
      continue;
    }
    for (int place = node.First; place < node.First + node.Count; ++place)
    {
      const Vector3 candidate = sides(this->Placed[place], direction);
      const double smallest = candidate.minCoeff();
      const double miss = smallest >= 0.0 ? 0.0 : smallest / candidate.cwiseAbs().sum();
      const int triangle = this->Tree.Items[place];
      if (miss > leastMiss || (miss == leastMiss && triangle < location.Triangle))
      {
        leastMiss = miss;
        location.Triangle = triangle;
        volumes = candidate;
        best = place;
      }
    }
  }
  if (best < 0)
  {
    return location;
  }
  location.Barycentric = volumes.cwiseMax(0.0);
  const double sum = location.Barycentric.sum();
  if (sum > 0.0)
  {
    location.Barycentric /= sum;
  }
  else // a triangle without area
  {
    const Corners& corners = this->Placed[best];
    location.Barycentric = closestPointOfTriangle(
      direction, corners.Positions[0], corners.Positions[1], corners.Positions[2])
                             .Barycentric;
  }
  return location;
}
}
