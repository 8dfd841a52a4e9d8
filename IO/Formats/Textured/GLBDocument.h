/// Build binary glTF 2.0 documents: a JSON text with lists of meshes, accessors and buffer views,
/// and one binary buffer.

#ifndef ConformalGLBDocument_h
#define ConformalGLBDocument_h

#include <cstddef>
#include <string>
#include <vector>

namespace conformal
{
/// Component types of accessors, and targets of buffer views, as the specification numbers them.
namespace gltf
{
constexpr int Float = 5126;
constexpr int SignedByte = 5120;
constexpr int UnsignedShort = 5123;
constexpr int UnsignedInt = 5125;
constexpr int ArrayBuffer = 34962;
constexpr int ElementArrayBuffer = 34963;
constexpr int ClampToEdge = 33071;
constexpr int Repeat = 10497;
}

/// Document with one material, and one or more meshes: versions of a surface with ever fewer
/// triangles.
class GLBDocument
{
public:
  std::string Bytes;            ///< binary buffer
  std::string Extensions;       ///< names of required extensions, in quotes, separated by commas
  std::string TextureTransform; ///< of all textures, as JSON that follows "index"; or empty
  std::string Name;             ///< name of node, mesh and material, UTF-8; may be empty
  double MetersPerUnit = 1.0;   ///< further data of the asset
  bool RepeatsTexture = false;

  /// Add a buffer view of the bytes from `begin` on, and return its index.
  /// @param[in] target  ArrayBuffer, ElementArrayBuffer, or 0 for pictures
  /// @param[in] more    further members, as JSON that begins with a comma
  int addView(std::size_t begin, int target, const std::string& more = "");

  /// Add a buffer view of vertices of `stride` bytes each, and return its index.
  int addVertices(const void* vertices, std::size_t count, std::size_t stride);

  /// Add a buffer view of EXT_meshopt_compression, and return its index.
  /// @param[in] mode  members of the extension that define the filter, as JSON
  int addCompressed(const std::string& bytes, std::size_t count, std::size_t stride,
    const std::string& mode, bool isIndices);

  /// Add an accessor, and return its index.
  /// @param[in] more  further members, as JSON that begins with a comma
  int addAccessor(
    int view, int componentType, const char* type, std::size_t count, const std::string& more = "");

  /// Add a mesh of one primitive, and a node that shows it.
  /// @param[in] attributes  members of the primitive's attributes, as JSON
  /// @param[in] corners     accessor of the corners
  /// @param[in] points      number of points, by which levels of detail are chosen
  /// @param[in] placement   transform of the node, as JSON that begins with a comma; or empty
  void addMesh(
    const std::string& attributes, int corners, std::size_t points, const std::string& placement);

  /// Add the base color of the material, a PNG or JPEG file.
  void addPicture(const std::string& picture);
  /// Add the normal map of the material, a PNG or JPEG file.
  void addNormalMap(const std::string& picture);

  /// Return the file. If there are several meshes, their nodes are levels of detail of the first
  /// node, by the extension MSFT_lod. Programs without this extension show the first node.
  /// @throws std::length_error if the file would exceed 4 GiB, the limit of the format
  std::string file() const;

private:
  int addTexture(const std::string& picture);
  std::string nodes() const;
  std::string material() const;
  std::string json() const;

  std::string Views, Accessors, Meshes, Textures, Images; // lists, as JSON
  std::vector<std::string> Placements;                    // of the nodes
  std::vector<std::size_t> NumbersOfPoints;               // of the meshes
  std::size_t FallbackSize = 0; // of the second buffer, which has no bytes
  int NumberOfViews = 0, NumberOfAccessors = 0, NumberOfTextures = 0;
  int Picture = -1, NormalMap = -1; // indices of textures
};
}

#endif
