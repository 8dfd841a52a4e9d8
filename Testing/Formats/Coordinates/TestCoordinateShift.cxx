#include "Coordinates/CoordinateShift.h"

#include "../Bytes/ParsedArrays.h"

#include <algorithm>
#include <cmath>
#include <limits>

using conformal::NamedArray;
using conformal::ScalarType;
using samples::values;

namespace
{
NamedArray cloudOf(const std::vector<double>& coordinates)
{
  NamedArray points = conformal::makeArray("Points", ScalarType::Float64, 3);
  points.Values.resize(coordinates.size() * sizeof(double));
  const auto* bytes = reinterpret_cast<const unsigned char*>(coordinates.data());
  std::copy_n(bytes, points.Values.size(), points.Values.data());
  return points;
}
}

TEST(CoordinateShift, KeepsNearCoordinatesAsFloats)
{
  NamedArray points = cloudOf({ 0.001, -3, 5, 7.125, 8, 9 });
  EXPECT_TRUE(conformal::storeCoordinates(points, 0.001, true).empty());
  EXPECT_EQ(points.Type, ScalarType::Float32);
  EXPECT_EQ(values<float>(points), (std::vector<float>{ 0.001F, -3, 5, 7.125F, 8, 9 }));
}

TEST(CoordinateShift, SubtractsARoundVectorFromFarCoordinates)
{
  const std::vector<double> file = { 412345.678, 5318000.001, 499.999, 412385.001, 5318012, 503.5 };
  NamedArray points = cloudOf(file);
  const std::vector<double> shift = conformal::storeCoordinates(points, 0.001, true);
  EXPECT_EQ(shift, (std::vector<double>{ 412370, 5318010, 500 }));
  ASSERT_EQ(points.Type, ScalarType::Float32);
  const std::vector<float> near = values<float>(points);
  for (std::size_t i = 0; i < file.size(); ++i)
  {
    // The integers of the file can be computed from the floats.
    EXPECT_EQ(std::llround((near[i] + shift[i % 3]) / 0.001), std::llround(file[i] / 0.001));
  }
  NamedArray kept = cloudOf(file);
  EXPECT_TRUE(conformal::storeCoordinates(kept, 0.001, false).empty());
  EXPECT_EQ(values<double>(kept), file);
}

TEST(CoordinateShift, FloatsSufficeUpToTheQuarterOfTheResolution)
{
  const double limit = 4194304; // 2^22
  NamedArray inside = cloudOf({ -limit, 0, 0, limit, 0, 0 });
  NamedArray outside = cloudOf({ -limit, 0, 0, limit + 1, 0, 0 });
  EXPECT_TRUE(conformal::storeCoordinates(inside, 1.0, true).empty());
  EXPECT_TRUE(conformal::storeCoordinates(outside, 1.0, true).empty());
  EXPECT_EQ(inside.Type, ScalarType::Float32);
  EXPECT_EQ(outside.Type, ScalarType::Float64);
  EXPECT_EQ(values<double>(outside), (std::vector<double>{ -limit, 0, 0, limit + 1, 0, 0 }));
}

TEST(CoordinateShift, KeepsDoublesOfUnknownResolution)
{
  NamedArray near = cloudOf({ 0.1, 0.2, 0.3, 4, 5, 6 });
  EXPECT_TRUE(conformal::storeCoordinates(near, 0.0, true).empty());
  EXPECT_EQ(values<double>(near), (std::vector<double>{ 0.1, 0.2, 0.3, 4, 5, 6 }));
  NamedArray far = cloudOf({ 1000000.1, 0, 0, 1000001.3, 0, 0 });
  EXPECT_EQ(conformal::storeCoordinates(far, 0.0, true), (std::vector<double>{ 1000001, 0, 0 }));
  EXPECT_EQ(values<double>(far),
    (std::vector<double>{ 1000000.1 - 1000001, 0, 0, 1000001.3 - 1000001, 0, 0 }));
}

TEST(CoordinateShift, AcceptsEmptySingleAndExtremeClouds)
{
  NamedArray empty = cloudOf({});
  EXPECT_TRUE(conformal::storeCoordinates(empty, 0.001, true).empty());
  EXPECT_EQ(empty.Type, ScalarType::Float32);
  NamedArray single = cloudOf({ 412345.678, 5318000.001, 499.999 });
  EXPECT_TRUE(conformal::storeCoordinates(single, 0.001, true).empty());
  EXPECT_EQ(values<double>(single), (std::vector<double>{ 412345.678, 5318000.001, 499.999 }));
  const double huge = std::numeric_limits<double>::max();
  NamedArray extreme = cloudOf({ -huge, 0, 0, huge, 0, 0 });
  EXPECT_TRUE(conformal::storeCoordinates(extreme, huge, true).empty());
  EXPECT_EQ(values<double>(extreme), (std::vector<double>{ -huge, 0, 0, huge, 0, 0 }));
  NamedArray distant = cloudOf({ 1e258, 0, 0, 1e258, 4e-97, 0 });
  const std::vector<double> shift = conformal::storeCoordinates(distant, 0.0, true);
  ASSERT_EQ(shift.size(), 3u);
  EXPECT_EQ(shift[0], 1e258);
  EXPECT_NEAR(shift[1], 2e-97, 1e-110);
}
