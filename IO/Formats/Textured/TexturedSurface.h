/// Write textured surfaces: binary glTF 2.0, Wavefront OBJ and PLY.

#ifndef ConformalTexturedSurface_h
#define ConformalTexturedSurface_h

#include "Base/Run.h"
#include "Bytes/ParseStatus.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
/// Triangles with texture coordinates. All numbers are finite.
struct TexturedSurface
{
  std::vector<double> Positions;      ///< #P by 3
  std::vector<float> Normals;         ///< #P by 3 of unit length, or empty
  std::vector<float> TexCoords;       ///< #P by 2, v counted from the bottom of the picture
  std::vector<std::uint32_t> Corners; ///< #F by 3 point ids, counter-clockwise from outside
  /// Whether the picture is repeated outside of [0, 1]; otherwise its border is repeated there
  bool RepeatsTexture = false;
  std::string Name;           ///< name of the surface, for glTF; no name if empty
  double MetersPerUnit = 1.0; ///< unit of the positions, for glTF; finite and above 0
};

/// Write a binary glTF 2.0 file that contains the picture. As glTF requires, positions become
/// floats, and v is counted from the top. Lengths are meters in glTF: the node of the surface is
/// scaled by MetersPerUnit. This number is also "metersPerUnit" in the extras of the asset. If
/// FloatRounding::isTooCoarse(), positions are relative to the center of the bounding box, and the
/// node is translated to this center.
/// @throws std::invalid_argument if the positions are too large or too small for floats
/// @throws std::length_error if the file would exceed the 4 GiB of the format
/// @throws Aborted
std::string makeGLB(const TexturedSurface& surface, std::string_view png, const Run& run = {});

/// Return the text of an OBJ file that refers to the material "surface" of a material file.
/// @throws Aborted
std::string makeOBJ(
  const TexturedSurface& surface, const std::string& materialFile, const Run& run = {});

/// Return the text of a material file with the material "surface", which shows the texture.
std::string makeMTL(const std::string& textureFile);

/// Write a binary PLY file. Its vertices have the texture coordinates "texture_u" and "texture_v";
/// v is counted from the bottom. A comment "TextureFile" names the picture. Positions are doubles.
/// @throws std::length_error if there are too many points for signed 32-bit ids
/// @throws Aborted
std::string makePLY(
  const TexturedSurface& surface, const std::string& textureFile, const Run& run = {});
}

#endif
