#include "Sphere/SphereOrientation.h"

#include "Base/Random.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::orientation;
using conformal::Vector3;

namespace
{
// Coordinates that are whole numbers below 2^29, so that the determinant fits into 128 bits.
struct Whole
{
  long long X, Y, Z;

  // Powers of two change no digit.
  Vector3 vector() const
  {
    return Vector3(static_cast<double>(this->X), static_cast<double>(this->Y),
             static_cast<double>(this->Z)) *
      0x1p-29;
  }
};

int oracle(const Whole& a, const Whole& b, const Whole& c)
{
  using Wide = __int128;
  const Wide sum = Wide(a.X) * (Wide(b.Y) * c.Z - Wide(b.Z) * c.Y) +
    Wide(a.Y) * (Wide(b.Z) * c.X - Wide(b.X) * c.Z) +
    Wide(a.Z) * (Wide(b.X) * c.Y - Wide(b.Y) * c.X);
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}
}

TEST(SphereOrientation, KnowsTheOctant)
{
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  EXPECT_EQ(orientation(x, y, z), 1);
  EXPECT_EQ(orientation(x, z, y), -1);
  EXPECT_EQ(orientation(x, y, (x + y).eval()), 0);
  EXPECT_EQ(orientation(x, x, z), 0);
}

// Slivers a few units in the last place high, which rounded determinants get wrong.
TEST(SphereOrientation, AgreesWithWholeNumbers)
{
  conformal::Random random(1);
  const auto number = [&](long long range)
  { return static_cast<long long>(random.index(2 * range + 1)) - range; };
  int rounded = 0, flat = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Whole a = { number(1 << 28), number(1 << 28), number(1 << 28) };
    const long long size = 1LL << random.index(20);
    const Whole step = { number(size), number(size), number(size) };
    const long long times = number(5);
    const Whole b = { a.X + step.X, a.Y + step.Y, a.Z + step.Z };
    const Whole c = { a.X + times * step.X + number(1), a.Y + times * step.Y + number(1),
      a.Z + times * step.Z + number(1) };
    const int expected = oracle(a, b, c);
    ASSERT_EQ(orientation(a.vector(), b.vector(), c.vector()), expected);
    ASSERT_EQ(orientation(b.vector(), c.vector(), a.vector()), expected);
    ASSERT_EQ(orientation(b.vector(), a.vector(), c.vector()), -expected);
    const double plain = a.vector().dot(b.vector().cross(c.vector()));
    rounded += (plain > 0.0 ? 1 : plain < 0.0 ? -1 : 0) != expected;
    flat += expected == 0;
  }
  EXPECT_GT(rounded, 100); // the test asks something
  EXPECT_GT(flat, 100);
}

TEST(SphereOrientation, CountsFlippedAndFlatTriangles)
{
  conformal::Points positions(4, 3);
  positions << 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0;
  conformal::Triangles triangles(3, 3);
  triangles << 0, 1, 2, 0, 2, 1, 0, 1, 3;
  EXPECT_EQ(conformal::countFlippedTriangles(positions, triangles), 2);
}
