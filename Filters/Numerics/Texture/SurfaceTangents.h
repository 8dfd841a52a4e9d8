/// Compute tangents of a surface with texture coordinates: unit vectors in the direction of
/// increasing s, by the method MikkTSpace, \cite Mikkelsen2008. Normal maps store directions
/// relative to tangents and normals.

#ifndef ConformalSurfaceTangents_h
#define ConformalSurfaceTangents_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Texture/TextureLayout.h"

namespace conformal
{
/// Compute a unit tangent at each vertex: the mean of the directions in which s increases in its
/// triangles. The mean is weighted by the triangles' angles at the vertex. Each direction is
/// projected to the plane perpendicular to the vertex normal. Vertices with equal position, normal
/// and texture coordinates get the same tangent, as the programs do that compute tangents
/// themselves. Triangles without area in the image, and triangles that show it mirrored, are left
/// out. A vertex without other triangles gets any unit vector perpendicular to its normal.
///
/// With the normal n and the tangent t, the direction in which the texture coordinate t increases
/// is the bitangent n x t. The factor of handedness, which other programs store for mirrored
/// triangles, is therefore always 1.
///
/// @param[in] surface      #V by 3 positions, and triangles counter-clockwise seen from outside
/// @param[in] normals      #V by 3 unit vectors
/// @param[in] coordinates  #V by 2 texture coordinates, upward in the image
/// @return #V by 3 unit vectors, perpendicular to the normals
/// @throws std::invalid_argument if the numbers of positions, normals and texture coordinates
///   differ
Points surfaceTangents(const Mesh& surface, const Points& normals,
  const TextureCoordinates& coordinates, const Run& run = {});
}

#endif
