/// Each pixel of an image of the sphere shows a direction. For each pixel, find the point of a
/// surface that is mapped to this direction, \cite Liou2008 section 4.2.

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
/// Function that receives the surface points of consecutive pixels. Several threads may call the
/// function concurrently, with different pixels. If a pixel shows a hole of the sphere map, the ids
/// of its point are -1.
using PixelSink = std::function<void(Index firstPixel, const std::vector<SurfacePlace>& places)>;

/// Function that computes the direction on the sphere that a pixel shows. If the pixel shows no
/// direction, the function returns false. Several threads may call the function concurrently.
using PixelDirection = std::function<bool(Index pixel, Vector3& direction)>;

/// Find the point of the surface for every pixel that shows a direction, and pass the points to
/// `sink`, a function of the caller.
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintSphere(const MappedMesh& surface, const PixelDirection& direction, const PixelGrid& grid,
  const PixelSink& sink, const Run& run = {});

/// Find the point of the surface for every pixel of an image of the sphere: the point that is
/// mapped to the direction at the center of the pixel. A seam is a line where the image is
/// discontinuous. Pixels in the margin along a seam show the part of the sphere beyond the seam.
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintSphericalTexture(const MappedMesh& surface, const SphereImage& image,
  const PixelGrid& grid, const PixelSink& sink, const Run& run = {});

/// Find a point of a second surface, or of a cloud without triangles, for every pixel. First, the
/// point of the mapped surface is found. The result is the point of the second surface or cloud
/// closest to the first point. The image can thus show details that the mapped surface does not
/// have.
/// @param[in] cloud  #P by 3 coordinates, finite; at least one point
/// @param[in] cloudTriangles  #G by 3 ids in [0, #P); empty for a cloud without triangles
/// @throws std::invalid_argument if there are no pixels, or if the surface has no triangles
/// @throws std::invalid_argument if the cloud is empty or not finite
void paintSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const Run& run = {});

/// Find a point of a cloud for every pixel, for a cloud that is distributed over ranks (MPI
/// processes). First, the point of the mapped surface is found. The result is the point of the
/// cloud, or of its triangles, closest to the first point. Ranks without points are allowed. If the
/// found point of a pixel belongs to another rank, the ids on this rank are -1. A cloud without
/// triangles stays distributed. A cloud with triangles is gathered on each rank.
/// @param[in] surface  complete surface on one rank. The other ranks pass a surface without
///   triangles, and any image.
/// @param[in] reduce  object that sums integers over all ranks
void paintSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const PixelSink& sink, const Reduce& reduce, const Run& run = {});
}

#endif
