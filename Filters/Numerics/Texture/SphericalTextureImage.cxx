#include "Texture/SphericalTextureImage.h"

#include "Base/AcrossProcesses.h"
#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Search/PointTree.h"
#include "Search/TriangleTree.h"
#include "Sphere/SphereLocator.h"
#include "Sphere/SphereOrientation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
SurfacePlace placeIn(const Triangles& triangles, int triangle, const Vector3& barycentric)
{
  return { { triangles(triangle, 0), triangles(triangle, 1), triangles(triangle, 2) },
    barycentric };
}

Vector3 positionOf(const SurfacePlace& place, const PointView& points)
{
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    sum += place.Weights[k] * points[place.Ids[k]];
  }
  return sum;
}

// Function that maps a point of the surface to a point of another surface. The hint is passed from
// pixel to pixel.
using Replace = std::function<SurfacePlace(const SurfacePlace&, int& hint)>;

void paint(const MappedMesh& surface, const PixelDirection& direction, const PixelGrid& grid,
  const Replace& replace, const PixelSink& sink, const Run& run)
{
  if (grid.Width < 1 || grid.Height < 1)
  {
    throw std::invalid_argument("an image must have at least one pixel");
  }
  if (surface.Triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  Steps steps(run, { 0.02, 0.28, 0.7 }); // triangles, locator, pixels
  steps.next();
  const Triangles triangles = turnedOutward(surface.Triangles, surface.SpherePositions);
  const SphereLocator locator(surface.SpherePositions, triangles, steps.next());
  constexpr Index blockSize = 1 << 10;
  forBlocksReporting(steps.next(), grid.size(), blockSize,
    [&](Index begin, Index end)
    {
      std::vector<SurfacePlace> places(end - begin);
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        Vector3 n;
        if (!direction(i, n))
        {
          continue;
        }
        const SphereLocation location = locator.locate(n);
        if (location.Triangle >= 0)
        {
          places[i - begin] =
            replace(placeIn(triangles, location.Triangle, location.Barycentric), hint);
        }
      }
      sink(begin, places);
    });
}

PixelDirection directionsOf(const SphereImage& image, const PixelGrid& grid)
{
  return [&image, &grid](Index pixel, Vector3& n)
  {
    n = textureToSphere(grid.middleOf(pixel), image);
    return true;
  };
}

// Closest points of a cloud, or of a surface, distributed over ranks.
class ClosestPlaces
{
public:
  struct Found
  {
    SurfacePlace Place; // place in ids of this rank; -1 for points of other ranks
    double SquareDistance = std::numeric_limits<double>::infinity();
  };

  ClosestPlaces(
    const PointView& cloud, const Triangles& triangles, const Reduce& reduce, const Run& run)
    : NumberOfOwn(cloud.size())
  {
    std::int64_t sizes[] = { cloud.size(), triangles.rows() };
    reduce.sum(sizes, 2);
    if (sizes[0] == 0)
    {
      throw std::invalid_argument("the source has no points");
    }
    this->HasTriangles = sizes[1] > 0;
    if (!this->HasTriangles)
    {
      this->Near = PointTree(cloud, run);
      return;
    }
    Points positions(cloud.size(), 3);
    for (Index i = 0; i < cloud.size(); ++i)
    {
      positions.row(i) = cloud[i];
    }
    this->FirstOwn = shareOf(reduce, cloud.size()).Before;
    this->Triangles = gatherTriangles(reduce, triangles, cloud.size());
    positions = gatherRows(reduce, positions);
    if (!positions.allFinite())
    {
      throw std::invalid_argument("points of the source are not finite");
    }
    this->Surface = TriangleTree(positions, this->Triangles, run);
  }

  // Test whether points are the closest of all ranks, not only of this one.
  bool knowsAll() const { return this->HasTriangles; }

  Found operator()(const Vector3& x, int& hint) const
  {
    Found found;
    if (!this->HasTriangles)
    {
      const Neighbor neighbor = this->Near.nearest(x);
      if (neighbor.Id >= 0)
      {
        found.Place = { { neighbor.Id, neighbor.Id, neighbor.Id }, { 1.0, 0.0, 0.0 } };
        found.SquareDistance = neighbor.SquareDistance;
      }
      return found;
    }
    const FootPoint foot = this->Surface.closestPoint(x, hint);
    hint = foot.Triangle;
    if (hint < 0) // square distances overflowed or underflowed
    {
      return found;
    }
    SurfacePlace place = placeIn(this->Triangles, foot.Triangle, foot.Barycentric);
    const Index own = place.Ids[0] - this->FirstOwn;
    if (own >= 0 && own < this->NumberOfOwn)
    {
      for (int& id : place.Ids)
      {
        id -= static_cast<int>(this->FirstOwn);
      }
      found = { place, foot.SquareDistance };
    }
    return found;
  }

private:
  Index FirstOwn = 0, NumberOfOwn;
  bool HasTriangles = false;
  PointTree Near;
  TriangleTree Surface;
  conformal::Triangles Triangles;
};

