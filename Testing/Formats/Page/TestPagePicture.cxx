#include "Page/PagePicture.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
std::vector<unsigned char> ramp(std::size_t count)
{
  std::vector<unsigned char> values(count);
  std::iota(values.begin(), values.end(), static_cast<unsigned char>(0));
  return values;
}
}

TEST(PagePicture, SmallOnesStayAndLoseTheirOpacity)
{
  const std::vector<unsigned char> pixels = ramp(2 * 3 * 4);
  const conformal::PagePicture picture = conformal::shrunkPicture(pixels.data(), 2, 3, 4, 3);
  EXPECT_EQ(picture.Width, 2u);
  EXPECT_EQ(picture.Height, 3u);
  ASSERT_EQ(picture.Pixels.size(), 18u);
  for (std::size_t i = 0; i < 18; ++i)
  {
    EXPECT_EQ(picture.Pixels[i], pixels[i / 3 * 4 + i % 3]);
  }
}

TEST(PagePicture, HalvesAreMeansOfFour)
{
  std::vector<unsigned char> pixels(4 * 2 * 3, 0);
  pixels[0] = 100;                 // red, at the first pixel of the first row
  pixels[3 * 4 + 3 * 2 + 1] = 200; // green, at the third of the second
  const conformal::PagePicture picture = conformal::shrunkPicture(pixels.data(), 4, 2, 3, 2);
  EXPECT_EQ(picture.Width, 2u);
  EXPECT_EQ(picture.Height, 1u);
  EXPECT_EQ(picture.Pixels, (std::vector<unsigned char>{ 25, 0, 0, 0, 50, 0 }));
}

// 3 pixels to 2: each new one covers one old pixel and half of another.
TEST(PagePicture, PixelsCountByTheirSharesOfTheArea)
{
  const unsigned char pixels[] = { 30, 0, 0, 90, 0, 0, 240, 0, 0 };
  const conformal::PagePicture picture = conformal::shrunkPicture(pixels, 3, 1, 3, 2);
  EXPECT_EQ(picture.Height, 1u);
  EXPECT_EQ(picture.Pixels, (std::vector<unsigned char>{ 50, 0, 0, 190, 0, 0 }));
}

TEST(PagePicture, OneColorStaysThatColorAtAnySize)
{
  const std::vector<unsigned char> pixels(37 * 23 * 3, 201);
  for (const std::size_t largest : { 1, 2, 7, 11, 36, 37 })
  {
    const conformal::PagePicture picture =
      conformal::shrunkPicture(pixels.data(), 37, 23, 3, largest);
    EXPECT_EQ(picture.Width, largest);
    EXPECT_GE(picture.Height, 1u);
    EXPECT_EQ(picture.Pixels, std::vector<unsigned char>(picture.Width * picture.Height * 3, 201));
  }
}
