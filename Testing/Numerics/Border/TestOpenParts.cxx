#include "Border/OpenParts.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

using conformal::Border;
using conformal::BorderOptions;
using conformal::Index;
using conformal::Mesh;
using conformal::OpenParts;
using conformal::Vector3;

namespace
{
const Mesh& sphere()
{
  static const Mesh mesh = conformal::makeGeodesicSphere(40);
  return mesh;
}

std::vector<double> supportWithout(const std::function<bool(const Vector3&)>& isBare)
{
  std::vector<double> support(sphere().Positions.rows());
  for (Index v = 0; v < sphere().Positions.rows(); ++v)
  {
    support[v] = isBare(sphere().Positions.row(v)) ? 0.0 : 1.0;
  }
  return support;
}

OpenParts partsOf(const std::vector<double>& support, Border border, double holeSize = 0.0)
{
  BorderOptions options;
  options.Border = border;
  options.HoleSize = holeSize;
  return conformal::findOpenParts(sphere(), support, options);
}

// Part of the sphere above a height, after Archimedes.
double capArea(double height)
{
  return 0.5 * (1.0 - height);
}
}

TEST(OpenParts, AHoleIsFilledAndHalfASphereIsOpen)
{
  const auto hole = supportWithout([](const Vector3& x) { return x[2] > 0.7; });
  const auto half = supportWithout([](const Vector3& x) { return x[2] > 0.0; });
  for (const Border border : { Border::Automatic, Border::Closed })
  {
    EXPECT_FALSE(partsOf(hole, border).any());
  }
  EXPECT_FALSE(partsOf(half, Border::Closed).any());
  EXPECT_NEAR(partsOf(hole, Border::Automatic).LargestFraction, capArea(0.7), 0.01);
  EXPECT_NEAR(partsOf(half, Border::Automatic).Fraction, 0.5, 0.02);
  EXPECT_NEAR(partsOf(hole, Border::Open).Fraction, capArea(0.7), 0.01);
}

TEST(OpenParts, NothingIsOpenWherePointsAreEverywhere)
{
  const auto full = supportWithout([](const Vector3&) { return false; });
  EXPECT_FALSE(partsOf(full, Border::Open).any());
  EXPECT_EQ(partsOf(full, Border::Open).LargestFraction, 0.0);
}

TEST(OpenParts, HoleSizeSaysWhichHolesAreFilled)
{
  // Caps of radius 0.87 at one pole, and of radius 0.3 at the other.
  const auto two = supportWithout([](const Vector3& x) { return x[2] > 0.5 || x[2] < -0.953; });
  const auto isOpenBelow = [](const OpenParts& parts)
  {
    Index lowest = 0;
    sphere().Positions.col(2).minCoeff(&lowest);
    return parts.Marks[lowest] == 1;
  };
  EXPECT_FALSE(isOpenBelow(partsOf(two, Border::Open)));
  EXPECT_FALSE(isOpenBelow(partsOf(two, Border::Open, 0.4)));
  EXPECT_TRUE(isOpenBelow(partsOf(two, Border::Open, 0.2)));
  EXPECT_TRUE(partsOf(two, Border::Open, 2.0).any()); // the largest part is always open
}

// A ring without points separates a cap from the rest.
TEST(OpenParts, IslandsAreLeftOut)
{
  const auto ring = supportWithout([](const Vector3& x) { return x[2] > 0.2 && x[2] < 0.8; });
  const OpenParts parts = partsOf(ring, Border::Automatic);
  EXPECT_NEAR(parts.Fraction, 0.3, 0.02);
  EXPECT_NEAR(parts.IslandFraction, capArea(0.8), 0.02);
  for (Index v = 0; v < sphere().Positions.rows(); ++v)
  {
    EXPECT_EQ(parts.Marks[v] == 1, sphere().Positions(v, 2) > 0.2);
  }
}
