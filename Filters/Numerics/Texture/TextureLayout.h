/// Store texture coordinates of a surface, for an image that is placed on the sphere,
/// \cite Liou2008 section 4.2.

#ifndef ConformalTextureLayout_h
#define ConformalTextureLayout_h

#include "Base/Types.h"
#include "Mesh/SurfacePlace.h"
#include "Texture/SphereProjection.h"

#include <vector>

namespace conformal
{
using TextureCoordinates = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>; ///< (s, t)

/// Specifies what a surface shows outside of the image: at points whose texture coordinates are not
/// in [0, 1].
enum class TextureWrap
{
  Clamp,  ///< the border of the image is extended
  Repeat, ///< the image is repeated; coordinates may be outside of [0, 1]
  Mirror  ///< the image is repeated, alternately mirrored; coordinates are folded into [0, 1]
};

struct SphericalTexture
{
  /// Texture coordinates (s, t) of each point, #P by 2, finite. The coordinates are in [0, 1]
  /// except for TextureWrap::Repeat.
  TextureCoordinates Coordinates;
  std::vector<unsigned char> OutsideImage; ///< 1 for each point outside of the image, else 0, #P
  SphereImage Image; ///< projection of the image, and its position on the sphere

  /// Triangles after the surface is cut along the seams of the projection, #F' by 3 ids in [0, #P).
  /// Empty if the surface is not cut (SphericalTextureOptions::SplitSeam). Let #V be the number of
  /// vertices of the uncut surface. Points with ids of at least #V are added: copies of vertices
  /// with other texture coordinates, or points on cut edges.
  Triangles SplitTriangles;
  /// Id of the original triangle of each triangle in SplitTriangles, #F'.
  std::vector<int> TriangleIds;
  /// Positions of the added points on the uncut surface, #P - #V.
  std::vector<SurfacePlace> AddedPlaces;
};
}

#endif
