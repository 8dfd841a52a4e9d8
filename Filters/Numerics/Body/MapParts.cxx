#include "Body/MapParts.h"

#include "Base/Steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace conformal
{
namespace
{
// Whether an image has all longitudes on a horizontal line, from the left to the right of the map.
bool hasAllLongitudes(const MapImage& image, double y)
{
  switch (image.Projection)
  {
    case MapProjection::Equirectangular:
    case MapProjection::Mercator:
      return true;
    case MapProjection::Capsule:
    {
      const double unit = 2.0 * image.halfSize()[1] / double(image.Grid.Height);
      return std::abs(y - 0.5 * double(image.Grid.Height)) * unit < image.CapsuleAspect - 1.0;
    }
    default:
      return false;
  }
}

// Width of all longitudes in pixels.
double turnInPixels(const MapImage& image)
{
  const bool isInDegrees = image.Projection == MapProjection::Equirectangular;
  return (isInDegrees ? 180.0 : Pi) / image.halfSize()[0] * double(image.Grid.Width);
}

// How many times the triangles of a map cover the sphere, at least once and without the fraction.
double timesCovered(const MappedMesh& body)
{
  constexpr double rounding = 1e-9;
  double solidAngle = 0.0;
  for (Index r = 0; r < body.Triangles.rows(); ++r)
  {
    const Vector3 a = body.SpherePositions.row(body.Triangles(r, 0)),
                  b = body.SpherePositions.row(body.Triangles(r, 1)),
                  c = body.SpherePositions.row(body.Triangles(r, 2));
    const double volume = (b - a).cross(c - a).dot(a);
    solidAngle += 2.0 * std::atan2(std::abs(volume), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return std::max(1.0, std::floor(solidAngle / (4.0 * Pi) + rounding));
}

int windingNumber(const std::vector<Vector2>& polygon, const Vector2& x)
{
  int number = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector2 a = polygon[i] - x, b = polygon[(i + 1) % polygon.size()] - x;
    if (a[1] <= 0.0 && b[1] > 0.0 && cross(a, b) > 0.0)
    {
      ++number;
    }
    else if (a[1] > 0.0 && b[1] <= 0.0 && cross(a, b) < 0.0)
    {
      --number;
    }
  }
  return number;
}

// Signed area of a polygon inside of a counter-clockwise triangle: cut by each side in turn. The
// signed area is right for any polygon, since parts along the border cancel.
double areaInTriangle(const std::vector<Vector2>& polygon, const std::array<Vector2, 3>& triangle)
{
  std::vector<Vector2> kept = polygon, next;
  for (int k = 0; k < 3; ++k)
  {
    const Vector2 &from = triangle[k], along = triangle[(k + 1) % 3] - from;
    next.clear();
    for (std::size_t i = 0; i < kept.size(); ++i)
    {
      const Vector2 &a = kept[i], &b = kept[(i + 1) % kept.size()];
      const double sideOfA = cross(along, a - from), sideOfB = cross(along, b - from);
      if (sideOfA >= 0.0)
      {
        next.push_back(a);
      }
      if ((sideOfA < 0.0) != (sideOfB < 0.0))
      {
        next.push_back(a + sideOfA / (sideOfA - sideOfB) * (b - a));
      }
    }
    kept.swap(next);
  }
  double twice = 0.0;
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    twice += cross(kept[i] - triangle[0], kept[(i + 1) % kept.size()] - triangle[0]);
  }
  return 0.5 * twice;
}

bool touches(const Box& box, const Vector2& a, const Vector2& b)
{
  const Vector2 lower = box.Lower.head<2>(), upper = box.Upper.head<2>();
  if ((a.cwiseMin(b).array() > upper.array()).any() ||
    (a.cwiseMax(b).array() < lower.array()).any())
  {
    return false;
  }
  const Vector2 along = b - a;
  const double corners[4] = { cross(along, lower - a), cross(along, upper - a),
    cross(along, Vector2(lower[0], upper[1]) - a), cross(along, Vector2(upper[0], lower[1]) - a) };
  return *std::min_element(corners, corners + 4) <= 0.0 &&
    *std::max_element(corners, corners + 4) >= 0.0;
}
}

//------------------------------------------------------------------------------
double pictureUnit(const MapImage& image)
{
  return 1e-3 * std::sqrt(double(image.Grid.size()));
}

//------------------------------------------------------------------------------
Vector2 inImage(const MapImage& image, const Vector2& pixels)
{
  const double turn = turnInPixels(image), middle = 0.5 * double(image.Grid.Width);
  const double beyond = std::abs(pixels[0] - middle) - 0.5 * turn;
  return beyond > 1e-9 * turn && hasAllLongitudes(image, pixels[1])
    ? Vector2(middle + std::remainder(pixels[0] - middle, turn), pixels[1])
    : pixels;
}

//------------------------------------------------------------------------------
struct MapParts::Division
{
  struct Corner
  {
    Vector3 Direction;
    Vector2 Pixels;
  };

  const MappedMesh& Body;
  const MapImage& Image;
  double Unit, Turn;

  void add(Index triangle, std::vector<Part>& parts) const
  {
    const double area = areaVector(this->Body.Positions, this->Body.Triangles, triangle).norm();
    std::array<Corner, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k].Direction = this->Body.SpherePositions.row(this->Body.Triangles(triangle, k));
    }
    if (area > 0.0)
    {
      this->divide(corners, area, 0, parts);
    }
  }

