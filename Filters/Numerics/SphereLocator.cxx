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

// The volume spanned by the direction and the edge opposite to a corner, positive inside.
// det(a, b, d) = det(a - d, b - d, d), whose differences are exact for small triangles.
double SphereLocator::side(const Corners& corners, int opposite, const Vector3& direction)
{
  const Vector3 a = corners.Positions[(opposite + 1) % 3] - direction,
                b = corners.Positions[(opposite + 2) % 3] - direction;
  return corners.Ascending[opposite] ? a.cross(b).dot(direction) : -b.cross(a).dot(direction);
}

// Visit the places of all triangles that may hold a direction.
template <typename Visit>
void SphereLocator::visitNear(const Vector3& direction, Visit visit) const
{
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
    }
    for (int place = node.First; place < node.First + node.Count; ++place)
    {
      visit(place);
    }
  }
}

SphereLocation SphereLocator::locate(const Vector3& direction) const
{
  SphereLocation location;
  Vector3 sides = Vector3::Zero();
  int best = -1;
  const auto take = [&](int place, const Vector3& itsSides)
  {
    best = place;
    sides = itsSides;
    location.Triangle = this->Tree.Items[place];
  };
  this->visitNear(direction,
    [&](int place)
    {
      Vector3 itsSides;
      for (int k = 0; k < 3; ++k)
      {
        itsSides[k] = side(this->Placed[place], k, direction);
        if (!(itsSides[k] >= 0.0))
        {
          return;
        }
      }
      if (best < 0 || this->Tree.Items[place] < location.Triangle)
      {
        take(place, itsSides);
      }
    });
  if (best < 0)
  {
    double leastMiss = std::numeric_limits<double>::infinity();
    this->visitNear(direction,
      [&](int place)
      {
        Vector3 itsSides;
        for (int k = 0; k < 3; ++k)
        {
          itsSides[k] = side(this->Placed[place], k, direction);
        }
        const double miss = -itsSides.minCoeff() / itsSides.cwiseAbs().sum();
        if (miss < leastMiss || (miss == leastMiss && this->Tree.Items[place] < location.Triangle))
        {
          leastMiss = miss;
          take(place, itsSides);
        }
      });
  }
  if (best < 0)
  {
    return location;
  }
  location.Barycentric = sides.cwiseMax(0.0);
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
