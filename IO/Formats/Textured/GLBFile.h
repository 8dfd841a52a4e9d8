/// Write textured surfaces as binary glTF 2.0 files, with a normal map and levels of detail.

#ifndef ConformalGLBFile_h
#define ConformalGLBFile_h

#include "Base/Run.h"
#include "Textured/TexturedMesh.h"

#include <string>
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

struct GLBContents
{
  /// The surface, and versions of it with ever fewer triangles. At least one. The first surface
  /// defines the name and the unit. All share the pictures.
  std::vector<TexturedSurface> Levels = {};
  std::string Picture = {};   ///< picture as a PNG file or a JPEG file
  std::string NormalMap = {}; ///< normals relative to Tangents, as a PNG or JPEG file; or empty
  /// Compression of points and triangles. Positions are rounded to 1 / 65535 of the surface's size
  /// (Quantized) or 1 / 16383 (Meshopt), and normals and tangents to 8 bits.
  GLBCompression Compression = GLBCompression::None;
};

/// Return a binary glTF 2.0 file that contains a surface and its pictures. As glTF requires,
/// positions become floats, and the texture coordinate v is counted from the top of the picture.
/// glTF measures lengths in meters. The node (scene object) of the surface is therefore scaled by
/// MetersPerUnit. The extras of the asset (further data of the file) contain MetersPerUnit as
/// "metersPerUnit".
///
/// If rounding to floats changes the positions too much (FloatRounding::isTooCoarse()), positions
/// are relative to the center of the bounding box. The translation of the node is this center.
///
/// Levels of detail are nodes of the extension MSFT_lod. Level i is drawn until the surface covers
/// less of the screen than the ratio of the numbers of points of level i + 1 and of the first
/// level. Programs without the extension draw the first level.
/// @throws std::runtime_error for Meshopt, if the build has not found the library meshoptimizer
/// @throws std::invalid_argument if the positions are too large or too small for floats
/// @throws std::length_error if the file would exceed 4 GiB, the limit of the format
/// @throws Aborted if the progress callback of `run` returns false
std::string makeGLB(const GLBContents& contents, const Run& run = {});
}

#endif
