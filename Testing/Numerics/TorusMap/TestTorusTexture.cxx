#include "TorusMap/TorusTexture.h"

#include "Tori.h"
#include "TorusMap/ConformalTorusMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using conformal::Index;
using conformal::makeTorusTexture;
using conformal::Mesh;
using conformal::TorusPositions;
using conformal::TorusTexture;

namespace
{
const Mesh& surface()
{
  static const Mesh mesh = tori::gridTorus(30, 20, tori::onHopfTorus);
  return mesh;
}

const TorusPositions& positions()
{
  static const TorusPositions map = conformal::mapToTorus(surface()).Positions;
  return map;
}
}

// Coordinates are those of the map up to whole numbers, and cover the torus without gaps.
TEST(TorusTexture, IsContinuousInEachTriangle)
{
  const TorusTexture texture = makeTorusTexture(positions(), surface().Triangles, { 2, 3 });
  double area = 0.0;
  for (Index t = 0; t < texture.Triangles.rows(); ++t)
  {
    Eigen::Matrix<double, 3, 2> corners;
    for (int k = 0; k < 3; ++k)
    {
      const int point = texture.Triangles(t, k), vertex = texture.VertexIds[point];
      EXPECT_EQ(vertex, surface().Triangles(t, k));
      corners.row(k) = texture.Coordinates.row(point);
      for (int i = 0; i < 2; ++i)
      {
        const double turns = corners(k, i) / (i == 0 ? 2.0 : 3.0) - positions()(vertex, i);
        EXPECT_NEAR(turns, std::round(turns), 1e-12);
        EXPECT_LT(std::abs(corners(k, i)), (i == 0 ? 2.0 : 3.0) * 2.0);
      }
    }
    const Eigen::RowVector2d a = corners.row(1) - corners.row(0),
                             b = corners.row(2) - corners.row(0);
    EXPECT_GT(a[0] * b[1] - a[1] * b[0], 0.0);
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  EXPECT_NEAR(area, 2.0 * 3.0, 1e-9);
}

// Vertices come first, and few are duplicated.
TEST(TorusTexture, DuplicatesFewVertices)
{
  const TorusTexture texture = makeTorusTexture(positions(), surface().Triangles, { 1, 1 });
  const auto size = static_cast<std::size_t>(positions().rows());
  ASSERT_GT(texture.VertexIds.size(), size);
  EXPECT_LT(texture.VertexIds.size(), size + 4 * (30 + 20));
  for (std::size_t v = 0; v < size; ++v)
  {
    EXPECT_EQ(texture.VertexIds[v], static_cast<int>(v));
  }
}

TEST(TorusTexture, RejectsWhatCoversNoTorus)
{
  EXPECT_THROW(makeTorusTexture(positions(), surface().Triangles, { 0, 1 }), std::invalid_argument);
  EXPECT_THROW(
    makeTorusTexture(positions(), surface().Triangles, { 1, -1 }), std::invalid_argument);
  EXPECT_THROW(
    makeTorusTexture(TorusPositions::Zero(positions().rows(), 2), surface().Triangles, { 1, 1 }),
    std::invalid_argument);
  TorusPositions bad = positions();
  bad(3, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(makeTorusTexture(bad, surface().Triangles, { 1, 1 }), std::invalid_argument);
  EXPECT_THROW(
    makeTorusTexture(positions(), surface().Triangles.topRows(5), { 1, 1 }), std::invalid_argument);
}
