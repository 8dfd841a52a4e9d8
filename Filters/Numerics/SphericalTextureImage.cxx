#include "SphericalTextureImage.h"

#include "PointTree.h"
#include "SphereLocator.h"
#include "TriangleTree.h"
#include "UnitBox.h"

#include <stdexcept>

namespace conformal
{
namespace
{
// The locator wants triangles counter-clockwise on the sphere; a mirrored map has them turned.
Triangles turnedOutwards(const Triangles& faces, const Points& spherePositions)
{
  double volume = 0.0;
  for (Index r = 0; r < faces.rows(); ++r)
  {
    const Vector3 a = spherePositions.row(faces(r, 0)), b = spherePositions.row(faces(r, 1)),
                  c = spherePositions.row(faces(r, 2));
    volume += a.cross(b).dot(c);
  }
  Triangles result = faces;
  if (volume < 0.0)
  {
    result.col(1).swap(result.col(2));
  }
  return result;
}

SurfacePlace placeIn(const Triangles& faces, int triangle, const Vector3& barycentric)
{
  return { { faces(triangle, 0), faces(triangle, 1), faces(triangle, 2) }, barycentric };
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

// To another surface's place; the hint is what it was told or left there for the pixel before.
using Replace = std::function<SurfacePlace(const SurfacePlace&, int& hint)>;

void paint(const SphereMappedSurface& surface, const SphereImage& image, const PixelGrid& grid,
  const Replace& replace, const PixelSink& sink, const ParallelFor& parallelFor,
  const Progress& progress)
{
  if (grid.Width < 1 || grid.Height < 1)
  {
    throw std::invalid_argument("an image has at least one pixel");
  }
  if (surface.Faces.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  const Triangles faces = turnedOutwards(surface.Faces, surface.SpherePositions);
  const SphereLocator locator(surface.SpherePositions, faces);
  report(progress, 0.1);
  constexpr Index blockSize = 1 << 10;
  forBlocks(parallelFor, grid.size(), blockSize, partOf(progress, 0.1, 1.0),
    [&](Index begin, Index end)
    {
      std::vector<SurfacePlace> places(end - begin);
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        const SphereLocation location = locator.locate(textureToSphere(grid.middleOf(i), image));
        if (location.Triangle >= 0)
        {
          places[i - begin] =
            replace(placeIn(faces, location.Triangle, location.Barycentric), hint);
        }
      }
      sink(begin, places);
    });
}
}

//------------------------------------------------------------------------------
void paintSphericalTexture(const SphereMappedSurface& surface, const SphereImage& image,
  const PixelGrid& grid, const PixelSink& sink, const ParallelFor& parallelFor,
  const Progress& progress)
{
  paint(
    surface, image, grid, [](const SurfacePlace& place, int&) { return place; }, sink, parallelFor,
    progress);
}

//------------------------------------------------------------------------------
void paintSphericalTexture(const SphereMappedSurface& surface, const PointView& cloud,
  const Triangles& cloudFaces, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const ParallelFor& parallelFor, const Progress& progress)
{
  if (cloud.size() == 0)
  {
    throw std::invalid_argument("there are no points to take values from");
  }
  unitBoxOf(surface.Positions); // throws where they are not finite
  if (cloudFaces.rows() == 0)
  {
    const PointTree tree(cloud);
    paint(
      surface, image, grid,
      [&](const SurfacePlace& place, int&)
      {
        const int id = tree.nearest(positionOf(place, surface.Positions)).Id;
        return SurfacePlace{ { id, id, id }, { 1.0, 0.0, 0.0 } };
      },
      sink, parallelFor, progress);
    return;
  }
  Points positions(cloud.size(), 3);
  for (Index i = 0; i < cloud.size(); ++i)
  {
    positions.row(i) = cloud[i];
  }
  if (!positions.allFinite())
  {
    throw std::invalid_argument("points to take values from are not finite");
  }
  const TriangleTree tree(positions, cloudFaces, parallelFor);
  paint(
    surface, image, grid,
    [&](const SurfacePlace& place, int& hint)
    {
      const FootPoint foot = tree.closestPoint(positionOf(place, surface.Positions), hint);
      hint = foot.Triangle;
      if (hint < 0) // squares of distances have left the numbers' range
      {
        return SurfacePlace();
      }
      return placeIn(cloudFaces, foot.Triangle, foot.Barycentric);
    },
    sink, parallelFor, progress);
}
}