private:
  Vector2 toPixels(const Vector3& n) const
  {
    const double length = n.norm();
    return this->Image.toPixels(length > 0.0 ? Vector3(n / length) : Vector3(0, 0, 1));
  }

  // Move a position by turns of the image, closest to another position.
  Vector2 near(const Vector2& pixels, const Vector2& to) const
  {
    return this->Turn > 0.0 && hasAllLongitudes(this->Image, pixels[1]) &&
        hasAllLongitudes(this->Image, to[1])
      ? Vector2(to[0] + std::remainder(pixels[0] - to[0], this->Turn), pixels[1])
      : pixels;
  }

  // Directions of corners are not normalized: sides stay straight in the triangle.
  void divide(std::array<Corner, 3>& c, double area, int level, std::vector<Part>& parts) const
  {
    constexpr int deepest = 14;
    constexpr double flat = 0.05, finest = 1.0 / 16.0;
    for (Corner& corner : c)
    {
      corner.Pixels = this->toPixels(corner.Direction);
    }
    c[1].Pixels = this->near(c[1].Pixels, c[0].Pixels);
    c[2].Pixels = this->near(c[2].Pixels, c[0].Pixels);
    std::array<Corner, 3> middles;
    double bend = 0.0, angle = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Corner &a = c[(k + 1) % 3], &b = c[(k + 2) % 3];
      middles[k].Direction = 0.5 * (a.Direction + b.Direction);
      const Vector2 straight = 0.5 * (a.Pixels + b.Pixels);
      const Vector2 pixels = this->near(this->toPixels(middles[k].Direction), straight);
      bend = std::max(bend, (pixels - straight).norm());
      angle = std::max(angle, (a.Direction - b.Direction).norm());
    }
    if (bend <= flat * this->Unit)
    {
      parts.push_back({ { c[0].Pixels, c[1].Pixels, c[2].Pixels }, area });
      return;
    }
    const Vector3 middle = (c[0].Direction + c[1].Direction + c[2].Direction) / 3.0;
    if (level == deepest ||
      this->Image.pixelsOfAngle(middle.normalized(), angle) <= finest * this->Unit)
    {
      const Vector2 pixels = this->toPixels(middle);
      parts.push_back({ { pixels, pixels, pixels }, area });
      return;
    }
    const double quarter = 0.25 * area;
    for (int k = 0; k < 3; ++k)
    {
      std::array<Corner, 3> part = { c[k], middles[(k + 2) % 3], middles[(k + 1) % 3] };
      this->divide(part, quarter, level + 1, parts);
    }
    this->divide(middles, quarter, level + 1, parts);
  }
};

