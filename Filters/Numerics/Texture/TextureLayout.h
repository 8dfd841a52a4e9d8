/// Texture coordinates of an image of the sphere on a surface, \cite Liou2008 section 4.2.

#ifndef ConformalTextureLayout_h
#define ConformalTextureLayout_h

#include "Base/Types.h"
#include "Mesh/SurfacePlace.h"
#include "Texture/SphereProjection.h"

#include <vector>

namespace conformal
{
using TextureCoordinates = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>; ///< (s, t)

/// Texture of the surface where its texture coordinates are outside of the image.
enum class TextureWrap
{
  Clamp,  ///< the border of the image is extended
  Repeat, ///< the image is repeated; coordinates may be outside of [0, 1]
  Mirror  ///< the image is repeated, alternately mirrored; coordinates are folded into [0, 1]
};

struct SphericalTexture
{
  /// #P by 2 texture coordinates, finite; in [0, 1] except for Repeat
  TextureCoordinates Coordinates;
  std::vector<unsigned char> OutsideImage; ///< #P marks, 1 for points outside of the image
  SphereImage Image; ///< projection of the image, and its position on the sphere

  /// Triangles of the cut surface, used with SplitSeam: #F' by 3 ids in [0, #P). Points from #V on
  /// are copies of vertices with other texture coordinates, or points on cut edges.
  Triangles SplitTriangles; ///< triangles after cutting
  /// #F' ids: the original triangle of each triangle in SplitTriangles
  std::vector<int> TriangleIds;
  /// #P - #V positions of the added points on the uncut surface
  std::vector<SurfacePlace> AddedPlaces;
};
}

#endif
