#include "Register/SphericalResample.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Search/TriangleTree.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

using conformal::Index;
using conformal::MappedMesh;
using conformal::Points;
using conformal::ResampleMethod;
using conformal::resampleSurface;
using conformal::Vector3;

namespace
{
constexpr ResampleMethod Methods[] = { ResampleMethod::Barycentric, ResampleMethod::AreaAdaptive };

/// A bent ellipsoid whose map is uneven and turned.
MappedMesh surface(int frequency, double turn)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency);
  MappedMesh mesh;
  mesh.Triangles = sphere.Triangles;
  const Eigen::AngleAxisd rotation(turn, Vector3(1.0, 2.0, 0.5).normalized());
  mesh.SpherePositions = shapes::over(sphere.Positions,
    [&](const Vector3& direction) -> Vector3
    {
      Vector3 n = rotation * direction;
      n[2] += 0.25 * (1.0 + n[2]) * n[0];
      return n.normalized();
    });
  mesh.Positions = shapes::over(mesh.SpherePositions,
    [](const Vector3& n) { return Vector3(2.0 * n[0] + 0.3 * n[1] * n[1], n[1], 0.7 * n[2]); });
  return mesh;
}

Eigen::MatrixXd dense(const conformal::ResampleWeights& weights, Index columns)
{
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(weights.size(), columns);
  for (Index i = 0; i < weights.size(); ++i)
  {
    for (Index k = weights.Offsets[i]; k < weights.Offsets[i + 1]; ++k)
    {
      matrix(i, weights.Ids[k]) += weights.Weights[k];
    }
  }
  return matrix;
}

Eigen::MatrixXd weightsOf(const MappedMesh& source, const MappedMesh& target, ResampleMethod method)
{
  return dense(resampleSurface(source, target, { method }).Weights, source.Positions.rows());
}

/// By a look at all triangles.
Eigen::MatrixXd barycentricByHand(const MappedMesh& source, const MappedMesh& target)
{
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(target.Positions.rows(), source.Positions.rows());
  for (Index i = 0; i < matrix.rows(); ++i)
  {
    conformal::FootPoint best;
    for (int r = 0; r < source.Triangles.rows(); ++r)
    {
      const auto ids = source.Triangles.row(r);
      conformal::FootPoint foot = conformal::closestPointOfTriangle(target.SpherePositions.row(i),
        source.SpherePositions.row(ids[0]), source.SpherePositions.row(ids[1]),
        source.SpherePositions.row(ids[2]));
      foot.Triangle = r;
      best = foot.SquareDistance < best.SquareDistance ? foot : best;
    }
    for (int k = 0; k < 3; ++k)
    {
      matrix(i, source.Triangles(best.Triangle, k)) += best.Barycentric[k];
    }
  }
  return matrix;
}

Eigen::VectorXd areasAround(const MappedMesh& mesh)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.Positions.rows());
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      areas[mesh.Triangles(r, k)] +=
        conformal::areaVector(mesh.Positions, mesh.Triangles, r).norm() / 3.0;
    }
  }
  return areas;
}

/// The definition in the documents of Connectome Workbench, with full matrices.
Eigen::MatrixXd adaptiveByHand(const MappedMesh& source, const MappedMesh& target)
{
  const Eigen::MatrixXd back = barycentricByHand(target, source).transpose();
  Eigen::MatrixXd matrix = barycentricByHand(source, target);
  for (Index i = 0; i < matrix.rows(); ++i)
  {
    if ((back.row(i).array() > 0.0 && matrix.row(i).array() == 0.0).any())
    {
      matrix.row(i) = back.row(i);
    }
  }
  matrix.array().colwise() *= areasAround(target).array();
  const Eigen::ArrayXd sums = matrix.colwise().sum();
  const Eigen::ArrayXd scales = areasAround(source).array() / sums.max(1e-300);
  matrix.array().rowwise() *= scales.transpose();
  const Eigen::ArrayXd rows = matrix.rowwise().sum();
  matrix.array().colwise() /= rows;
  return matrix;
}

void expectRefused(const MappedMesh& source, const MappedMesh& target, const std::string& why)
{
  try
  {
    resampleSurface(source, target);
    ADD_FAILURE() << why;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
}
}

