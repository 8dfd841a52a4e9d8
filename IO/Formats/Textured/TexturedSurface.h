/// Writers of textured surfaces: binary glTF 2.0, Wavefront OBJ and PLY.

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
/// Triangles with a picture on them, all numbers finite.
struct TexturedSurface
{
  std::vector<double> Positions;      ///< #P by 3
  std::vector<float> Normals;         ///< #P by 3 of unit length, or empty
  std::vector<float> TexCoords;       ///< #P by 2, v counted from the picture's bottom
  std::vector<std::uint32_t> Corners; ///< #F by 3 point ids, counter-clockwise from outside
  bool RepeatsTexture = false; ///< beyond [0, 1] the picture comes again, instead of its border
  std::string Name;            ///< of the surface, for glTF; none if empty
  double MetersPerUnit = 1.0;  ///< of the positions, for glTF; finite and above 0
};

/// A binary glTF 2.0 file with the picture inside. Positions become floats, as glTF has no
/// other, and v is counted from the top there. Lengths are meters in glTF: the node that shows the
/// surface is scaled by MetersPerUnit, which is "metersPerUnit" in the extras of the asset, too.
/// Where floats would shift a coordinate by more than FloatRounding::MaximumShift of the surface's
/// size, positions count from the middle of its bounding box, and the node is translated there.
/// @throws std::invalid_argument if the positions are too large or too small for floats
/// @throws std::length_error if the file would pass the 4 GiB of the format
/// @throws Aborted
std::string makeGLB(const TexturedSurface& surface, std::string_view png, const Run& run = {});

/// The text of an OBJ file that refers to a material "surface" of the material file.
/// @throws Aborted
std::string makeOBJ(
  const TexturedSurface& surface, const std::string& materialFile, const Run& run = {});

/// The text of a material file whose material "surface" is the texture.
std::string makeMTL(const std::string& textureFile);

/// A binary PLY file with the texture coordinates at the vertices, as "texture_u" and "texture_v"
/// with v upwards, that names the picture in a comment "TextureFile". Positions are doubles.
/// @throws std::length_error if there are more points than a signed 32-bit id counts
/// @throws Aborted
std::string makePLY(
  const TexturedSurface& surface, const std::string& textureFile, const Run& run = {});
}

#endif
