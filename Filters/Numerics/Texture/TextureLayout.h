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

/// Texture of the surface outside of the image.
enum class TextureWrap
{
  Clamp,  ///< border of the image, extended
  Repeat, ///< image repeated; coordinates continue outside of [0, 1]
  Mirror  ///< image mirrored alternately at its borders; coordinates are folded into [0, 1]
};

struct SphericalTexture
{
  TextureCoordinates Coordinates;          ///< #P by 2, finite; in [0, 1] except for Repeat
  std::vector<unsigned char> OutsideImage; ///< #P: 1 outside of the image
  SphereImage Image;                       ///< position on the sphere

  /// With SplitSeam: the surface after cutting. Points from #V on are copies of vertices with other
  /// coordinates, or points on cut edges.
  Triangles SplitTriangles;              ///< #F' by 3 ids in [0, #P)
  std::vector<int> TriangleIds;          ///< #F': original triangle of each
  std::vector<SurfacePlace> AddedPlaces; ///< #P - #V
};
}

#endif
