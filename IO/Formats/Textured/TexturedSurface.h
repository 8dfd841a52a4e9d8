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
/// Textured triangles, all numbers finite.
struct TexturedSurface
{
  std::vector<double> Positions;      ///< #P by 3
  std::vector<float> Normals;         ///< #P by 3 of unit length, or empty
  std::vector<float> TexCoords;       ///< #P by 2, v counted from the bottom of the picture
  std::vector<std::uint32_t> Corners; ///< #F by 3 point ids, counter-clockwise from outside
  /// Whether the picture repeats outside of [0, 1] instead of its border
  bool RepeatsTexture = false;
  std::string Name;           ///< name of the surface, for glTF; none if empty
  double MetersPerUnit = 1.0; ///< unit of the positions, for glTF; finite and above 0
};

/// Write a binary glTF 2.0 file with the picture inside. Positions become floats and v is counted
/// from the top, as glTF requires. Lengths are meters in glTF: the node of the surface is scaled by
/// MetersPerUnit, which is also "metersPerUnit" in the extras of the asset. If floats would shift a
/// coordinate by more than FloatRounding::MaximumShift of the size, positions are relative to the
/// center of the bounding box. The node is then translated there.
/// @throws std::invalid_argument if the positions are too large or too small for floats
/// @throws std::length_error if the file would exceed the 4 GiB of the format
/// @throws Aborted
std::string makeGLB(const TexturedSurface& surface, std::string_view png, const Run& run = {});

/// Write the text of an OBJ file that refers to a material "surface" of the material file.
/// @throws Aborted
std::string makeOBJ(
  const TexturedSurface& surface, const std::string& materialFile, const Run& run = {});

/// Write the text of a material file whose material "surface" is the texture.
std::string makeMTL(const std::string& textureFile);

/// Write a binary PLY file with the texture coordinates at the vertices, as "texture_u" and
/// "texture_v" with v upward. A comment "TextureFile" names the picture. Positions are doubles.
/// @throws std::length_error if there are more points than a signed 32-bit id can count
/// @throws Aborted
std::string makePLY(
  const TexturedSurface& surface, const std::string& textureFile, const Run& run = {});
}

#endif
