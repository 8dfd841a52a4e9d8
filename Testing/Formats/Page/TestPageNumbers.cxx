#include "Page/PageNumbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

TEST(PageNumbers, RangeIsOfTheFiniteOnes)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const conformal::PageRange range = conformal::rangeOf({ nan, 3.0, -infinity, -2.0, infinity });
  EXPECT_EQ(range.Low, -2.0);
  EXPECT_EQ(range.High, 3.0);
  EXPECT_EQ(conformal::rangeOf({}).High, 0.0);
  EXPECT_EQ(conformal::rangeOf({ nan }).Low, 0.0);
}

TEST(PageNumbers, CodesAreWithinHalfAStepAndExactAtTheEnds)
{
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const conformal::PageRange& range :
    { conformal::PageRange{ -1.5, 7.0 }, conformal::PageRange{ -most, most },
      conformal::PageRange{ 0.0, least }, conformal::PageRange{ 1e6, 1e6 + 1e-3 } })
  {
    for (const std::uint32_t steps : { 1U, 254U, 65535U, 4000000000U })
    {
      EXPECT_EQ(conformal::codeOf(range.Low, range, steps), 0u);
      EXPECT_EQ(conformal::codeOf(range.High, range, steps), steps);
      EXPECT_EQ(conformal::valueOfCode(0, range, steps), range.Low);
      EXPECT_EQ(conformal::valueOfCode(steps, range, steps), range.High);
      for (int i = 0; i <= 100; ++i)
      {
        const double t = i / 100.0;
        const double value = range.Low * (1.0 - t) + range.High * t;
        const std::uint32_t code = conformal::codeOf(value, range, steps);
        ASSERT_LE(code, steps);
        const double error = std::abs(conformal::valueOfCode(code, range, steps) / 2 - value / 2);
        const double step = range.High / steps - range.Low / steps;
        ASSERT_LE(error, 0.26 * step + 1e-16 * std::abs(range.High) + least) << value;
      }
    }
  }
  EXPECT_EQ(conformal::codeOf(5.0, { 5.0, 5.0 }, 65535), 0u);
  EXPECT_EQ(conformal::valueOfCode(0, { 5.0, 5.0 }, 0), 5.0);
}

TEST(PageNumbers, DirectionsComeBackOfAnyLength)
{
  double largest = 0.0;
  for (int i = 0; i <= 180; ++i)
  {
    for (int k = 0; k <= 360; k += 3)
    {
      const double theta = i * std::acos(-1.0) / 180.0;
      const double phi = k * std::acos(-1.0) / 180.0;
      const double n[] = { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
        std::cos(theta) };
      for (const double length : { 1.0, 1e300, 1e-300 })
      {
        const auto back = conformal::octahedralDirection(
          conformal::octahedralCode(length * n[0], length * n[1], length * n[2]));
        largest = std::max(largest, std::hypot(back[0] - n[0], back[1] - n[1], back[2] - n[2]));
      }
    }
  }
  EXPECT_LT(largest, 1e-4);
  EXPECT_GT(largest, 1e-6); // codes are not the numbers themselves
}

// The bytes by hand: lowest ones of all codes first, then the next ones.
TEST(PageNumbers, CodesAreDifferencesWithTheSignBehind)
{
  std::string bytes = "x";
  conformal::appendCodes(bytes, { 3, 2, 258, 65535, 0 }, 2);
  // 3, -1, 256, 65277 = -259 modulo 65536, 1
  EXPECT_EQ(bytes, std::string("x\x06\x01\x00\x05\x02\x00\x00\x02\x02\x00", 11));
  bytes.clear();
  conformal::appendCodes(bytes, { 255, 0, 128 }, 1);
  EXPECT_EQ(bytes, std::string("\x01\x02\xFF", 3)); // -1, 1, -128
  bytes.clear();
  conformal::appendCodes(bytes, { 0xFFFFFFFFU, 0 }, 4);
  EXPECT_EQ(bytes, std::string("\x01\x02\x00\x00\x00\x00\x00\x00", 8));
}

TEST(PageNumbers, MortonCodesTakeBitsInTurn)
{
  EXPECT_EQ(conformal::mortonCode({ 0, 0 }), 0u);
  EXPECT_EQ(conformal::mortonCode({ 0xFFFF, 0 }), 0x55555555u);
  EXPECT_EQ(conformal::mortonCode({ 0, 0xFFFF }), 0xAAAAAAAAu);
  EXPECT_EQ(conformal::mortonCode({ 5, 2 }), 0b011001u);
}