// Find the points of the surface shown by pixels. In holes, coordinates are infinite. Without a
// surface, the result is empty.
Points pixelPositions(
  const MappedMesh& surface, const SphereImage& image, const PixelGrid& grid, const Run& run)
{
  if (surface.Triangles.rows() == 0)
  {
    return Points(0, 3);
  }
  unitBoxOf(surface.Positions); // throws if they are not finite
  Points positions(grid.size(), 3);
  const PixelSink place = [&](Index first, const std::vector<SurfacePlace>& places)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      positions.row(first + static_cast<Index>(i)) = places[i].Ids[0] < 0
        ? Vector3(Vector3::Constant(std::numeric_limits<double>::infinity()))
        : positionOf(places[i], surface.Positions);
    }
  };
  paintSphericalTexture(surface, image, grid, place, run);
  return positions;
}
}

//------------------------------------------------------------------------------
void paintSphere(const MappedMesh& surface, const PixelDirection& direction, const PixelGrid& grid,
  const PixelSink& sink, const Run& run)
{
  paint(
    surface, direction, grid, [](const SurfacePlace& place, int&) { return place; }, sink, run);
}

//------------------------------------------------------------------------------
void paintSphericalTexture(const MappedMesh& surface, const SphereImage& image,
  const PixelGrid& grid, const PixelSink& sink, const Run& run)
{
  paintSphere(surface, directionsOf(image, grid), grid, sink, run);
}

//------------------------------------------------------------------------------
void paintSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const Run& run)
{
  Steps steps(run, { 0.15, 0.85 }); // tree, image
  const ClosestPlaces closest(cloud, cloudTriangles, {}, steps.next());
  unitBoxOf(surface.Positions); // throws if they are not finite
  paint(
    surface, directionsOf(image, grid), grid,
    [&](const SurfacePlace& place, int& hint)
    { return closest(positionOf(place, surface.Positions), hint).Place; },
    sink, steps.next());
}

//------------------------------------------------------------------------------
void paintSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const Reduce& reduce, const Run& run)
{
  if (reduce.NumberOfRanks == 1)
  {
    paintSphericalTexture(surface, cloud, cloudTriangles, image, grid, sink, run);
    return;
  }
  // Start of the search, after its tree and the positions of the pixels
  constexpr double begin = 0.3;
  const ClosestPlaces closest(cloud, cloudTriangles, reduce, run.part(0.0, 0.5 * begin));
  const Points wanted = pixelPositions(surface, image, grid, run.part(0.5 * begin, begin));
  // Process chunks of pixels: each is sent to all ranks, and the distances are sent back.
  constexpr Index ChunkSize = 1 << 18;
  for (Index first = 0; first < grid.size(); first += ChunkSize)
  {
    const Index size = std::min(ChunkSize, grid.size() - first);
    const bool isOwner = wanted.rows() > 0;
    const Points positions =
      gatherRows(reduce, isOwner ? Points(wanted.middleRows(first, size)) : Points(0, 3));
    if (positions.rows() != size)
    {
      throw std::invalid_argument("one process must have the surface, with triangles");
    }
    std::vector<SurfacePlace> places(size);
    std::vector<double> squares(size, std::numeric_limits<double>::infinity());
    const auto fraction = [&](Index done) {
      return begin + (1.0 - begin) * static_cast<double>(done) / static_cast<double>(grid.size());
    };
    forBlocksReporting(run.part(fraction(first), fraction(first + size)), size, LightBlock,
      [&](Index firstOf, Index lastOf)
      {
        int hint = -1;
        for (Index i = firstOf; i < lastOf; ++i)
        {
          if (positions.row(i).allFinite()) // not a hole
          {
            const ClosestPlaces::Found found = closest(positions.row(i), hint);
            places[i] = found.Place;
            squares[i] = found.SquareDistance;
          }
        }
      });
    if (!closest.knowsAll())
    {
      const std::vector<Minimum> nearest = minimum(reduce, squares);
      for (Index i = 0; i < size; ++i)
      {
        if (nearest[i].Rank != reduce.Rank)
        {
          places[i] = SurfacePlace();
        }
      }
    }
    sink(first, places);
  }
}
}
