/// Pack the vertices of a textured surface into integers, and compress them. The formats are those
/// of the glTF extensions KHR_mesh_quantization and EXT_meshopt_compression. The library
/// meshoptimizer compresses, if the build has found it.

#ifndef ConformalVertexPacking_h
#define ConformalVertexPacking_h

#include "Textured/TexturedMesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace conformal
{
/// Texture coordinates in steps of 1 / Steps from Offset, v counted from the top of the picture.
struct PackedTexCoords
{
  std::vector<std::uint16_t> Values; ///< #P by 2
  std::array<double, 2> Offset = { 0.0, 0.0 };
  std::array<double, 2> Scale = { 1.0, 1.0 }; ///< size of a step
};

/// Positions in steps of Scale from Offset.
struct PackedPositions
{
  std::vector<std::uint16_t> Values; ///< #P by 4; the fourth is 0, for alignment
  std::array<double, 3> Offset = { 0.0, 0.0, 0.0 };
  double Scale = 1.0; ///< size of a step; above 0
};

/// @param[in] bits  number of bits of a coordinate, in [1, 16]
PackedPositions packPositions(const std::vector<double>& positions, int bits);
PackedTexCoords packTexCoords(const std::vector<float>& texCoords, int bits);

/// Round unit vectors to three bytes each.
/// @param[in] fourth  fourth component of each vector, in [-1, 1]: 0 for normals, 1 for tangents
std::vector<std::int8_t> packDirections(const std::vector<float>& vectors, float fourth);

/// Return whether the build has the library meshoptimizer.
bool hasMeshopt();

/// Sort triangles and points so that they compress well. Points that no triangle uses are dropped.
/// @throws std::runtime_error without the library
TexturedSurface sortedForCompression(const TexturedSurface& surface);

/// Compress vertices of `stride` bytes each, a multiple of 4.
/// @throws std::runtime_error without the library
std::string compressVertices(const void* vertices, std::size_t count, std::size_t stride);

/// Convert unit vectors to octahedral coordinates of 8 bits, and compress them; the filter of
/// EXT_meshopt_compression is OCTAHEDRAL, and a vertex has 4 bytes.
/// @param[in] fourth  fourth component of each vector, in [-1, 1]: 0 for normals, 1 for tangents
/// @throws std::runtime_error without the library
std::string compressDirections(const std::vector<float>& vectors, float fourth);

/// Compress ids of the corners of triangles.
/// @param[in] points  number of points
/// @throws std::runtime_error without the library
std::string compressCorners(const std::vector<std::uint32_t>& corners, std::size_t points);
}

#endif
