#include "Hull/IndicatorGrid.h"
#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Aborted;
using conformal::FreudenthalGrid;
using conformal::Index;
using conformal::Indicator;
using conformal::indicatorOn;
using conformal::Pi;
using conformal::Points;
using conformal::Vector3;
using conformal::WindingNumbers;

namespace
{
constexpr double Width = 0.05;

// A grid of odd size, so that the coarse nodes do not end with it.
FreudenthalGrid gridOf(double spacing)
{
  FreudenthalGrid grid;
  grid.Spacing = spacing;
  const int size = 2 * static_cast<int>(1.3 / spacing) + 1;
  grid.Size = { size, size + 1, size + 2 };
  grid.Origin = Vector3::Constant(-0.5 * spacing * (size - 1));
  return grid;
}

// On a unit sphere, spread evenly.
Points evenSphere()
{
  return spheres::spiral(4000);
}

Points shares(const Points& points)
{
  return 4.0 * Pi / 4000.0 * points; // of a whole sphere's area
}
}

TEST(IndicatorGrid, TellsTheInsideOfASphere)
{
  const Points points = evenSphere();
  const FreudenthalGrid grid = gridOf(0.04);
  const Indicator indicator = indicatorOn(grid, WindingNumbers(points), shares(points), Width);
  EXPECT_NEAR(indicator.Level, 0.5, 0.03);
  ASSERT_EQ(static_cast<Index>(indicator.Values.size()), grid.numberOfNodes());
  for (int node = 0; node < static_cast<int>(grid.numberOfNodes()); ++node)
  {
    const double radius = grid.position(node).norm();
    if (std::abs(radius - 1.0) > 0.15)
    {
      EXPECT_NEAR(indicator.Values[node], radius < 1.0 ? 1.0 : 0.0, 0.02) << radius;
    }
    else if (std::abs(radius - 1.0) > 0.03)
    {
      EXPECT_EQ(indicator.Values[node] > indicator.Level, radius < 1.0) << radius;
    }
  }
}

// Without its cap: where nodes were interpolated, evaluation says the same.
TEST(IndicatorGrid, InterpolatesOnlyWhereItMay)
{
  Points points = evenSphere();
  Index size = 0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (points(i, 2) < 0.8)
    {
      points.row(size++) = Vector3(points.row(i));
    }
  }
  points.conservativeResize(size, 3);
  const FreudenthalGrid grid = gridOf(0.08);
  const WindingNumbers cloud(points);
  const Indicator indicator = indicatorOn(grid, cloud, shares(points), Width);
  Points places(grid.numberOfNodes(), 3);
  for (int node = 0; node < static_cast<int>(places.rows()); ++node)
  {
    places.row(node) = grid.position(node);
  }
  const Eigen::VectorXd exact = cloud.at(places, cloud.sources(shares(points)), Width);
  for (int z = 1; z + 1 < grid.Size[2]; ++z)
  {
    for (int y = 1; y + 1 < grid.Size[1]; ++y)
    {
      for (int x = 1; x + 1 < grid.Size[0]; ++x)
      {
        // Blurred as it is defined.
        double expected = 0.0;
        for (int k = 0; k < 27; ++k)
        {
          const int dx = k % 3 - 1, dy = k / 3 % 3 - 1, dz = k / 9 - 1;
          expected += exact[grid.node(x + dx, y + dy, z + dz)] /
            std::pow(2.0, 3 + std::abs(dx) + std::abs(dy) + std::abs(dz));
        }
        EXPECT_NEAR(indicator.Values[grid.node(x, y, z)], expected, 0.03)
          << grid.position(grid.node(x, y, z)).transpose();
      }
    }
  }
}

TEST(IndicatorGrid, ReportsAndStops)
{
  const Points points = evenSphere();
  const FreudenthalGrid grid = gridOf(0.04);
  const WindingNumbers cloud(points);
  runs::Watch watch;
  indicatorOn(grid, cloud, shares(points), Width, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_THROW(indicatorOn(grid, cloud, shares(points), Width, runs::stoppingAt(0.5)), Aborted);
}
