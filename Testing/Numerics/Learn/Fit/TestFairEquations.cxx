#include "Learn/Fit/FairEquations.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/VertexNormals.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::CurvatureChange;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::PointView;
using conformal::SampleDistances;
using conformal::Tensors;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
/// Centers of the triangles, moved along their normals.
Points centersOf(const Mesh& mesh, double height)
{
  Points centers(mesh.Triangles.rows(), 3);
  for (Index r = 0; r < centers.rows(); ++r)
  {
    const Vector3 a = mesh.Positions.row(mesh.Triangles(r, 0)),
                  b = mesh.Positions.row(mesh.Triangles(r, 1)),
                  c = mesh.Positions.row(mesh.Triangles(r, 2));
    centers.row(r) = (a + b + c) / 3.0 + height * (b - a).cross(c - a).normalized();
  }
  return centers;
}

double traceOf(const Tensors& tensors)
{
  return tensors.leftCols(3).sum();
}
}

TEST(FairEquations, SquaresAreThoseOfTheSamples)
{
  Mesh sphere = conformal::makeGeodesicSphere(8);
  const Points cloud = centersOf(sphere, 0.01);
  const TrainingSamples samples{ PointView(cloud) };
  sphere.Positions /= samples.scale();
  const double height = 0.01 / samples.scale();
  const Points normals = conformal::vertexNormals(sphere.Positions, sphere.Triangles);
  const SampleDistances distances(samples, {}, sphere, normals,
    conformal::vertexNeighbors(sphere.Triangles, sphere.Positions.rows()));
  const Index size = sphere.Positions.rows();
  const double count = static_cast<double>(cloud.rows());
  EXPECT_EQ(distances.count(), count);
  EXPECT_NEAR(distances.countsAt().sum(), count, 1e-9 * count);
  const SampleDistances::Sum sum = distances.sum(Eigen::VectorXd::Ones(size));
  EXPECT_NEAR(sum.Constant, count * height * height, 1e-3 * count * height * height);
  // The vertices moved by the height bring the triangles to the samples.
  const Eigen::VectorXd moves = Eigen::VectorXd::Constant(size, height);
  EXPECT_LT(distances.squaresAt(moves).sum(), 1e-3 * sum.Constant);
  EXPECT_NEAR(distances.increaseAt(moves).sum(), sum.Constant, 1e-2 * sum.Constant);
  EXPECT_NEAR(moves.dot(sum.Right), sum.Constant, 1e-2 * sum.Constant);
}

TEST(FairEquations, PrecisionsScaleTheSum)
{
  const Mesh sphere = conformal::makeGeodesicSphere(4);
  const Points cloud = centersOf(sphere, 0.02);
  const TrainingSamples samples{ PointView(cloud) };
  const Points normals = conformal::vertexNormals(sphere.Positions, sphere.Triangles);
  const SampleDistances distances(samples, {}, sphere, normals,
    conformal::vertexNeighbors(sphere.Triangles, sphere.Positions.rows()));
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(sphere.Positions.rows());
  const SampleDistances::Sum once = distances.sum(ones), thrice = distances.sum(3.0 * ones);
  EXPECT_LT((thrice.Matrix - 3.0 * once.Matrix).norm(), 1e-12 * once.Matrix.norm());
  EXPECT_LT((thrice.Right - 3.0 * once.Right).norm(), 1e-12 * once.Right.norm());
  EXPECT_NEAR(thrice.Constant, 3.0 * once.Constant, 1e-12);
}

