// Make valid and broken files in the .m format of Gu's MeshLib for tests.
#ifndef GuMeshSamples_h
#define GuMeshSamples_h

#include "../Bytes/MadeBytes.h"

namespace samples
{
inline const std::string& PlainGuMesh()
{
  static const std::string text =
    "# a tetrahedron\nVertex 1 0 0 0\nVertex 2 1.5 0 0\nVertex 3 0 1 0\nVertex 4 0 0 1e-3\n"
    "Face 1 1 3 2\nFace 2 1 2 4\nFace 3 2 3 4\nFace 4 3 1 4\n";
  return text;
}

// Return a mesh with unsorted ids that are not consecutive, with all known traits, and with unknown
// traits.
inline const std::string& RichGuMesh()
{
  static const std::string text =
    "Vertex 70 0 0 0 {sph=(0 0 2) rgb=(1 0 0) uv=(0 0.25) normal=(0 0 1)}\n"
    "Vertex -5 1 0 0 {normal=(0 1 0) father=(3) sph=(1 0 0) sharp uv=(0 0.5)}\n"
    "Vertex 9000000000 0 1 0  { rgb=(0 0.5 1) Opos=(1 2 3) sph=( 0 1 0 ) }\n"
    "Vertex 3 0 0 1 {sph=(0.6 0 0.8)}\n"
    "Edge 70 3 {sharp}\nFace 11 70 9000000000 -5 {rgb=(0 1 0)}\nFace 12 70 -5 3\n"
    "Corner 3 12 {uv=(0 0)}\nFace 9 -5 9000000000 3 {matid=7}\n";
  return text;
}

inline std::vector<std::string> GuMeshFiles()
{
  return { PlainGuMesh(), RichGuMesh(), "Vertex 0 0 0 0\nVertex 1 1 1 1\n" };
}

// Return broken files. Each file breaks a different rule of the format.
inline std::vector<std::string> BadGuMeshFiles()
{
  const auto& plain = PlainGuMesh();
  const auto& rich = RichGuMesh();
  return { replaced(plain, "1.5", "1.2.3"), replaced(plain, "1.5", "--5"),
    replaced(plain, "1.5", "0x1p3"), replaced(plain, "1.5", "1e999"), replaced(plain, "1.5", "1,5"),
    replaced(plain, "1.5", "one"), replaced(plain, "1.5", ""), replaced(plain, "1.5", "nan"),
    replaced(plain, "1.5", "inf"), replaced(plain, "1.5", "1.5 x"), replaced(plain, "1.5", "{"),
    replaced(plain, "Vertex 2", "Vertex 1"), replaced(plain, "Vertex 2", "Vertex"),
    replaced(plain, "Vertex 2", "Vertex 2.5"),
    replaced(plain, "Vertex 2", "Vertex 99999999999999999999"),
    replaced(plain, "Vertex 2", "Vertices 2"), replaced(plain, "Vertex 3", "vertex 3"),
    replaced(plain, "Face 2 1 2 4", "Face 2 1 2 5"),
    replaced(plain, "Face 2 1 2 4", "Face 2 1 2 0"),
    replaced(plain, "Face 2 1 2 4", "Face 2 1 2 x"),
    replaced(plain, "Face 2 1 2 4", "Face 2 1 2 4 {"),
    replaced(plain, "Face 2 1 2 4", "Face 2 1 2 4 rgb"),
    replaced(plain, "Face 2 1 2 4", "Face 2 1 2 4 }"), replaced(plain, "Face 2 1 2 4", "Face"),
    replaced(plain, "Face 2", "Face x"), replaced(plain, "Face 2", "Fase 2"),
    replaced(plain, "Face 1 1 3 2", "Face 1 1 3 9223372036854775807"),
    replaced(rich, "sph=(1 0 0)", ""), replaced(rich, "sph=(1 0 0)", "sph=(0 0 0)"),
    replaced(rich, "sph=(1 0 0)", "sph=(1 0)"), replaced(rich, "sph=(1 0 0)", "sph=(1 nan 0)"),
    replaced(rich, "sph=(1 0 0)", "sph"), replaced(rich, "sph=(1 0 0)", "sph=(1 0 0) sph=(1 0 0)"),
    replaced(rich, "uv=(0 0.5)", "uv=(0 x)"), replaced(rich, "uv=(0 0.5)", "uv=0"),
    replaced(rich, "rgb=(1 0 0)", "rgb=(1 0 300)"), replaced(rich, "rgb=(1 0 0)", "rgb=(-1 0 0)"),
    replaced(rich, "rgb=(0 1 0)", "rgb=(0 1)"), replaced(rich, "normal=(0 1 0)", "normal=(0 1"),
    replaced(rich, "Vertex -5", "Vertex 70"), replaced(rich, "Face 9 -5", "Face 9 5") };
}
}

#endif
