/// Texture coordinates of an image of the sphere on a surface.

#ifndef ConformalTextureLayout_h
#define ConformalTextureLayout_h

#include "Base/Types.h"
#include "Mesh/SurfacePlace.h"
#include "Texture/SphereProjection.h"

#include <vector>

namespace conformal
{
using TextureCoordinates = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>; ///< (s, t)

/// What the surface shows where the image does not reach.
enum class TextureWrap
{
  Clamp,  ///< the image's border, drawn out
  Repeat, ///< the image again; coordinates go on beyond [0, 1]
  Mirror  ///< the image mirrored at its borders, in turns; coordinates are folded into [0, 1]
};

struct SphericalTexture
{
  TextureCoordinates Coordinates;          ///< #P by 2, finite; in [0, 1] but for Repeat
  std::vector<unsigned char> OutsideImage; ///< #P: 1 where the image does not reach
  SphereImage Image;                       ///< as it lies on the sphere

  /// With SplitSeam: the surface as cut. Points from #V on are copies of vertices, with other
  /// coordinates, or lie where edges were cut.
  Triangles SplitTriangles;              ///< #F' by 3 ids in [0, #P)
  std::vector<int> TriangleIds;          ///< #F': the triangle each is part of
  std::vector<SurfacePlace> AddedPlaces; ///< #P - #V
};
}

#endif
