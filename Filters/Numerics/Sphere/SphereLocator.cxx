#include "Sphere/SphereLocator.h"

#include "Base/Steps.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace conformal
{
SphereLocator::SphereLocator(const Points& positions, const Triangles& triangles, const Run& run)
  : SphereLocator(positions, triangles, triangleNeighbors(triangles, positions.rows(), run), run)
{
}

SphereLocator::SphereLocator(
  const Points& positions, const Triangles& triangles, const Triangles& neighbors, const Run& run)
{
  Steps steps(run, { 0.09, 0.73, 0.03, 0.15 });
  // A point p = p'/|p'| of the sphere lies 1 - |p'| above its flat triangle, where |p'|^2 = 1 - sum
  // l_i l_j |n_i - n_j|^2 >= 1 - (longest edge)^2 / 3.
  const double rounding = 1e-14;
  std::vector<Box> boxes(triangles.rows());
  const Index blockSize = 1024;
  forBlocksReporting(steps.next(), triangles.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        double longest = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          const Vector3 from = positions.row(triangles(r, k)),
                        to = positions.row(triangles(r, next(k)));
          boxes[r].extend(from);
          longest = std::max(longest, (to - from).squaredNorm());
        }
        const double rise = 1.0 - std::sqrt(std::max(0.0, 1.0 - longest / 3.0)) + rounding;
        boxes[r].Lower.array() -= rise;
        boxes[r].Upper.array() += rise;
      }
    });
  this->Tree = buildBoxTree(boxes, steps.next());
  steps.next();
  this->Placed.resize(triangles.rows());
  this->PlaceOf.resize(triangles.rows());
  for (int place = 0; place < triangles.rows(); ++place)
  {
    this->PlaceOf[this->Tree.Items[place]] = place;
  }
  forBlocksReporting(steps.next(), triangles.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index place = begin; place < end; ++place)
      {
        const int triangle = this->Tree.Items[place];
        const auto ids = triangles.row(triangle);
        for (int k = 0; k < 3; ++k)
        {
          const int neighbor = neighbors(triangle, next(k));
          this->Placed[place].Positions[k] = positions.row(ids[k]);
          this->Placed[place].Across[k] = neighbor < 0 ? -1 : this->PlaceOf[neighbor];
          this->Placed[place].Ascending[k] = ids[next(k)] < ids[previous(k)];
        }
      }
    });
}

// Compute the volume spanned by the direction and the edge opposite to a corner, positive inside.
// det(a, b, d) = det(a - d, b - d, d); the differences are exact for small triangles.
double SphereLocator::side(const Corners& corners, int opposite, const Vector3& direction)
{
  const Vector3 a = corners.Positions[next(opposite)] - direction,
                b = corners.Positions[previous(opposite)] - direction;
  return corners.Ascending[opposite] ? a.cross(b).dot(direction) : -b.cross(a).dot(direction);
}

// Visit the positions in Tree.Items of all triangles that may contain a direction.
template <typename Visit>
void SphereLocator::visitNear(const Vector3& direction, Visit visit) const
{
  std::array<int, 64> stack; // the depth is logarithmic in an int
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

Vector3 SphereLocator::sidesOf(const Corners& corners, const Vector3& direction)
{
  return { side(corners, 0, direction), side(corners, 1, direction), side(corners, 2, direction) };
}

// Walk from triangle to triangle towards the direction. Return the position of the unique triangle
// that contains it inside. Return -1 after a few steps, or if the direction lies on an edge.
int SphereLocator::walk(int place, const Vector3& direction, Vector3& sides) const
{
  const int farthest = 4;
  for (int step = 0; step < farthest && place >= 0; ++step)
  {
    sides = sidesOf(this->Placed[place], direction);
    int k = 0;
    if (sides.minCoeff(&k) > 0.0)
    {
      return place;
    }
    place = sides[k] < 0.0 ? this->Placed[place].Across[k] : -1;
  }
  return -1;
}

int SphereLocator::search(const Vector3& direction, Vector3& sides) const
{
  int best = -1;
  this->visitNear(direction,
    [&](int place)
    {
      const Vector3 itsSides = sidesOf(this->Placed[place], direction);
      if (itsSides.minCoeff() >= 0.0 &&
        (best < 0 || this->Tree.Items[place] < this->Tree.Items[best]))
      {
        best = place;
        sides = itsSides;
      }
    });
  if (best >= 0)
  {
    return best;
  }
  double minimumMiss = std::numeric_limits<double>::infinity();
  this->visitNear(direction,
    [&](int place)
    {
      const Vector3 itsSides = sidesOf(this->Placed[place], direction);
      const double miss = -itsSides.minCoeff() / itsSides.cwiseAbs().sum();
      if (miss < minimumMiss ||
        (miss == minimumMiss && this->Tree.Items[place] < this->Tree.Items[best]))
      {
        minimumMiss = miss;
        best = place;
        sides = itsSides;
      }
    });
  return best;
}

SphereLocation SphereLocator::locate(const Vector3& direction, int hint) const
{
  SphereLocation location;
  Vector3 sides = Vector3::Zero();
  int best = hint < 0 ? -1 : this->walk(this->PlaceOf[hint], direction, sides);
  if (best < 0)
  {
    best = this->search(direction, sides);
  }
  if (best < 0)
  {
    return location;
  }
  location.Triangle = this->Tree.Items[best];
  location.Barycentric = sides.cwiseMax(0.0);
  const double sum = location.Barycentric.sum();
  if (sum > 0.0)
  {
    location.Barycentric /= sum;
  }
  else // triangle without area
  {
    const Corners& corners = this->Placed[best];
    location.Barycentric = closestPointOfTriangle(
      direction, corners.Positions[0], corners.Positions[1], corners.Positions[2])
                             .Barycentric;
  }
  return location;
}
}
