// Make valid and broken PLY files for tests.
#ifndef PLYSamples_h
#define PLYSamples_h

#include "../Bytes/MadeBytes.h"

#include <string>
#include <vector>

namespace samples
{
// Return a tetrahedron with all kinds of attributes, and with unknown elements before and after the
// known elements.
inline const std::string& AsciiMesh()
{
  static const std::string text = "ply\n"
                                  "format ascii 1.0\n"
                                  "comment a comment\n"
                                  "obj_info some info\n"
                                  "element camera 1\n"
                                  "property float focal\n"
                                  "property list uchar float lens\n"
                                  "element vertex 4\n"
                                  "property float x\n"
                                  "property float y\n"
                                  "property float z\n"
                                  "property float nx\n"
                                  "property float ny\n"
                                  "property float nz\n"
                                  "property uchar red\n"
                                  "property uchar green\n"
                                  "property uchar blue\n"
                                  "property float s\n"
                                  "property float t\n"
                                  "property double confidence\n"
                                  "property short label\n"
                                  "element face 4\n"
                                  "property int group\n"
                                  "property list uchar int vertex_indices\n"
                                  "end_header\n"
                                  "35.5 2 0.1 0.2\n"
                                  "0 0 0  0 0 1  1 2 3  0 0.25 0.5 -1\n"
                                  "1 0 0  0 1 0  4 5 6  0 0.5 0.25 -2\n"
                                  "0 1 0  1 0 0  7 8 9  1 0.75 0.125 -3\n"
                                  "0 0 1  0 0 -1  250 251 252  1 1 1e-3 32767\n"
                                  "7 3 0 2 1\n"
                                  "8 3 0 1 3\n"
                                  "9 3 1 2 3\n"
                                  "10 3 2 0 3\n";
  return text;
}

inline const std::string& AsciiCloud()
{
  static const std::string text = "ply\n"
                                  "format ascii 1.0\n"
                                  "element vertex 3\n"
                                  "property double x\n"
                                  "property double y\n"
                                  "property double z\n"
                                  "end_header\n"
                                  "0.5 1.5 2.5\n"
                                  "1234567.123456789 -1e-3 .25\n"
                                  "7 8 9\n";
  return text;
}

inline const std::string& AsciiStrips()
{
  static const std::string text = "ply\n"
                                  "format ascii 1.0\n"
                                  "element vertex 6\n"
                                  "property float x\n"
                                  "property float y\n"
                                  "property float z\n"
                                  "element tristrips 1\n"
                                  "property list int int vertex_indices\n"
                                  "end_header\n"
                                  "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n"
                                  "12 0 1 2 3 -1 2 3 3 4 5 -1 0\n";
  return text;
}

// Return a range grid of 3 by 3 cells. One cell has no point, and the last column has a different
// depth.
inline const std::string& AsciiGrid()
{
  static const std::string text = "ply\n"
                                  "format ascii 1.0\n"
                                  "obj_info num_cols 3\n"
                                  "obj_info num_rows 3\n"
                                  "element vertex 8\n"
                                  "property float x\n"
                                  "property float y\n"
                                  "property float z\n"
                                  "element range_grid 9\n"
                                  "property list uchar int vertex_indices\n"
                                  "end_header\n"
                                  "0 0 0.5\n1 0 0\n2 0 9\n"
                                  "0 -1 0\n1 -1 0\n2 -1 9\n"
                                  "1 -2 0\n2 -2 9\n"
                                  "1 0\n1 1\n1 2\n1 3\n1 4\n1 5\n0\n1 6\n1 7\n";
  return text;
}

// Return the header of a binary file, big-endian or little-endian, to which the data are added.
inline Bytes Binary(bool isBig, const std::string& header)
{
  return Bytes(isBig,
    "ply\nformat binary_" + std::string(isBig ? "big" : "little") + "_endian 1.0\n" + header +
      "end_header\n");
}

// Return the mesh of AsciiMesh() as a binary file, with properties in a different order.
inline std::string BinaryMesh(bool isBig)
{
  Bytes file = Binary(isBig,
    "element face 4\n"
    "property list uint8 uint32 vertex_index\n"
    "property int32 group\n"
    "element unknown 2\n"
    "property list ushort double numbers\n"
    "element vertex 4\n"
    "property float32 z\n"
    "property int16 label\n"
    "property float32 x\n"
    "property float32 y\n"
    "property float64 confidence\n"
    "property uint8 red\n"
    "property uint8 green\n"
    "property uint8 blue\n");
  using Ids = std::vector<std::uint32_t>;
  const Ids faces[] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  for (int i = 0; i < 4; ++i)
  {
    file.add<std::uint8_t>(3).add(faces[i]).add<std::int32_t>(7 + i);
  }
  file.add<std::uint16_t>(0).add<std::uint16_t>(2).add(0.5).add(0.25);
  const float xyz[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const std::int16_t labels[] = { -1, -2, -3, 32767 };
  const double confidences[] = { 0.5, 0.25, 0.125, 1e-3 };
  const std::vector<std::uint8_t> colors[] = { { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 },
    { 250, 251, 252 } };
  for (int i = 0; i < 4; ++i)
  {
    file.add(xyz[i][2]).add(labels[i]).add(xyz[i][0]).add(xyz[i][1]).add(confidences[i]);
    file.add(colors[i]);
  }
  return file.bytes();
}

inline std::string BinaryCloud(bool isBig)
{
  return Binary(isBig, "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n")
    .add(std::vector<float>{ 1.5F, -2.25F, 3.0F, 1e-30F, 1e30F, 0.1F })
    .bytes();
}

inline std::vector<std::string> PLYFiles()
{
  return { AsciiMesh(), AsciiCloud(), AsciiStrips(), AsciiGrid(), BinaryMesh(false),
    BinaryMesh(true), BinaryCloud(false), BinaryCloud(true) };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadPLYFiles()
{
  const auto& mesh = AsciiMesh();
  const std::string binary = BinaryMesh(true);
  return { replaced(mesh, "ascii", "ebcdic"), replaced(mesh, "ascii 1.0", "ascii 2.0"),
    replaced(mesh, "format ascii 1.0\n", ""),
    replaced(mesh, "comment a", "format ascii 1.0\ncomment a"),
    replaced(mesh, "obj_info some", "vertices 4"),
    replaced(mesh, "element camera 1", "element camera"),
    replaced(mesh, "element camera 1", "element camera -1"),
    replaced(mesh, "element camera 1", "element camera 1x"),
    replaced(mesh, "vertex 4", "vertex 99999999999999999999"),
    replaced(mesh, "vertex 4", "vertex 999999999"), replaced(mesh, "vertex 4", "vertex 5"),
    replaced(mesh, "vertex 4", "vertex 3"), replaced(mesh, "element camera 1\n", ""),
    replaced(mesh, "element camera", "element vertex"),
    replaced(mesh, "property float y", "property float x"),
    replaced(mesh, "property float y", "property quaternion y"),
    replaced(mesh, "property float y", "property float"), replaced(mesh, "property float y\n", ""),
    replaced(mesh, "list uchar int", "list float int"), replaced(mesh, "uchar int", "uchar float"),
    replaced(mesh, "vertex_indices", "corners"), replaced(mesh, "end_header", "end_head"),
    replaced(mesh, "1 0 0  0 1 0", "1.2.3 0 0  0 1 0"),
    replaced(mesh, "1 0 0  0 1 0", "nan 0 0  0 1 0"),
    replaced(mesh, "1 0 0  0 1 0", "1e999 0 0  0 1 0"),
    replaced(mesh, "1 0 0  0 1 0", "1,5 0 0  0 1 0"), replaced(mesh, "4 5 6", "4 256 6"),
    replaced(mesh, "8 3 0 1 3", "8 3 0 1 4"), replaced(mesh, "8 3 0 1 3", "8 3 0 1 -1"),
    replaced(mesh, "8 3 0 1 3", "8 -3 0 1 3"), replaced(mesh, "8 3 0 1 3", "8 4 0 1 3"),
    replaced(mesh, "face 4", "face 5"), replaced(mesh, "face 4", "face 4294967296"),
    replaced(mesh, "35.5 2 0.1", "35.5 200 0.1"), mesh.substr(0, mesh.size() / 2),
    binary.substr(0, binary.size() - 1), binary.substr(0, 30),
    replaced(AsciiGrid(), "num_rows 3", "num_rows 2"), replaced(AsciiStrips(), "4 5", "4 6") };
}
}

#endif