TEST(SphericalResample, OntoItselfIsTheIdentity)
{
  const MappedMesh mesh = surface(6, 0.4);
  const Eigen::MatrixXd identity =
    Eigen::MatrixXd::Identity(mesh.Positions.rows(), mesh.Positions.rows());
  for (const ResampleMethod method : Methods)
  {
    EXPECT_LT((weightsOf(mesh, mesh, method) - identity).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST(SphericalResample, WeightsAreTheOnesOfTheDefinition)
{
  for (const auto& [coarse, fine] : { std::pair(4, 9), std::pair(9, 4), std::pair(7, 6) })
  {
    const MappedMesh source = surface(coarse, 0.2), target = surface(fine, 1.3);
    EXPECT_LT(
      (weightsOf(source, target, ResampleMethod::Barycentric) - barycentricByHand(source, target))
        .cwiseAbs()
        .maxCoeff(),
      1e-6);
    EXPECT_LT(
      (weightsOf(source, target, ResampleMethod::AreaAdaptive) - adaptiveByHand(source, target))
        .cwiseAbs()
        .maxCoeff(),
      1e-6);
  }
}

TEST(SphericalResample, OnlyAreaAdaptiveUsesAllOfAFinerSource)
{
  const MappedMesh source = surface(20, 0.2), target = surface(4, 1.3);
  const auto used = [&](ResampleMethod method)
  {
    const auto weights = resampleSurface(source, target, { method }).Weights;
    return std::set<int>(weights.Ids.begin(), weights.Ids.end()).size();
  };
  EXPECT_EQ(used(ResampleMethod::AreaAdaptive), static_cast<std::size_t>(source.Positions.rows()));
  EXPECT_LE(
    used(ResampleMethod::Barycentric), static_cast<std::size_t>(3 * target.Positions.rows()));
}

TEST(SphericalResample, OnlyAreasOfTheSurfacesCount)
{
  const MappedMesh source = surface(9, 0.2), target = surface(5, 1.3);
  const Eigen::MatrixXd expected = weightsOf(source, target, ResampleMethod::AreaAdaptive);
  MappedMesh larger = source;
  larger.Positions *= 3.0;
  EXPECT_LT(
    (weightsOf(larger, target, ResampleMethod::AreaAdaptive) - expected).cwiseAbs().maxCoeff(),
    1e-13);
  MappedMesh uneven = source;
  for (Index i = 0; i < uneven.Positions.rows(); ++i)
  {
    uneven.Positions.row(i) *= uneven.Positions(i, 0) > 0.0 ? 10.0 : 1.0;
  }
  EXPECT_GT(
    (weightsOf(uneven, target, ResampleMethod::AreaAdaptive) - expected).cwiseAbs().maxCoeff(),
    0.05);
  EXPECT_EQ(weightsOf(uneven, target, ResampleMethod::Barycentric),
    weightsOf(source, target, ResampleMethod::Barycentric));
}

TEST(SphericalResample, LinearFunctionsAreCarried)
{
  const MappedMesh source = surface(30, 0.2), target = surface(23, 1.3);
  for (const ResampleMethod method : Methods)
  {
    const Points carried = weightsOf(source, target, method) * source.SpherePositions;
    EXPECT_LT((carried - target.SpherePositions).rowwise().norm().maxCoeff(), 0.01);
  }
}

TEST(SphericalResample, MirroredMapsAndPointsWithoutTrianglesAreFine)
{
  MappedMesh source = surface(9, 0.2), target = surface(5, 1.3);
  const Eigen::MatrixXd expected = weightsOf(source, target, ResampleMethod::AreaAdaptive);
  for (MappedMesh* mesh : { &source, &target })
  {
    mesh->SpherePositions.col(1) *= -1.0;
  }
  EXPECT_LT(
    (weightsOf(source, target, ResampleMethod::AreaAdaptive) - expected).cwiseAbs().maxCoeff(),
    1e-7);
  EXPECT_EQ(resampleSurface(source, target).NumberOfFolds, 0);
  // A point of no triangle has no area, and is nowhere made use of.
  const Index size = source.Positions.rows();
  source.Positions.conservativeResize(size + 1, 3);
  source.SpherePositions.conservativeResize(size + 1, 3);
  source.Positions.row(size) << 9.0, 9.0, 9.0;
  source.SpherePositions.row(size) << 0.0, 0.6, 0.8;
  const Eigen::MatrixXd more = weightsOf(source, target, ResampleMethod::AreaAdaptive);
  EXPECT_EQ(more.col(size).maxCoeff(), 0.0);
  EXPECT_LT((more.leftCols(size) - expected).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(SphericalResample, FoldsAreCounted)
{
  MappedMesh source = surface(12, 0.2);
  const MappedMesh target = surface(5, 1.3);
  EXPECT_EQ(resampleSurface(source, target).NumberOfFolds, 0);
  const Vector3 far = source.SpherePositions.row(source.Triangles(300, 1));
  source.SpherePositions.row(source.Triangles(300, 0)) =
    (2.0 * far - Vector3(source.SpherePositions.row(source.Triangles(300, 0)))).normalized();
  EXPECT_GT(resampleSurface(source, target).NumberOfFolds, 0);
}

TEST(SphericalResample, MapsThatDoNotCoverTheSphereAreRefused)
{
  const MappedMesh whole = surface(6, 0.2);
  MappedMesh bowl = whole;
  bowl.SpherePositions.col(2) = bowl.SpherePositions.col(2).cwiseAbs();
  expectRefused(bowl, whole, "the map to the sphere of the source covers the sphere 0 times");
  expectRefused(whole, bowl, "the map to the sphere of the target covers the sphere 0 times");
  EXPECT_NO_THROW(resampleSurface(whole, bowl, { ResampleMethod::Barycentric }));
  MappedMesh half = whole;
  half.Triangles.conservativeResize(half.Triangles.rows() - 1, 3);
  expectRefused(
    half, whole, "the source is open, or its triangles are not oriented consistently, at 3 edges");
  expectRefused(
    whole, half, "the target is open, or its triangles are not oriented consistently, at 3 edges");
}

TEST(SphericalResample, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const MappedMesh source = surface(60, 0.2), target = surface(50, 1.3);
  for (const ResampleMethod method : Methods)
  {
    const auto one = resampleSurface(source, target, { method }).Weights;
    const auto two = resampleSurface(source, target, { method }, runs::backwards()).Weights;
    EXPECT_EQ(one.Ids, two.Ids);
    EXPECT_EQ(one.Weights, two.Weights);
    EXPECT_THROW(
      resampleSurface(source, target, { method }, runs::stoppingAt(0.6)), conformal::Aborted);
  }
  runs::Watch watch;
  resampleSurface(source, target, {}, watch.run());
  EXPECT_GT(watch.calls(), 10);
}
