/// Store a surface with texture coordinates, for writers.

#ifndef ConformalTexturedMesh_h
#define ConformalTexturedMesh_h

#include <cstdint>
#include <string>
#include <vector>

namespace conformal
{
/// Surface of #P points and #F triangles with texture coordinates. All numbers are finite.
struct TexturedSurface
{
  std::vector<double> Positions; ///< #P by 3
  std::vector<float> Normals;    ///< #P by 3, vectors of unit length; or empty
  /// #P by 3, vectors of unit length in the direction of increasing u; or empty. Used by glTF
  std::vector<float> Tangents;
  std::vector<float> TexCoords;       ///< #P by 2, v counted from the bottom of the picture
  std::vector<std::uint32_t> Corners; ///< #F by 3 point ids, counter-clockwise from outside
  /// Whether the picture is repeated for texture coordinates outside of [0, 1]. Otherwise, the
  /// pixels of its border are repeated
  bool RepeatsTexture = false;
  std::string Name;           ///< name of the surface, for glTF; may be empty
  double MetersPerUnit = 1.0; ///< length of a position's unit [m], for glTF; finite and above 0
};
}

#endif
