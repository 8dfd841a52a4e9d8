#include "Textured/TexturedSurface.h"

#include "../../CommaLocale.h"
#include "TexturedSamples.h"

#include <gtest/gtest.h>

#include <cstring>

using samples::floatAt;
using samples::triangle;
using samples::uint32At;

// OBJ holds texts, PLY doubles.
// Far from the origin positions count from the middle of the surface, and the node is put there.
TEST(TexturedSurface, OBJCountsFromOneAndRefersToItsMaterial)
{
  conformal::TexturedSurface surface = triangle();
  const CommaLocale locale;
  EXPECT_EQ(conformal::makeOBJ(surface, "a.mtl"),
    "mtllib a.mtl\nusemtl surface\n"
    "v 0 0 0\nv 1.5 0 0\nv 0 0.1 -2\n"
    "vt 0 0\nvt 1 0.25\nvt 0.5 1\n"
    "f 1/1 2/2 3/3\n");
  surface.Normals = { 0, 0, 1, 0, 0, 1, 0, 1, 0 };
  const std::string text = conformal::makeOBJ(surface, "a.mtl");
  EXPECT_NE(text.find("vn 0 1 0\nf 1/1/1 2/2/2 3/3/3\n"), std::string::npos);
  EXPECT_NE(conformal::makeMTL("a.png").find("map_Kd a.png\n"), std::string::npos);
}

TEST(TexturedSurface, PLYHasItsCoordinatesAtTheVertices)
{
  const CommaLocale locale;
  conformal::TexturedSurface surface = triangle();
  const std::string ply = conformal::makePLY(surface, "a b.png");
  const std::string header = "ply\nformat binary_little_endian 1.0\ncomment TextureFile a b.png\n"
                             "element vertex 3\n"
                             "property double x\nproperty double y\nproperty double z\n"
                             "property float texture_u\nproperty float texture_v\n"
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  ASSERT_EQ(ply.substr(0, header.size()), header);
  ASSERT_EQ(ply.size(), header.size() + 3 * 32 + 13);
  double y = 0.0;
  std::memcpy(
    &y, ply.data() + header.size() + 64 + 8, 8); // the tests run on little-endian machines
  EXPECT_EQ(y, 0.1);
  EXPECT_EQ(floatAt(ply, header.size() + 32 + 28), 0.25F); // v as it is, upwards
  EXPECT_EQ(ply[header.size() + 96], 3);
  EXPECT_EQ(uint32At(ply, header.size() + 97 + 8), 2u);
  surface.Normals = { 0, 0, 1, 0, 0, 1, 0, 1, 0 };
  EXPECT_EQ(conformal::makePLY(surface, "a b.png").size(),
    ply.size() + std::strlen("property float nx\nproperty float ny\nproperty float nz\n") + 36);
}

// Meters are those of a unit, as the scale of the node, unless they are one.
TEST(TexturedSurface, StopsWhenAsked)
{
  const conformal::Run stop({}, [](double) { return false; });
  EXPECT_THROW(conformal::makeOBJ(triangle(), "", stop), conformal::Aborted);
  EXPECT_THROW(conformal::makePLY(triangle(), "", stop), conformal::Aborted);
}
