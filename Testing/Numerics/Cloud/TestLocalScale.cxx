#include "Cloud/LocalScale.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::FootPoint;
using conformal::Index;
using conformal::LocalScale;
using conformal::Vector3;

namespace
{
FootPoint footIn(Index triangle, double distance)
{
  FootPoint foot;
  foot.Triangle = static_cast<int>(triangle);
  foot.Barycentric = Vector3::Constant(1.0 / 3.0);
  foot.SquareDistance = distance * distance;
  return foot;
}
}

TEST(LocalScale, TellsOutliersFromTheirSurroundings)
{
  const auto mesh = conformal::makeGeodesicSphere(12);
  const auto neighbors = conformal::vertexNeighbors(mesh.Triangles, mesh.Positions.rows());
  LocalScale scale(mesh.Positions.rows(), 4.0);
  // Rough on one half, fine on the other.
  const auto level = [&](Index r)
  { return mesh.Positions(mesh.Triangles(r, 0), 2) > 0.0 ? 0.02 : 0.001; };
  EXPECT_FALSE(scale.outlying(footIn(0, 1.0), mesh.Triangles)); // nothing known yet
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    scale.add(footIn(r, level(r)), mesh.Triangles, 1.0);
  }
  scale.update(neighbors, {});
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    if (std::abs(mesh.Positions(mesh.Triangles(r, 0), 2)) > 0.5) // off the border
    {
      EXPECT_TRUE(scale.outlying(footIn(r, 4.1 * level(r)), mesh.Triangles)) << r;
      EXPECT_FALSE(scale.outlying(footIn(r, 3.9 * level(r)), mesh.Triangles)) << r;
    }
  }
}

// A few far ones hardly raise the scale; where all are far it follows them, round by round.
TEST(LocalScale, FewFarPatternsAreOutliersManyAreNot)
{
  const auto mesh = conformal::makeGeodesicSphere(12);
  const auto neighbors = conformal::vertexNeighbors(mesh.Triangles, mesh.Positions.rows());
  LocalScale scale(mesh.Positions.rows(), 4.0);
  const auto round = [&](int every, double far)
  {
    for (Index r = 0; r < mesh.Triangles.rows(); ++r)
    {
      scale.add(footIn(r, r % every == 0 ? far : 0.001), mesh.Triangles, 1.0);
    }
    scale.update(neighbors, {});
  };
  round(1, 0.001);
  for (int i = 0; i < 5; ++i)
  {
    round(100, 0.5);
    EXPECT_TRUE(scale.outlying(footIn(0, 0.5), mesh.Triangles)) << i;
  }
  for (int i = 0; i < 5; ++i)
  {
    round(1, 0.5);
  }
  EXPECT_FALSE(scale.outlying(footIn(0, 0.5), mesh.Triangles));
}
