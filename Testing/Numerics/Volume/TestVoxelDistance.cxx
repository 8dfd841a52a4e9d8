#include "Volume/VoxelDistance.h"

#include "Base/Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

using conformal::farFrom;
using conformal::Index;

// All pairs of voxels, by their distances.
TEST(VoxelDistance, AgreesWithAllPairs)
{
  const std::array<Index, 3> size = { 11, 7, 9 };
  conformal::Random random(5);
  std::vector<std::uint8_t> set(11 * 7 * 9, 0);
  for (int i = 0; i < 6; ++i)
  {
    set[static_cast<std::size_t>(random.uniform() * static_cast<double>(set.size()))] = 1;
  }
  for (const double radius : { 0.0, 1.0, 1.5, 3.0, 4.2 })
  {
    const std::vector<std::uint8_t> far = farFrom(size, set, radius);
    EXPECT_EQ(far, farFrom(size, set, radius, runs::backwards()));
    for (Index a = 0; a < static_cast<Index>(set.size()); ++a)
    {
      bool isFar = true;
      for (Index b = 0; b < static_cast<Index>(set.size()); ++b)
      {
        const Index i = a % 11 - b % 11, j = a / 11 % 7 - b / 11 % 7, k = a / 77 - b / 77;
        isFar = isFar && !(set[b] && double(i * i + j * j + k * k) <= radius * radius);
      }
      ASSERT_EQ(far[a] != 0, isFar) << a << " " << radius;
    }
  }
}

TEST(VoxelDistance, EverythingIsFarFromNothing)
{
  EXPECT_EQ(farFrom({ 2, 2, 1 }, { 0, 0, 0, 0 }, 5.0), std::vector<std::uint8_t>(4, 1));
}