TEST(FairEquations, ARidgeIsSmoothedAlongButNotAcross)
{
  const Mesh mesh = conformal::makeGeodesicSphere(12);
  const Points normals = conformal::vertexNormals(mesh.Positions, mesh.Triangles);
  const CurvatureChange change(mesh, normals);
  const Index size = mesh.Positions.rows();
  const auto waves = [&](int direction)
  {
    Eigen::VectorXd moves(size);
    for (Index i = 0; i < size; ++i)
    {
      const double z = mesh.Positions(i, 2), near = std::exp(-20.0 * z * z);
      const double angle = std::atan2(mesh.Positions(i, 1), mesh.Positions(i, 0));
      moves[i] = 0.01 * near * std::sin(9.0 * (direction == 0 ? z : angle));
    }
    return moves;
  };
  // Change of curvature is expected along z.
  Tensors variances = Tensors::Zero(size, 6);
  variances.col(2).setConstant(1.0);
  const CurvatureChange::Energy energy = change.energy(variances, std::vector<bool>(size, false));
  const conformal::SparseMatrix matrix = energy.matrix();
  const Eigen::VectorXd across = waves(0), along = waves(1);
  const double ofAcross =
    across.dot(matrix * across) / traceOf(change.homogeneousSquaresAt(across));
  const double ofAlong = along.dot(matrix * along) / traceOf(change.homogeneousSquaresAt(along));
  EXPECT_GT(ofAlong, 4.0 * ofAcross);
}

TEST(FairEquations, ASphereHasLessChangeOfCurvatureThanWaves)
{
  Mesh mesh = conformal::makeGeodesicSphere(12);
  const auto squares = [&]
  {
    const Points normals = conformal::vertexNormals(mesh.Positions, mesh.Triangles);
    return traceOf(
      CurvatureChange(mesh, normals).squaresAt(Eigen::VectorXd::Zero(mesh.Positions.rows())));
  };
  const double ofSphere = squares();
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    mesh.Positions.row(i) *= 1.0 + 0.01 * std::sin(9.0 * mesh.Positions(i, 0));
  }
  EXPECT_LT(ofSphere, 0.05 * squares());
}

TEST(FairEquations, EnergyIsTheWeightedSumOfSquares)
{
  Mesh mesh = conformal::makeGeodesicSphere(6);
  mesh.Positions *= Vector3(1.0, 0.8, 0.9).asDiagonal();
  const Points normals = conformal::vertexNormals(mesh.Positions, mesh.Triangles);
  const CurvatureChange change(mesh, normals);
  const Index size = mesh.Positions.rows();
  // A variance of one half in each direction makes the energy the sum of the squares.
  Tensors variances = Tensors::Zero(size, 6);
  variances.leftCols(3).setConstant(0.5);
  const CurvatureChange::Energy energy = change.energy(variances, std::vector<bool>(size, false));
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(size),
                        moves = 0.01 * mesh.Positions.col(0).cwiseAbs2();
  const conformal::SparseMatrix matrix = energy.matrix();
  const double constant = traceOf(change.squaresAt(still));
  const double moved = moves.dot(matrix * moves) + 2.0 * moves.dot(energy.Force) + constant;
  EXPECT_NEAR(traceOf(change.squaresAt(moves)), moved, 1e-9 * constant);
  EXPECT_NEAR(
    traceOf(change.homogeneousSquaresAt(moves)), moves.dot(matrix * moves), 1e-9 * constant);
}

TEST(FairEquations, EnergyOfSomeVerticesIsAPartOfTheWhole)
{
  const Mesh mesh = conformal::makeGeodesicSphere(6);
  const Points normals = conformal::vertexNormals(mesh.Positions, mesh.Triangles);
  const CurvatureChange change(mesh, normals);
  const Index size = mesh.Positions.rows();
  Tensors variances = Tensors::Zero(size, 6);
  variances.leftCols(3) = mesh.Positions.cwiseAbs2().array() + 0.1;
  const CurvatureChange::Energy energy = change.energy(variances, std::vector<bool>(size, false));
  const Eigen::MatrixXd whole = energy.matrix();
  const std::vector<int> ids = { 200, 3, 4, 50, 51, 120 };
  const Eigen::MatrixXd part = energy.principalPart(ids);
  EXPECT_LT((part - whole(ids, ids)).norm(), 1e-12 * whole.norm());
  EXPECT_GT(part.norm(), 0.0);
  EXPECT_NEAR(energy.trace(), whole.trace(), 1e-12 * whole.trace());
}
