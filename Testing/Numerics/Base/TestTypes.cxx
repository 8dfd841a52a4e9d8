// What Eigen computes must not depend on the processor: see conformalBuild in the top
// CMakeLists.txt.
#include "Base/Types.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(Types, RootsAndReciprocalsOfFloatsAreRounded)
{
  // Estimates with one step of Newton's method differ in the last bit for some of these.
  for (int first = 1; first < 40000; first += 8)
  {
    const Eigen::Array<float, 8, 1> x = Eigen::Array<float, 8, 1>::LinSpaced(
      8, static_cast<float>(first), static_cast<float>(first + 7));
    const Eigen::Array<float, 8, 1> roots = x.sqrt(), inverseRoots = x.rsqrt(),
                                    inverses = x.inverse();
    for (int i = 0; i < 8; ++i)
    {
      ASSERT_EQ(roots[i], std::sqrt(x[i])) << x[i];
      ASSERT_EQ(inverseRoots[i], 1.0F / std::sqrt(x[i])) << x[i];
      ASSERT_EQ(inverses[i], 1.0F / x[i]) << x[i];
    }
  }
}

TEST(Types, BlocksOfProductsDoNotFollowTheCaches)
{
  EXPECT_EQ(Eigen::l1CacheSize(), Eigen::internal::defaultL1CacheSize);
  EXPECT_EQ(Eigen::l2CacheSize(), Eigen::internal::defaultL2CacheSize);
  EXPECT_EQ(Eigen::l3CacheSize(), Eigen::internal::defaultL3CacheSize);
}
