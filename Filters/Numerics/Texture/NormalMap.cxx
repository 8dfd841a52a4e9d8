#include "Texture/NormalMap.h"

#include "Base/Steps.h"
#include "Search/TriangleTree.h"
#include "Sphere/SphereLocator.h"
#include "Sphere/SphereOrientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
Vector3 mixed(const Points& rows, const Triangles& triangles, int triangle, const Vector3& weights)
{
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    sum += weights[k] * rows.row(triangles(triangle, k)).transpose();
  }
  return sum;
}

// Number of squares of an image along s and t. Each square has a margin of its own. Projections
// without margins have no squares.
std::array<int, 2> squaresOf(const SphereImage& image)
{
  switch (image.Projection)
  {
    case SphereProjection::Octahedral:
      return { 1, 1 };
    case SphereProjection::CubeMap:
      return { 3, 2 };
    default:
      return { 0, 0 };
  }
}

// Closest position of the square that is not in its margin, at least half a pixel from the seam.
Vector2 outsideOfMargin(const Vector2& st, const SphereImage& image, const PixelGrid& grid)
{
  const std::array<int, 2> squares = squaresOf(image);
  const double sizes[] = { static_cast<double>(grid.Width), static_cast<double>(grid.Height) };
  Vector2 inside = st;
  for (int c = 0; c < 2 && squares[0] > 0; ++c)
  {
    const double number = squares[c];
    const double square = std::min(std::floor(st[c] * number), number - 1.0);
    const double border = std::min(image.Margin + 0.5 * number / sizes[c], 0.5);
    inside[c] = (square + std::clamp(st[c] * number - square, border, 1.0 - border)) / number;
  }
  return inside;
}

class Pixels
{
public:
  Pixels(const TangentSurface& surface, const SphereImage& image, const PixelGrid& grid,
    const SurfaceWithNormals& detail, const Run& run)
    : Surface(surface)
    , Image(image)
    , Grid(grid)
    , Detail(detail)
  {
    Steps steps(run, { 0.5, 0.5 }); // locator, tree
    this->Outward = turnedOutward(surface.Triangles, surface.SpherePositions);
    this->Locator = SphereLocator(surface.SpherePositions, this->Outward, steps.next());
    this->Closest = TriangleTree(detail.Positions, detail.Triangles, steps.next());
  }

  // Compute the value of a pixel. The hint is passed from pixel to pixel.
  Vector3 operator()(Index pixel, int& hint) const
  {
    const Vector2 st = this->Grid.middleOf(pixel);
    const Vector2 inside = outsideOfMargin(st, this->Image, this->Grid);
    const SphereLocation shown = this->locate(st);
    const SphereLocation framed = inside == st ? shown : this->locate(inside);
    if (shown.Triangle < 0 || framed.Triangle < 0)
    {
      return Vector3::UnitZ();
    }
    const FootPoint foot = this->Closest.closestPoint(
      mixed(this->Surface.Positions, this->Outward, shown.Triangle, shown.Barycentric), hint);
    hint = foot.Triangle;
    if (hint < 0) // square distances overflowed
    {
      return Vector3::UnitZ();
    }
    return this->relative(
      framed, mixed(this->Detail.Normals, this->Detail.Triangles, foot.Triangle, foot.Barycentric));
  }

private:
  SphereLocation locate(const Vector2& st) const
  {
    return this->Locator.locate(textureToSphere(st, this->Image));
  }

  // Convert a normal to the coordinates of the surface at a point. Directions below the surface are
  // turned into the surface: a pixel cannot show them.
  Vector3 relative(const SphereLocation& at, const Vector3& normal) const
  {
    const Vector3 n =
      mixed(this->Surface.Normals, this->Outward, at.Triangle, at.Barycentric).stableNormalized();
    Vector3 t = mixed(this->Surface.Tangents, this->Outward, at.Triangle, at.Barycentric);
    t = (t - t.dot(n) * n).stableNormalized();
    const Vector3 value(t.dot(normal), n.cross(t).dot(normal), std::max(n.dot(normal), 0.0));
    return value.norm() > 1e-12 ? Vector3(value.normalized()) : Vector3(Vector3::UnitZ());
  }

  const TangentSurface& Surface;
  const SphereImage& Image;
  const PixelGrid& Grid;
  const SurfaceWithNormals& Detail;
  Triangles Outward;
  SphereLocator Locator;
  TriangleTree Closest;
};
}

//------------------------------------------------------------------------------
Points normalMap(const TangentSurface& surface, const SphereImage& image, const PixelGrid& grid,
  const SurfaceWithNormals& detail, const Run& run)
{
  if (grid.Width < 1 || grid.Height < 1)
  {
    throw std::invalid_argument("an image must have at least one pixel");
  }
  if (surface.Triangles.rows() == 0 || detail.Triangles.rows() == 0)
  {
    throw std::invalid_argument("a surface has no triangles");
  }
  Steps steps(run, { 0.2, 0.8 }); // search structures, pixels
  const Pixels pixels(surface, image, grid, detail, steps.next());
  Points values(grid.size(), 3);
  constexpr Index blockSize = 1 << 10;
  forBlocksReporting(steps.next(), grid.size(), blockSize,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        values.row(i) = pixels(i, hint);
      }
    });
  return values;
}
}
