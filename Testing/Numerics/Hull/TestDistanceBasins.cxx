#include "Hull/DistanceBasins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using conformal::DataHole;
using conformal::findOutside;
using conformal::FreudenthalGrid;
using conformal::OutsideNodes;
using conformal::Vector3;

namespace
{
constexpr double Spacing = 0.05, Offset = 0.075;

FreudenthalGrid nodesAround(double halfWidth)
{
  FreudenthalGrid nodes;
  const int size = 2 * static_cast<int>(std::ceil(halfWidth / Spacing)) + 1;
  nodes.Size = { size, size, size };
  nodes.Spacing = Spacing;
  nodes.Origin = Vector3::Constant(-0.5 * Spacing * (size - 1));
  return nodes;
}

// The distance to a unit sphere without the cap around +z whose rim lies at an angle from the axis.
double distanceToShell(const Vector3& x, double angle)
{
  const double across = std::hypot(x[0], x[1]);
  return std::atan2(across, x[2]) >= angle
    ? std::abs(x.norm() - 1.0)
    : std::hypot(across - std::sin(angle), x[2] - std::cos(angle));
}

std::vector<float> shell(const FreudenthalGrid& nodes, double angle)
{
  std::vector<float> distances(nodes.numberOfNodes());
  for (int node = 0; node < nodes.numberOfNodes(); ++node)
  {
    distances[node] = static_cast<float>(distanceToShell(nodes.position(node), angle));
  }
  return distances;
}

OutsideNodes outsideOfShell(const FreudenthalGrid& nodes, double angle, double persistence)
{
  std::vector<float> distances = shell(nodes, angle);
  return findOutside(nodes, distances, Offset, persistence);
}

bool isOutside(const FreudenthalGrid& nodes, const OutsideNodes& found, const Vector3& x)
{
  const Eigen::Vector3i at = nodes.toGrid(x).array().round().cast<int>();
  return found.Outside[nodes.node(at[0], at[1], at[2])] == 1;
}
}

TEST(DistanceBasins, OutsideIsWhatIsBeyondTheOffset)
{
  const FreudenthalGrid nodes = nodesAround(1.4);
  const OutsideNodes found = outsideOfShell(nodes, 0.0, 1.5);
  for (int node = 0; node < nodes.numberOfNodes(); ++node)
  {
    const double radius = nodes.position(node).norm();
    const Eigen::Vector3i at = nodes.coordinates(node);
    const bool isFace = at.minCoeff() == 0 || at.maxCoeff() == nodes.Size[0] - 1;
    if (isFace || std::abs(radius - 1.0 - Offset) > 1e-6)
    {
      ASSERT_EQ(found.Outside[node], isFace || radius > 1.0 + Offset) << radius;
    }
  }
  EXPECT_EQ(found.LargestHole.Saddle, 0.0);
  EXPECT_FALSE(found.Leaks);
}

// The widest place of a round hole is its middle, as far from the data as its rim is wide; the
// deepest place behind it lies on the axis.
TEST(DistanceBasins, ClosesAHoleAndMeasuresIt)
{
  const FreudenthalGrid nodes = nodesAround(1.4);
  for (const double angle : { 0.3, 0.5 })
  {
    const OutsideNodes found = outsideOfShell(nodes, angle, 1.5);
    EXPECT_FALSE(isOutside(nodes, found, Vector3::Zero())) << angle;
    EXPECT_TRUE(isOutside(nodes, found, Vector3(0.0, 0.0, 1.35))) << angle;
    EXPECT_FALSE(found.Leaks);
    EXPECT_NEAR(found.LargestHole.Saddle, std::sin(angle), Spacing) << angle;
    EXPECT_NEAR(found.LargestHole.Peak, 1.0, Spacing) << angle;
  }
}

// What is inside is what is deeper than the hole by a factor: the same hole is open for a larger
// one.
TEST(DistanceBasins, OpensWhatIsNotPersistent)
{
  const FreudenthalGrid nodes = nodesAround(1.4);
  const double angle = 0.5, ratio = 1.0 / std::sin(angle);
  const OutsideNodes closed = outsideOfShell(nodes, angle, 0.85 * ratio);
  EXPECT_FALSE(isOutside(nodes, closed, Vector3::Zero()));
  EXPECT_FALSE(closed.Leaks);
  const OutsideNodes leaking = outsideOfShell(nodes, angle, 1.15 * ratio);
  EXPECT_TRUE(leaking.Leaks); // and so the likeliest is taken, of which data are seen all around
  EXPECT_FALSE(isOutside(nodes, leaking, Vector3::Zero()));
}

TEST(DistanceBasins, AnOpenBowlHasNoInside)
{
  const FreudenthalGrid nodes = nodesAround(1.4);
  const OutsideNodes found = outsideOfShell(nodes, 2.2, 1.5);
  EXPECT_TRUE(isOutside(nodes, found, Vector3::Zero()));
  EXPECT_TRUE(isOutside(nodes, found, Vector3(0.0, 0.0, 1.0)));
}

TEST(DistanceBasins, FacesOfTheGridAreOutside)
{
  const FreudenthalGrid nodes = nodesAround(0.9); // cuts the sphere
  std::vector<float> distances = shell(nodes, 0.0);
  const OutsideNodes found = findOutside(nodes, distances, Offset, 1.5);
  for (int node = 0; node < nodes.numberOfNodes(); ++node)
  {
    const Eigen::Vector3i at = nodes.coordinates(node);
    if (at.minCoeff() == 0 || at.maxCoeff() == nodes.Size[0] - 1)
    {
      ASSERT_EQ(found.Outside[node], 1);
      ASSERT_EQ(distances[node], std::numeric_limits<float>::max());
    }
  }
}
