/// Compute normal maps as in \cite Cohen1998 for a surface of few triangles. A normal map is an
/// image with the normals of a detailed surface. The normals are relative to the tangents of the
/// surface that is drawn, as in \cite Mikkelsen2008.

#ifndef ConformalNormalMap_h
#define ConformalNormalMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphereProjection.h"

namespace conformal
{
/// Surface with a normal at each vertex.
struct SurfaceWithNormals : Mesh
{
  Points Normals; ///< #V by 3 unit vectors
};

/// Surface that is drawn with a normal map.
struct TangentSurface : MappedMesh
{
  Points Normals;  ///< #V by 3 unit vectors
  Points Tangents; ///< #V by 3 unit vectors, see surfaceTangents()
};

/// Compute a normal map. A pixel shows a point of the surface. Let n and t be the interpolated
/// normal and tangent at this point, with t made perpendicular to n, and both of unit length. The
/// value of the pixel is the normal of the detailed surface at the closest point, in the
/// coordinates t, n x t, and n.
///
/// Pixels of the margin show points beyond the seam. Their n and t are those of the closest point
/// of the image that is not in the margin, so that values can be interpolated across its border.
///
/// Implementation note: \cite Mikkelsen2008 interpolates without normalizing, and programs differ
/// in this respect. The difference is of second order in the angle between the normals of a
/// triangle.
///
/// @param[in] surface  surface with a map to the sphere; its triangles are cut along the seams of
///   the image
/// @param[in] detail   surface with the normals to draw
/// @return one row (t, n x t, n) for each pixel: unit vectors with n >= 0. (0, 0, 1) where the map
///   to the sphere has a hole.
/// @throws std::invalid_argument if the image has no pixels, or if a surface has no triangles
/// @post the result does not depend on the number of threads
Points normalMap(const TangentSurface& surface, const SphereImage& image, const PixelGrid& grid,
  const SurfaceWithNormals& detail, const Run& run = {});
}

#endif
