#include "Learn/Fit/SurfaceEquations.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::Points;
using conformal::SurfaceEquations;
using conformal::Vector3;

namespace
{
/// A geodesic sphere of radius one that patterns on another surface draw.
struct Drawn
{
  explicit Drawn(int frequency)
    : Mesh(conformal::makeGeodesicSphere(frequency))
    , Neighbors(conformal::vertexNeighbors(this->Mesh.Triangles, this->Mesh.Positions.rows()))
    , Tree(this->Mesh.Positions, this->Mesh.Triangles)
    , Equations(this->Mesh.Triangles, this->Neighbors)
  {
    this->Equations.clear();
  }

  template <typename Shape>
  void add(const Points& directions, const Shape& shape)
  {
    for (Index i = 0; i < directions.rows(); ++i)
    {
      const Vector3 x = shape(Vector3(directions.row(i)));
      this->Equations.add(this->Tree.closestPoint(x), x, 1.0);
    }
  }

  Points solve(double stiffness, double evenness = 1.0)
  {
    const Index size = this->Mesh.Positions.rows();
    return this->Equations.solve(
      this->Mesh.Positions, Eigen::VectorXd::Constant(size, stiffness), evenness, {});
  }

  conformal::Mesh Mesh;
  conformal::Adjacency Neighbors;
  conformal::TriangleTree Tree;
  SurfaceEquations Equations;
};
}

TEST(SurfaceEquations, WithoutPatternsOnlySmoothnessMoves)
{
  Drawn drawn(6);
  EXPECT_EQ(drawn.solve(0.0).cwiseAbs().maxCoeff(), 0.0);
  drawn.Equations.clear();
  const Points moved = drawn.solve(1.0);
  // Flattest of all is a point.
  for (Index i = 0; i < moved.rows(); ++i)
  {
    EXPECT_LT(moved.row(i).dot(drawn.Mesh.Positions.row(i)), 0.0);
  }
}

// Dense patterns on a sphere a little larger: one solution takes the mesh there.
TEST(SurfaceEquations, MeetsPatternsAtOnce)
{
  Drawn drawn(8);
  const double radius = 1.01;
  const Points directions = conformal::makeGeodesicSphere(41).Positions;
  drawn.add(directions, [&](const Vector3& n) { return Vector3(radius * n); });
  const Points weights = drawn.Mesh.Positions + drawn.solve(1e-4);
  const conformal::TriangleTree after(weights, drawn.Mesh.Triangles);
  double before = 0.0, left = 0.0, bias = 0.0;
  for (Index i = 0; i < directions.rows(); ++i)
  {
    const Vector3 x = radius * Vector3(directions.row(i));
    const auto foot = after.closestPoint(x);
    before += drawn.Tree.closestPoint(x).SquareDistance;
    left += foot.SquareDistance;
    bias += radius - foot.Position.norm();
  }
  // Flat triangles cannot follow the sphere inside, but lie as much outside it as within.
  EXPECT_LT(left, 0.06 * before);
  EXPECT_LT(std::abs(bias) / directions.rows(), 2e-4);
}

TEST(SurfaceEquations, PullsAVertexAlongItsDirectionOnly)
{
  Drawn drawn(6);
  const Vector3 direction(0.0, 0.6, 0.8);
  drawn.Equations.pull(17, direction, 0.05, 2.0);
  const Points moved = drawn.solve(0.0);
  EXPECT_LT((Vector3(moved.row(17)) - 0.05 * direction).norm(), 1e-4);
  Points others = moved;
  others.row(17).setZero();
  EXPECT_EQ(others.cwiseAbs().maxCoeff(), 0.0);
}

TEST(SurfaceEquations, ForgetsItsPatterns)
{
  Drawn drawn(6);
  drawn.add(
    conformal::makeGeodesicSphere(13).Positions, [](const Vector3& n) { return Vector3(1.1 * n); });
  EXPECT_GT(drawn.solve(1e-3).norm(), 0.1);
  drawn.Equations.clear();
  EXPECT_EQ(drawn.solve(0.0).cwiseAbs().maxCoeff(), 0.0);
}

// A tangential push has hardly a say where feet lie inside triangles: a rotated sphere stays.
TEST(SurfaceEquations, PatternsMaySlide)
{
  Drawn drawn(8);
  const Points directions = conformal::makeGeodesicSphere(23).Positions;
  drawn.add(directions, [](const Vector3& n) { return n; });
  const Points moved = drawn.solve(1e-4);
  double along = 0.0, across = 0.0;
  for (Index i = 0; i < moved.rows(); ++i)
  {
    const Vector3 n = drawn.Mesh.Positions.row(i), d = moved.row(i);
    across += std::abs(d.dot(n));
    along += (d - d.dot(n) * n).norm();
  }
  EXPECT_LT(along, across);
}

TEST(SurfaceEquations, StopsWhenTold)
{
  Drawn drawn(12);
  drawn.add(
    conformal::makeGeodesicSphere(13).Positions, [](const Vector3& n) { return Vector3(1.1 * n); });
  const Index size = drawn.Mesh.Positions.rows();
  int steps = 0;
  EXPECT_THROW(drawn.Equations.solve(drawn.Mesh.Positions, Eigen::VectorXd::Constant(size, 0.01),
                 1.0, { {}, [&](double) { return ++steps < 6; } }),
    conformal::Aborted);
  EXPECT_EQ(steps, 6);
}