//------------------------------------------------------------------------------
MapParts::MapParts(const MappedMesh& body, const MapImage& image, const Run& run)
{
  Steps steps(run, { 0.7, 0.3 }); // division, tree
  const double middle = 0.5 * double(image.Grid.Height);
  this->Period = hasAllLongitudes(image, middle) ? turnInPixels(image) : 0.0;
  // Where n triangles cover each place, parts are n times as large, so that their number is not.
  const Division division = { body, image, timesCovered(body) * pictureUnit(image), this->Period };
  constexpr Index blockSize = 64;
  const Index size = body.Triangles.rows(), blocks = (size + blockSize - 1) / blockSize;
  std::vector<std::vector<Part>> ofBlocks(blocks);
  forBlocksReporting(steps.next(), size, blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        division.add(r, ofBlocks[begin / blockSize]);
      }
    });
  std::vector<Box> boxes;
  for (std::vector<Part>& parts : ofBlocks)
  {
    for (const Part& part : parts)
    {
      Box box;
      for (const Vector2& corner : part.Corners)
      {
        box.extend(Vector3(corner[0], corner[1], 0.0));
      }
      boxes.push_back(box);
      this->Parts.push_back(part);
    }
    std::vector<Part>().swap(parts);
  }
  this->Tree = buildBoxTree(boxes, steps.next());
  this->AreasBefore.assign(1, 0.0);
  for (const int item : this->Tree.Items)
  {
    this->AreasBefore.push_back(this->AreasBefore.back() + this->Parts[item].Area);
  }
  this->FirstOf.resize(this->Tree.Nodes.size());
  this->EndOf.resize(this->Tree.Nodes.size());
  for (int i = static_cast<int>(this->Tree.Nodes.size()) - 1; i >= 0; --i)
  {
    const BoxTree::Node& node = this->Tree.Nodes[i];
    this->FirstOf[i] = node.Count > 0 ? node.First : this->FirstOf[i + 1];
    this->EndOf[i] = node.Count > 0 ? node.First + node.Count : this->EndOf[node.Second];
  }
}

//------------------------------------------------------------------------------
double MapParts::areaOfNode(
  int index, const std::vector<Vector2>& polygon, const std::vector<int>& sides) const
{
  const auto touching = [&](const Box& box, const std::vector<int>& among)
  {
    std::vector<int> found;
    for (const int i : among)
    {
      if (touches(box, polygon[i], polygon[(i + 1) % polygon.size()]))
      {
        found.push_back(i);
      }
    }
    return found;
  };
  const BoxTree::Node& node = this->Tree.Nodes[index];
  const std::vector<int> own = touching(node.Bounds, sides);
  if (own.empty())
  {
    const Vector2 corner = node.Bounds.Lower.head<2>();
    return windingNumber(polygon, corner) *
      (this->AreasBefore[this->EndOf[index]] - this->AreasBefore[this->FirstOf[index]]);
  }
  if (node.Count == 0)
  {
    const double first = this->areaOfNode(index + 1, polygon, own);
    return first + this->areaOfNode(node.Second, polygon, own);
  }
  double sum = 0.0;
  for (int i = node.First; i < node.First + node.Count; ++i)
  {
    const Part& part = this->Parts[this->Tree.Items[i]];
    std::array<Vector2, 3> c = part.Corners;
    Box box;
    for (const Vector2& corner : c)
    {
      box.extend(Vector3(corner[0], corner[1], 0.0));
    }
    const double twice = cross(c[1] - c[0], c[2] - c[0]);
    if (twice == 0.0 || touching(box, own).empty())
    {
      sum += windingNumber(polygon, (c[0] + c[1] + c[2]) / 3.0) * part.Area;
      continue;
    }
    if (twice < 0.0)
    {
      std::swap(c[1], c[2]);
    }
    sum += areaInTriangle(polygon, c) / (0.5 * std::abs(twice)) * part.Area;
  }
  return sum;
}

//------------------------------------------------------------------------------
double MapParts::areaInside(const std::vector<Vector2>& polygon) const
{
  if (polygon.size() < 3 || this->Parts.empty())
  {
    return 0.0;
  }
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (const Vector2& corner : polygon)
  {
    left = std::min(left, corner[0]);
    right = std::max(right, corner[0]);
  }
  const Box& whole = this->Tree.Nodes.front().Bounds;
  const auto turns = [&](double x)
  { return this->Period > 0.0 ? static_cast<int>(std::floor(x / this->Period)) : 0; };
  std::vector<int> sides(polygon.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    sides[i] = static_cast<int>(i);
  }
  double sum = 0.0;
  for (int k = turns(whole.Lower[0] - right); k <= turns(whole.Upper[0] - left) + 1; ++k)
  {
    std::vector<Vector2> moved = polygon;
    for (Vector2& corner : moved)
    {
      corner[0] += k * this->Period;
    }
    sum += this->areaOfNode(0, moved, sides);
    if (this->Period == 0.0)
    {
      break;
    }
  }
  return std::abs(sum);
}
}
