/// Finds the surface point that each pixel of an image of the sphere shows.

#ifndef ConformalSphericalTextureImage_h
#define ConformalSphericalTextureImage_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Mesh/SurfacePlace.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphereProjection.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Receives the places that consecutive pixels show. May be called from several threads at once,
/// for other pixels each time. Ids are -1 where the map to the sphere has a hole.
using PixelSink = std::function<void(Index firstPixel, const std::vector<SurfacePlace>& places)>;

/// Says which direction on the sphere a pixel shows; false if it shows none. May be called from
/// several threads at once.
using PixelDirection = std::function<bool(Index pixel, Vector3& direction)>;

/// Find the point of the surface for every pixel that shows a direction.
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintSphere(const MappedMesh& surface, const PixelDirection& direction, const PixelGrid& grid,
  const PixelSink& sink, const Run& run = {});

/// Find the point of the surface for every pixel: the direction of its middle is located on the
/// sphere. Pixels in the margins show what the sphere has beyond the seams.
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintSphericalTexture(const MappedMesh& surface, const SphereImage& image,
  const PixelGrid& grid, const PixelSink& sink, const Run& run = {});

/// The same, but the places are those of another surface, or of a cloud without triangles, closest
/// to the points found: details that the mapped surface has no vertices for.
/// @param[in] cloud           #P by 3, finite, at least one
/// @param[in] cloudTriangles  #G by 3 ids in [0, #P); none for the points only
/// @throws std::invalid_argument also if the cloud is empty or not finite
void paintSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const Run& run = {});

/// The same by several processes, each of which has a part of the cloud, perhaps none. Where the
/// closest place is another process's, ids are -1 too. A cloud of points stays where it is, one
/// with triangles is gathered on each process.
/// @param[in] surface  whole on one process; the others give one without triangles, whose image may
///   be any
/// @param[in] reduce   adds up over the processes
void paintSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const Reduce& reduce, const Run& run = {});
}

#endif
