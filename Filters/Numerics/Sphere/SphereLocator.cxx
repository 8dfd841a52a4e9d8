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
namespace
{
constexpr double Rounding = 1e-14;

// A point p = p'/|p'| of the sphere lies 1 - |p'| above its flat triangle, where |p'|^2 = 1 - sum
// l_i l_j |n_i - n_j|^2 >= 1 - (longest edge)^2 / 3. Return the least |p'|.
double leastRadius(double squareOfLongestEdge)
{
  return std::sqrt(std::max(0.0, 1.0 - squareOfLongestEdge / 3.0));
}
}

SphereLocator::SphereLocator(const Points& positions, const Triangles& triangles, const Run& run)
  : SphereLocator(positions, triangles, triangleNeighbors(triangles, positions.rows(), run), run)
{
}

SphereLocator::SphereLocator(
  const Points& positions, const Triangles& triangles, const Triangles& neighbors, const Run& run)
{
  Steps steps(run, { 0.09, 0.73, 0.03, 0.15 });
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
        const double rise = 1.0 - leastRadius(longest) + Rounding;
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
  this->orderNodes();
}

// Find the lowest triangle of each node, and slabs around those that are narrow. Children come
// after their node.
void SphereLocator::orderNodes()
{
  const int size = static_cast<int>(this->Tree.Nodes.size());
  this->LowestOf.resize(size);
  this->SlabOf.assign(size, -1);
  std::vector<int> firsts(size), ends(size); // range in Tree.Items of each node
  for (int i = size - 1; i >= 0; --i)
  {
    const BoxTree::Node& node = this->Tree.Nodes[i];
    if (node.Count > 0)
    {
      firsts[i] = node.First;
      ends[i] = node.First + node.Count;
      this->LowestOf[i] =
        *std::min_element(this->Tree.Items.begin() + firsts[i], this->Tree.Items.begin() + ends[i]);
      Vector3 normal = Vector3::Zero();
      double longest = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const Vector3 &a = this->Placed[node.First].Positions[k],
                      &b = this->Placed[node.First].Positions[next(k)];
        if ((b - a).squaredNorm() > longest)
        {
          longest = (b - a).squaredNorm();
          normal = a.cross(b - a);
        }
      }
      this->addSlab(i, firsts[i], ends[i], normal);
      continue;
    }
    const int first = i + 1, second = node.Second;
    firsts[i] = firsts[first];
    ends[i] = ends[second];
    this->LowestOf[i] = std::min(this->LowestOf[first], this->LowestOf[second]);
    if (this->SlabOf[first] >= 0 && this->SlabOf[second] >= 0)
    {
      const Vector3 &a = this->Slabs[this->SlabOf[first]].Normal,
                    &b = this->Slabs[this->SlabOf[second]].Normal;
      this->addSlab(i, firsts[i], ends[i], a.dot(b) < 0.0 ? Vector3(a - b) : Vector3(a + b));
    }
  }
}

// Add a slab with this normal to a node, if it is much thinner than the triangles are long. Planes
// parallel to it through the corners contain the flat triangles; above these, distances grow with
// the radius.
void SphereLocator::addSlab(int node, int first, int end, const Vector3& normal)
{
  constexpr double narrow = 0.25, tiny = 1e-150;
  Slab slab;
  const double length = normal.norm();
  if (length < tiny)
  {
    return;
  }
  slab.Normal = normal / length;
  double longest = 0.0;
  slab.Lower = std::numeric_limits<double>::infinity();
  slab.Upper = -slab.Lower;
  for (int place = first; place < end; ++place)
  {
    const auto& corners = this->Placed[place].Positions;
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest, (corners[next(k)] - corners[k]).squaredNorm());
      const double distance = slab.Normal.dot(corners[k]);
      slab.Lower = std::min(slab.Lower, distance);
      slab.Upper = std::max(slab.Upper, distance);
    }
  }
  const double radius = leastRadius(longest);
  if (!(slab.Upper - slab.Lower < narrow * radius * std::sqrt(longest)))
  {
    return;
  }
  slab.Lower = std::min(slab.Lower, slab.Lower / radius) - Rounding;
  slab.Upper = std::max(slab.Upper, slab.Upper / radius) + Rounding;
  this->SlabOf[node] = static_cast<int>(this->Slabs.size());
  this->Slabs.push_back(slab);
}

bool SphereLocator::isInSlab(int node, const Vector3& direction) const
{
  if (this->SlabOf[node] < 0)
  {
    return true;
  }
  const Slab& slab = this->Slabs[this->SlabOf[node]];
  const double distance = slab.Normal.dot(direction);
  return distance >= slab.Lower && distance <= slab.Upper;
}

// Compute the volume spanned by the direction and the edge opposite to a corner, positive inside.
// det(a, b, d) = det(a - d, b - d, d); the differences are exact for small triangles.
double SphereLocator::side(const Corners& corners, int opposite, const Vector3& direction)
{
  const Vector3 a = corners.Positions[next(opposite)] - direction,
                b = corners.Positions[previous(opposite)] - direction;
  return corners.Ascending[opposite] ? a.cross(b).dot(direction) : -b.cross(a).dot(direction);
}

// Visit the positions in Tree.Items of all triangles that may contain a direction, in nodes that
// are wanted. Nodes with lower triangles come first.
template <typename Wanted, typename Visit>
void SphereLocator::visitNear(const Vector3& direction, Wanted wanted, Visit visit) const
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
      (direction.array() > node.Bounds.Upper.array()).any() || !wanted(index) ||
      !this->isInSlab(index, direction))
    {
      continue;
    }
    if (node.Count == 0)
    {
      const bool isInOrder = this->LowestOf[index + 1] < this->LowestOf[node.Second];
      stack[depth++] = isInOrder ? node.Second : index + 1;
      stack[depth++] = isInOrder ? index + 1 : node.Second;
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
  // Only lower triangles can still be better.
  const auto canBeLower = [&](int node)
  { return best < 0 || this->LowestOf[node] < this->Tree.Items[best]; };
  this->visitNear(direction, canBeLower,
    [&](int place)
    {
      const Vector3 itsSides = sidesOf(this->Placed[place], direction);
      // All sides are 0 for a triangle without area whose plane contains the direction, even far
      // from the triangle: an ear of a sheet has its three corners on the equator.
      if (itsSides.minCoeff() >= 0.0 && itsSides.sum() > 0.0 &&
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
  this->visitNear(
    direction, [](int) { return true; },
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
