#include "SphereMap/FlipRepair.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using conformal::Index;
using conformal::Vector3;

// The identity map of the sphere, to be folded.
class FlipRepair : public testing::Test
{
protected:
  FlipRepair()
    : Shapes(Sphere.Positions, Sphere.Triangles)
    , Rings(Sphere.Triangles, Sphere.Positions.rows())
    , Strings(conformal::harmonicStrings(Sphere.Positions, Sphere.Triangles).Strings)
  {
    for (Index v = 0; v < this->Sphere.Positions.rows(); ++v)
    {
      this->Positions.emplace_back(this->Sphere.Positions.row(v));
    }
  }
  std::size_t bad() const
  {
    return conformal::badTriangles(this->Positions, this->Sphere.Triangles).size();
  }
  bool repair(double minimumHeight = std::numeric_limits<double>::infinity())
  {
    return conformal::repairFlips(this->Positions, this->Sphere.Positions, this->Sphere.Triangles,
      this->Strings, this->Rings, this->Shapes, minimumHeight);
  }
  double maximumDistance() const
  {
    double largest = 0.0;
    for (std::size_t v = 0; v < this->Positions.size(); ++v)
    {
      const Vector3 before = this->Sphere.Positions.row(static_cast<Index>(v));
      largest = std::max(largest, (this->Positions[v] - before).norm());
    }
    return largest;
  }

  const conformal::Mesh Sphere = conformal::makeGeodesicSphere(16);
  const conformal::BoundedTriangles Shapes;
  const conformal::VertexRings Rings;
  const conformal::EdgeWeights Strings;
  std::vector<Vector3> Positions;
};

TEST_F(FlipRepair, LeavesAGoodMapAlone)
{
  EXPECT_TRUE(this->repair());
  EXPECT_EQ(this->maximumDistance(), 0.0);
}

TEST_F(FlipRepair, PutsOneVertexBack)
{
  const int v = 500;
  const Vector3 far = this->Positions[this->Rings[v][0]] - this->Positions[v];
  this->Positions[v] = (this->Positions[v] + 1.5 * far).normalized();
  ASSERT_GT(this->bad(), 0u);
  EXPECT_TRUE(this->repair());
  EXPECT_EQ(this->bad(), 0u);
  EXPECT_LT(this->maximumDistance(), 0.01); // nearly to where it was: relaxed
}

// The smaller a triangle is on the sphere, the smaller is its determinant, without being flipped.
TEST_F(FlipRepair, PutsAVertexBackAmongTinyTriangles)
{
  Index pole = 0;
  this->Sphere.Positions.col(2).maxCoeff(&pole);
  for (Vector3& place : this->Positions)
  {
    const double radius = std::hypot(place[0], place[1]) / (1.0 + place[2]);
    if (radius > 0.0 && radius < 1.0)
    {
      constexpr double power = 6.0;
      const double square = std::pow(radius, 2.0 * power);
      const double factor = 2.0 * std::pow(radius, power) / (1.0 + square);
      place = { factor * place[0] / std::hypot(place[0], place[1]),
        factor * place[1] / std::hypot(place[0], place[1]), (1.0 - square) / (1.0 + square) };
    }
  }
  ASSERT_EQ(this->bad(), 0u);
  const Vector3 far = this->Positions[this->Rings[pole][0]] - this->Positions[pole];
  ASSERT_LT(far.norm(), 1e-7);
  this->Positions[pole] = (this->Positions[pole] + 1.5 * far).normalized();
  ASSERT_GT(this->bad(), 0u);
  EXPECT_TRUE(this->repair(conformal::MinimumSafeHeight));
  EXPECT_EQ(this->bad(), 0u);
}

// Turned upside down, vertices one by one find no kernel.
TEST_F(FlipRepair, UnfoldsAPatch)
{
  const Vector3 pole = this->Positions[40];
  for (Vector3& place : this->Positions)
  {
    if ((place - pole).norm() < 0.25)
    {
      place = (2.0 * place.dot(pole) * pole - place).normalized();
    }
  }
  const Vector3 across = pole.unitOrthogonal();
  for (Vector3& place : this->Positions)
  {
    if ((place - pole).norm() < 0.25)
    {
      place -= 2.0 * place.dot(across) * across;
    }
  }
  ASSERT_GT(this->bad(), 20u);
  EXPECT_TRUE(this->repair());
  EXPECT_EQ(this->bad(), 0u);
}

TEST_F(FlipRepair, GivesUpWhereAllIsFolded)
{
  for (Vector3& place : this->Positions)
  {
    place = -place;
  }
  EXPECT_FALSE(this->repair());
}

TEST_F(FlipRepair, EvensOutAPatchThatIsShaken)
{
  const Vector3 pole = this->Positions[40];
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-0.06, 0.06); // edges are about 0.07 long
  for (Vector3& place : this->Positions)
  {
    if ((place - pole).norm() < 0.4)
    {
      place = (place + Vector3(shift(random), shift(random), shift(random))).normalized();
    }
  }
  ASSERT_GT(this->bad(), 10u);
  EXPECT_TRUE(conformal::evenOutFlips(this->Positions, this->Sphere.Triangles, this->Rings));
  EXPECT_EQ(this->bad(), 0u);
  EXPECT_LT(this->maximumDistance(), 0.15);
}

TEST_F(FlipRepair, EvensNothingOutWhereAllIsFolded)
{
  for (Vector3& place : this->Positions)
  {
    place = -place;
  }
  EXPECT_FALSE(conformal::evenOutFlips(this->Positions, this->Sphere.Triangles, this->Rings));
}
