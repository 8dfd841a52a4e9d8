#include "Hull/LevelSetSurface.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using conformal::checkGenusZero;
using conformal::FreudenthalGrid;
using conformal::GenusZeroReport;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
FreudenthalGrid grid(int size, double spacing)
{
  FreudenthalGrid result;
  result.Size = { size, size, size };
  result.Spacing = spacing;
  result.Origin = Vector3::Constant(-0.5 * spacing * (size - 1));
  return result;
}

Mesh sphere(int size, double spacing, double radius)
{
  const FreudenthalGrid nodes = grid(size, spacing);
  std::vector<float> values(nodes.numberOfNodes());
  std::vector<std::uint8_t> inside(nodes.numberOfNodes());
  for (int node = 0; node < nodes.numberOfNodes(); ++node)
  {
    values[node] = static_cast<float>(nodes.position(node).norm());
    inside[node] = values[node] < radius;
  }
  return conformal::makeLevelSetSurface(nodes, inside, values, radius);
}
}

TEST(LevelSetSurface, WrapsANode)
{
  const FreudenthalGrid nodes = grid(5, 1.0);
  std::vector<std::uint8_t> inside(nodes.numberOfNodes(), 0);
  inside[nodes.node(2, 2, 2)] = 1;
  const std::vector<float> values(inside.size(), 0.0F);
  const Mesh surface = conformal::makeLevelSetSurface(nodes, inside, values, 1.0);
  EXPECT_EQ(surface.Positions.rows(), 14); // one for each neighbor, half way
  EXPECT_EQ(surface.Triangles.rows(), 24);
  for (Index i = 0; i < 14; ++i)
  {
    const double square = 4.0 * surface.Positions.row(i).squaredNorm();
    EXPECT_DOUBLE_EQ(square, std::round(square));
    EXPECT_LE(square, 3.0);
  }
}

// The surface of a set and the set itself: twice the Euler number.
TEST(LevelSetSurface, IsClosedAndOfTheSetsTopology)
{
  std::mt19937 random(2);
  const FreudenthalGrid nodes = grid(9, 0.25);
  const std::vector<float> values(nodes.numberOfNodes(), 0.0F);
  for (int i = 0; i < 20; ++i)
  {
    std::vector<std::uint8_t> inside(nodes.numberOfNodes(), 0);
    conformal::forInnerRows(nodes, {},
      [&](int first, int last)
      {
        for (int node = first; node < last; ++node)
        {
          inside[node] = random() % 20 <= static_cast<unsigned int>(i);
        }
      });
    const Mesh surface = conformal::makeLevelSetSurface(nodes, inside, values, 1.0);
    const GenusZeroReport report =
      checkGenusZero(surface.Triangles, surface.Positions.rows(), surface.Positions);
    ASSERT_TRUE(report.closed());
    ASSERT_TRUE(report.manifold());
    ASSERT_TRUE(report.InconsistentEdges.empty());
    ASSERT_TRUE(report.IsolatedPoints.empty());
    ASSERT_GT(conformal::signedVolume(surface.Positions, surface.Triangles), 0.0);
    ASSERT_EQ(report.EulerNumber, 2 * conformal::eulerNumber(nodes, inside));
  }
}

TEST(LevelSetSurface, LiesOnTheLevel)
{
  const double radius = 0.8;
  const Mesh surface = sphere(43, 0.05, radius);
  const GenusZeroReport report =
    checkGenusZero(surface.Triangles, surface.Positions.rows(), surface.Positions);
  EXPECT_TRUE(report.isGenusZero());
  EXPECT_TRUE(report.DegenerateTriangles.empty());
  for (Index i = 0; i < surface.Positions.rows(); ++i)
  {
    // Off the sphere by no more than an edge's sagitta, 3 h^2 / (8 r).
    ASSERT_NEAR(surface.Positions.row(i).norm(), radius, 0.0013);
  }
  EXPECT_NEAR(conformal::signedVolume(surface.Positions, surface.Triangles),
    4.0 / 3.0 * 3.14159265358979 * std::pow(radius, 3), 0.01);
}

TEST(LevelSetSurface, SmoothingEvensOutWithoutShrinking)
{
  Mesh surface = sphere(43, 0.05, 0.8);
  Points& positions = surface.Positions;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.01, 0.01);
  for (Index i = 0; i < positions.rows(); ++i)
  {
    positions.row(i) *= 1.0 + noise(random);
  }
  const auto roughness = [&]()
  { return std::sqrt((positions.rowwise().norm().array() - 0.8).square().mean()); };
  const double volume = conformal::signedVolume(positions, surface.Triangles), rough = roughness();
  const Points before = positions;
  conformal::smoothSurface(positions, surface.Triangles, 0);
  EXPECT_EQ(positions, before);
  conformal::smoothSurface(positions, surface.Triangles, 10);
  EXPECT_LT(roughness(), 0.5 * rough);
  EXPECT_NEAR(conformal::signedVolume(positions, surface.Triangles) / volume, 1.0, 0.005);
}
