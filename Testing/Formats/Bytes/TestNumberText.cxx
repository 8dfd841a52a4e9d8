#include "Bytes/NumberText.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace
{
template <typename T>
T valueOf(std::string_view text)
{
  T value = T();
  EXPECT_EQ(conformal::readNumber(text, value), text.size()) << text;
  return value;
}

template <typename T>
bool isRefused(std::string_view text)
{
  T value = T();
  return conformal::readNumber(text, value) == 0;
}
}

TEST(NumberText, ReadsNumbers)
{
  EXPECT_EQ(valueOf<double>("0.1"), 0.1);
  EXPECT_EQ(valueOf<float>("0.1"), 0.1F);
  EXPECT_EQ(valueOf<double>("+.5e1"), 5.0);
  EXPECT_EQ(valueOf<double>("-7."), -7.0);
  EXPECT_EQ(valueOf<double>("1234567.123456789"), 1234567.123456789);
  EXPECT_EQ(valueOf<int>("+12"), 12);
  EXPECT_EQ(valueOf<std::int8_t>("-128"), -128);
  EXPECT_TRUE(std::isnan(valueOf<float>("nan")));
  EXPECT_TRUE(std::isinf(valueOf<double>("-inf")));
}

TEST(NumberText, StopsAtBlanks)
{
  int value = 0;
  for (const char* text : { "12 3", "12\t3", "12\r\n", "12\n" })
  {
    EXPECT_EQ(conformal::readNumber(text, value), 2u);
    EXPECT_EQ(value, 12);
  }
}

TEST(NumberText, WhatIsTooSmallIsZero)
{
  EXPECT_EQ(valueOf<double>("1e-400"), 0.0);
  EXPECT_EQ(valueOf<float>("1.5E-60"), 0.0F);
  EXPECT_EQ(valueOf<float>("0." + std::string(60, '0') + "1"), 0.0F);
  EXPECT_EQ(valueOf<float>("1e-42"), 1e-42F);
}

TEST(NumberText, RefusesWhatIsNoNumber)
{
  for (const char* text : { "", "x", "1.2.3", "--5", "+-5", "0x1p3", "1,5", "1e999", "-1e999", "5;",
         "1.#QNAN", "+", "." })
  {
    EXPECT_TRUE(isRefused<double>(text)) << text;
  }
  for (const char* text : { "", "1.0", "256", "-1", "0x10", "1e2" })
  {
    EXPECT_TRUE(isRefused<std::uint8_t>(text)) << text;
  }
}

TEST(NumberText, WritesWhatReadsBackTheSame)
{
  for (const double number : { 0.1, -1.0 / 3.0, 1e300, 5e-324, 0.0, 1234567.123456789 })
  {
    std::string text;
    conformal::appendNumber(text, number);
    EXPECT_EQ(valueOf<double>(text), number);
  }
}
