#include "Linear/ShiftedSystem.h"

#include "Mesh/GeodesicSphere.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <vector>

using conformal::Columns;
using conformal::factorize;
using conformal::Index;
using conformal::ShiftedSystem;
using conformal::SparseMatrix;

namespace
{
struct Pair
{
  conformal::Points Places;
  SparseMatrix Mass, Laplacian;
};

/// A diagonal that differs by place, and the uniform Laplacian of a sphere.
Pair pairOfSphere()
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(6);
  const Index size = sphere.Positions.rows();
  const conformal::Adjacency neighbors = conformal::vertexNeighbors(sphere.Triangles, size);
  std::vector<Eigen::Triplet<double>> mass, laplacian;
  for (int i = 0; i < size; ++i)
  {
    mass.emplace_back(i, i, 1.0 + 0.5 * sphere.Positions(i, 0));
    laplacian.emplace_back(i, i, neighbors.size(i));
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      laplacian.emplace_back(i, *j, -1.0);
    }
  }
  Pair pair{ sphere.Positions, SparseMatrix(size, size), SparseMatrix(size, size) };
  pair.Mass.setFromTriplets(mass.begin(), mass.end());
  pair.Laplacian.setFromTriplets(laplacian.begin(), laplacian.end());
  return pair;
}
}

TEST(ShiftedSystem, SolvesForAllWeightsAroundTheCenter)
{
  const Pair pair = pairOfSphere();
  const double center = 2.0;
  Columns right(pair.Places.rows(), 2);
  right.col(0) = pair.Places.col(1) + pair.Places.col(0).cwiseAbs2();
  right.col(1) = Eigen::VectorXd::Unit(right.rows(), 7);
  const ShiftedSystem system(
    pair.Mass, factorize(pair.Mass + center * pair.Laplacian, pair.Places, 1), center, right, 25);
  for (const double weight : { 0.1, 1.0, 2.0, 40.0 })
  {
    const Eigen::MatrixXd full = Eigen::MatrixXd(pair.Mass + weight * pair.Laplacian);
    for (Index c = 0; c < right.cols(); ++c)
    {
      const Eigen::VectorXd expected = full.llt().solve(right.col(c));
      const Eigen::VectorXd found = system.solution(c, weight);
      EXPECT_LT((found - expected).norm(), 1e-4 * expected.norm()) << weight;
      const double product = right.col(c).dot(expected);
      EXPECT_NEAR(system.product(c, weight), product, 1e-8 * product) << weight;
    }
  }
}

TEST(ShiftedSystem, OneStepIsExactAtTheCenter)
{
  const Pair pair = pairOfSphere();
  const SparseMatrix sum = pair.Mass + pair.Laplacian;
  const Columns right = pair.Places.col(2);
  const ShiftedSystem system(pair.Mass, factorize(sum, pair.Places, 1), 1.0, right, 1);
  EXPECT_LT((sum * system.solution(0, 1.0) - right.col(0)).norm(), 1e-12 * right.norm());
}

TEST(ShiftedSystem, AZeroStaysZero)
{
  const Pair pair = pairOfSphere();
  const Columns right = Columns::Zero(pair.Places.rows(), 1);
  const ShiftedSystem system(
    pair.Mass, factorize(pair.Mass + pair.Laplacian, pair.Places, 1), 1.0, right, 4);
  EXPECT_TRUE(system.solution(0, 3.0).isZero(1e-100));
}
