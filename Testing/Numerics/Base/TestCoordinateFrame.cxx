#include "Base/CoordinateFrame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

using conformal::CoordinateFrame;
using conformal::frameOf;
using conformal::Index;
using conformal::Points;
using conformal::PointView;
using conformal::unitVector;
using conformal::Vector3;

namespace
{
constexpr double Smallest = 5e-324, Largest = std::numeric_limits<double>::max();

Points some()
{
  Points points(4, 3);
  points << 0.1, -1.7, 0.3, 1e-3, 1.0 / 3.0, -0.0, -0.7, 0.2, 0.9, 1.1, 0.0, -1.3;
  return points;
}
}

TEST(CoordinateFrame, PutsTheMaximumCoordinateBetweenOneAndTwo)
{
  for (const double scale : { Smallest, 1e-310, 1e-200, 0.3, 1.0, 1e7, 1e154, 1e200, Largest })
  {
    Points points = Points::Zero(2, 3);
    points(1, 1) = -scale;
    const CoordinateFrame frame = frameOf({ points });
    int exponent = 0;
    EXPECT_EQ(std::frexp(frame.Unit, &exponent), 0.5) << scale; // a power of two
    const double inFrame = -frame.toFrame(points.row(1))[1];
    EXPECT_GE(inFrame, 1.0) << scale;
    EXPECT_LT(inFrame, 2.0) << scale;
    EXPECT_EQ(frame.toFrame(points.row(1))[1] * frame.Unit, -scale);
    EXPECT_EQ((PointView(points.data(), 2, frame.Unit)[1]), frame.toFrame(points.row(1)));
  }
}

TEST(CoordinateFrame, ChangesNoBitOnTheWayThereAndBack)
{
  for (const int exponent : { -900, -3, 0, 1, 25, 1000 })
  {
    const Points points = std::ldexp(1.0, exponent) * some();
    const CoordinateFrame frame = frameOf({ points });
    for (Index i = 0; i < points.rows(); ++i)
    {
      const Vector3 expected = some().row(i), inFrame = frame.toFrame(points.row(i));
      EXPECT_EQ(std::memcmp(expected.data(), inFrame.data(), sizeof(expected)), 0);
      const Vector3 before = points.row(i), back = inFrame * frame.Unit;
      EXPECT_EQ(std::memcmp(before.data(), back.data(), sizeof(before)), 0);
    }
  }
}

TEST(CoordinateFrame, IsThatOfAllPointsThatAreFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  Points points = some();
  points.row(0) = Vector3(1e300, nan, 0.0);
  points.row(1) = Vector3(0.0, infinity, 0.0);
  const float far[] = { 0.0F, 1000.0F, 0.0F };
  EXPECT_EQ(frameOf({ points }).Unit, 1.0);
  EXPECT_EQ(frameOf({ points, PointView(far, 1) }).Unit, 512.0);
  EXPECT_EQ(frameOf({}).Unit, 1.0);
  EXPECT_EQ(frameOf({ Points(Points::Zero(3, 3)) }).Unit, 1.0);
  EXPECT_EQ(frameOf({ Points(Points::Constant(1, 3, nan)) }).Unit, 1.0);
}

TEST(CoordinateFrame, IsThatOfAllProcesses)
{
  // This process says how many numbers it has, then their bits; so does one that has 48.
  int call = 0;
  conformal::Reduce reduce;
  reduce.NumberOfRanks = 2;
  reduce.Sum = [&](std::int64_t* values, Index count)
  {
    ASSERT_EQ(count, 2);
    const double theirs = 48.0;
    ++call == 1 ? void(values[1] = 1) : void(std::memcpy(values + 1, &theirs, sizeof(theirs)));
  };
  EXPECT_EQ(frameOf({ some() }, reduce).Unit, 32.0);
}

TEST(CoordinateFrame, KeepsTheDirectionOfPointsFarAway)
{
  const CoordinateFrame tiny = { 0x1p-1000 };
  EXPECT_EQ(tiny.toFrameFromAfar({ 0x1p-999, 0.0, -0x1p-980 }), Vector3(2.0, 0.0, -0x1p20));
  EXPECT_EQ(tiny.toFrameFromAfar({ 0.0, -1e200, 0.0 }), Vector3(0.0, -0x1p26, 0.0));
  const Vector3 corner = CoordinateFrame().toFrameFromAfar(Vector3::Constant(Largest));
  EXPECT_NEAR((corner - Vector3::Constant(0x1p26 / std::sqrt(3.0))).norm(), 0.0, 1e-7);
  EXPECT_FALSE(tiny.toFrameFromAfar(Vector3::Constant(NAN)).allFinite());
}

TEST(CoordinateFrame, HasUnitVectorsOfAllLengths)
{
  const Vector3 v(0.6, -0.3, 1.1);
  for (const int exponent : { -1000, -500, 0, 500, 1022 })
  {
    const Vector3 unit = unitVector(std::ldexp(1.0, exponent) * v);
    EXPECT_EQ(unit, unitVector(v)) << exponent;
    EXPECT_NEAR((unit - v / v.norm()).norm(), 0.0, 1e-15);
  }
  EXPECT_EQ(unitVector({ 0.0, -Smallest, 0.0 }), Vector3(0.0, -1.0, 0.0));
  EXPECT_NEAR(unitVector(Vector3::Constant(1e-320)).norm(), 1.0, 1e-15);
  EXPECT_NEAR(unitVector(Vector3::Constant(-Largest)).norm(), 1.0, 1e-15);
  EXPECT_FALSE(unitVector(Vector3::Zero()).allFinite());
  EXPECT_FALSE(unitVector({ 1.0, HUGE_VAL, 0.0 }).allFinite());
  EXPECT_FALSE(unitVector({ NAN, 1.0, 0.0 }).allFinite());
}
