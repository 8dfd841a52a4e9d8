/// Find the surface point shown by each pixel of an image of the sphere, \cite Liou2008 section
/// 4.2.

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
/// Receive the surface points shown by consecutive pixels. May be called from several threads
/// concurrently, with different pixels. Ids are -1 in a hole of the sphere map.
using PixelSink = std::function<void(Index firstPixel, const std::vector<SurfacePlace>& places)>;

/// Compute the direction on the sphere shown by a pixel; return false if there is none. May be
/// called from several threads concurrently.
using PixelDirection = std::function<bool(Index pixel, Vector3& direction)>;

/// Find the point of the surface for every pixel that shows a direction.
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintSphere(const MappedMesh& surface, const PixelDirection& direction, const PixelGrid& grid,
  const PixelSink& sink, const Run& run = {});

/// Find the point of the surface for every pixel by locating the direction of its center on the
/// sphere. Pixels in the margins show the sphere beyond the seams.
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintSphericalTexture(const MappedMesh& surface, const SphereImage& image,
  const PixelGrid& grid, const PixelSink& sink, const Run& run = {});

/// Find the point of another surface, or of a cloud without triangles, for every pixel. It is the
/// point closest to that of the mapped surface, for details finer than the vertices of the mapped
/// surface.
/// @param[in] cloud           #P by 3, finite, at least one
/// @param[in] cloudTriangles  #G by 3 ids in [0, #P); none for a cloud of points
/// @throws std::invalid_argument if there are no pixels or no triangles, or if the cloud is empty
///   or not finite
void paintSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const Run& run = {});

/// Find the closest point of a cloud that is distributed over ranks for every pixel. A rank may
/// have no points. Ids are -1 also where the closest point belongs to another rank. A cloud of
/// points stays distributed; a cloud with triangles is gathered on each rank.
/// @param[in] surface  whole on one rank; the other ranks pass one without triangles and any image
/// @param[in] reduce   sums over the ranks
void paintSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const Reduce& reduce, const Run& run = {});
}

#endif
