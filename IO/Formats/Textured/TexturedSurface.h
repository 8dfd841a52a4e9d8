/// Write textured surfaces in three formats: binary glTF 2.0, Wavefront OBJ and PLY.

#ifndef ConformalTexturedSurface_h
#define ConformalTexturedSurface_h

#include "Base/Run.h"
#include "Bytes/ParseStatus.h"
#include "Textured/TexturedMesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
/// Compression of the points and triangles of a glTF file.
enum class GLBCompression
{
  None,      ///< floats and 32-bit ids
  Quantized, ///< integers of 8 and 16 bits, by the extension KHR_mesh_quantization
  /// Integers of 8, 13, 14 and 32 bits, compressed by the extension EXT_meshopt_compression. The
  /// extension KHR_texture_transform scales texture coordinates. Points and triangles are sorted.
  Meshopt
};

/// Write a binary glTF 2.0 file that contains a surface and its picture. As glTF requires,
/// positions become floats, and the texture coordinate v is counted from the top of the picture.
/// glTF measures lengths in meters. The node (scene object) of the surface is therefore scaled by
/// MetersPerUnit. The extras of the asset (further data of the file) contain MetersPerUnit as
/// "metersPerUnit".
///
/// If rounding to floats changes the positions too much (FloatRounding::isTooCoarse()), positions
/// are relative to the center of the bounding box. The translation of the node is this center.
/// @param[in] picture  picture as a PNG file or a JPEG file
/// @param[in] compression  compression of points and triangles. Positions are rounded to 1 / 65535
/// of
///   the surface's size (Quantized) or 1 / 16383 (Meshopt), and normals to 8 bits.
/// @throws std::runtime_error for Meshopt, if the build has not found the library meshoptimizer
/// @throws std::invalid_argument if the positions are too large or too small for floats
/// @throws std::length_error if the file would exceed 4 GiB, the limit of the format
/// @throws Aborted if the progress callback of `run` returns false
std::string makeGLB(const TexturedSurface& surface, std::string_view picture, const Run& run = {},
  GLBCompression compression = GLBCompression::None);

/// Return the text of an OBJ file. The text names the file `materialFile`, and its material
/// "surface" as the material of all triangles.
/// @throws Aborted if the progress callback of `run` returns false
std::string makeOBJ(
  const TexturedSurface& surface, const std::string& materialFile, const Run& run = {});

/// Return the text of a material file (MTL). Its only material, "surface", shows the texture.
std::string makeMTL(const std::string& textureFile);

/// Write a binary PLY file. Positions are doubles. The vertices have the texture coordinates
/// "texture_u" and "texture_v", with v counted from the bottom of the picture. A header line
/// "comment TextureFile" contains the name of the picture.
/// @throws std::length_error if there are too many points for signed 32-bit ids
/// @throws Aborted if the progress callback of `run` returns false
std::string makePLY(
  const TexturedSurface& surface, const std::string& textureFile, const Run& run = {});
}

#endif
