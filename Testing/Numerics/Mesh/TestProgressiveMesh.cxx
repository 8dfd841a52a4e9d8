#include "Mesh/ProgressiveMesh.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using conformal::Index;
using conformal::Mesh;
using conformal::ProgressiveMesh;

namespace
{
std::vector<std::array<int, 3>> sorted(const conformal::VertexRings& rings)
{
  const conformal::Triangles triangles = rings.triangles();
  std::vector<std::array<int, 3>> result;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    result.push_back({ triangles(r, 0), triangles(r, 1), triangles(r, 2) });
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expectRestored(ProgressiveMesh progressive, const Mesh& mesh)
{
  EXPECT_EQ(progressive.Rings.triangles().rows(), 4);
  for (const auto& split : progressive.Splits)
  {
    progressive.Rings.split(split.Vertex, split.Neighbors);
  }
  EXPECT_EQ(sorted(progressive.Rings),
    sorted(conformal::VertexRings(mesh.Triangles, mesh.Positions.rows())));
}
}

TEST(ProgressiveMesh, SplitsRestoreTheMesh)
{
  const Mesh sphere = conformal::makeGeodesicSphere(12);
  expectRestored(conformal::makeProgressiveMesh(sphere), sphere);
  expectRestored(conformal::makeProgressiveMesh(sphere.Triangles, sphere.Positions.rows()), sphere);
}

// By connectivity alone vertices go in a logarithmic number of rounds: the longest chain of
// vertices each of which needs the one before it is as short, and none has many neighbors when it
// goes.
TEST(ProgressiveMesh, ConnectivityAloneGivesShortChains)
{
  for (const int frequency : { 6, 12, 24, 48 })
  {
    const Mesh sphere = conformal::makeGeodesicSphere(frequency);
    const Index size = sphere.Positions.rows();
    const ProgressiveMesh progressive = conformal::makeProgressiveMesh(sphere.Triangles, size);
    std::vector<int> depths(size, 0);
    int deepest = 0;
    for (const auto& split : progressive.Splits)
    {
      EXPECT_LE(split.Neighbors.size(), 8u);
      int& depth = depths[split.Vertex];
      for (const int neighbor : split.Neighbors)
      {
        depth = std::max(depth, depths[neighbor] + 1);
      }
      deepest = std::max(deepest, depth);
    }
    EXPECT_LT(deepest, 6.0 * std::log2(static_cast<double>(size))) << frequency;
  }
}
