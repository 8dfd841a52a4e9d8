#include "Motion/DeformationTransfer.h"

#include "Linear/EdgeWeights.h"
#include "Runs.h"
#include "Shapes.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using conformal::DeformationTransfer;
using conformal::DeformationTransferOptions;
using conformal::Index;
using conformal::MappedMesh;
using conformal::Points;
using conformal::TransferredShape;
using conformal::Vector3;

namespace
{
// A body with a smooth shape. Its map is that of the sphere.
template <typename Place>
MappedMesh body(int frequency, Place place)
{
  MappedMesh mesh = spheres::mapped(frequency);
  mesh.Positions = shapes::over(mesh.SpherePositions, place);
  return mesh;
}

Vector3 egg(const Vector3& n)
{
  return { 3.0 * n[0] + 0.4 * n[1] * n[1], 2.0 * n[1], n[2] * (1.0 + 0.3 * n[0]) };
}

Vector3 bean(const Vector3& n)
{
  return { 2.5 * n[0], 1.2 * n[1] + 0.3 * n[0] * n[0], 1.6 * n[2] * (1.0 - 0.2 * n[0]) };
}

// Bend a body: rotate its points by an angle that grows along x.
Points bent(const Points& points, double angle)
{
  return shapes::over(points,
    [=](const Vector3& p) -> Vector3
    { return Eigen::AngleAxisd(angle * std::tanh(p[0]), Vector3::UnitZ()) * p; });
}

Points rigid(const Points& points, const Eigen::Matrix3d& turn, const Vector3& shift)
{
  return (points * turn.transpose()).rowwise() + shift.transpose();
}

Eigen::Matrix3d someTurn(double angle = 0.9)
{
  return Eigen::AngleAxisd(angle, Vector3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

double largestDistance(const Points& a, const Points& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}

Vector3 centerOf(const MappedMesh& mesh, const Points& points)
{
  const Eigen::VectorXd areas = conformal::vertexAreas(mesh.Positions, mesh.Triangles);
  return points.transpose() * areas / areas.sum();
}

std::string messageOf(const MappedMesh& source, const MappedMesh& target)
{
  try
  {
    const DeformationTransfer transfer(source, target, {});
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "no error";
}
}

TEST(DeformationTransfer, ToTheSourceItselfGivesThePose)
{
  const MappedMesh mesh = body(16, egg);
  const DeformationTransfer transfer(mesh, mesh, {});
  for (const double angle : { 0.0, 0.5, 2.5 })
  {
    const Points pose = rigid(bent(mesh.Positions, angle), someTurn(), { 5.0, -7.0, 1.0 });
    const TransferredShape shape = transfer.transfer(pose);
    EXPECT_LT(largestDistance(shape.Positions, pose), 1e-10);
    EXPECT_LT(shape.Residual, 1e-10);
  }
}

TEST(DeformationTransfer, ARigidMotionMovesTheTargetRigidly)
{
  const MappedMesh source = body(16, egg), target = body(11, bean);
  const Eigen::Matrix3d turn = someTurn(2.8);
  const Points pose = rigid(source.Positions, turn, { 1.0, 2.0, 3.0 });
  DeformationTransferOptions options;
  options.AlignRotation = false;
  const TransferredShape shape = DeformationTransfer(source, target, {}, options).transfer(pose);
  const Vector3 shift =
    centerOf(target, shape.Positions) - turn * centerOf(target, target.Positions);
  EXPECT_LT(largestDistance(shape.Positions, rigid(target.Positions, turn, shift)), 1e-10);
  EXPECT_LT(shape.Residual, 1e-10);
}

TEST(DeformationTransfer, UniformGrowthOfTheSourceIsThatOfTheTarget)
{
  const MappedMesh source = body(16, egg), target = body(11, bean);
  const TransferredShape shape =
    DeformationTransfer(source, target, {}).transfer(1.5 * source.Positions);
  const Vector3 shift =
    centerOf(target, shape.Positions) - 1.5 * centerOf(target, target.Positions);
  const Points wanted = rigid(target.Positions, 1.5 * Eigen::Matrix3d::Identity(), shift);
  EXPECT_LT(largestDistance(shape.Positions, wanted), 1e-10);
}

// If the target at rest is the source at rest, rotated, scaled and moved, so is the deformed
// target.
TEST(DeformationTransfer, FollowsASimilarityBetweenTheSurfacesAtRest)
{
  const MappedMesh source = body(14, egg);
  MappedMesh target = source;
  const Eigen::Matrix3d similarity = 0.01 * someTurn(3.0);
  target.Positions = rigid(source.Positions, similarity, { 40.0, 0.0, -3.0 });
  const Points pose = rigid(bent(source.Positions, 1.5), someTurn(), { 2.0, 0.0, 1.0 });
  const TransferredShape shape = DeformationTransfer(source, target, {}).transfer(pose);
  EXPECT_LT(largestDistance(shape.Positions, rigid(pose, similarity, { 40.0, 0.0, -3.0 })), 1e-10);
}

// The same bend of two meshes of one body, which share no vertices.
TEST(DeformationTransfer, ConvergesToTheDeformationOfTheSameBody)
{
  const MappedMesh source = body(40, egg);
  double before = 1.0;
  for (const int frequency : { 9, 18 })
  {
    const MappedMesh target = body(frequency, egg);
    const Points wanted = bent(target.Positions, 1.0);
    const TransferredShape shape =
      DeformationTransfer(source, target, {}).transfer(bent(source.Positions, 1.0));
    const double error = largestDistance(shape.Positions, wanted);
    EXPECT_LT(error, 0.5 * before);
    before = error;
  }
  EXPECT_LT(before, 0.03);
}

TEST(DeformationTransfer, AveragingOverTheAreaIsMoreAccurateThanTheCenter)
{
  const MappedMesh source = body(40, egg), target = body(9, egg);
  // Ripples that are smaller than the triangles of the target.
  const auto rippled = [](const Points& points, double height)
  {
    return shapes::over(bent(points, 1.0),
      [=](const Vector3& p) -> Vector3
      { return p * (1.0 + height * std::sin(25.0 * p[0]) * std::sin(25.0 * p[1])); });
  };
  const Points wanted = bent(target.Positions, 1.0);
  const auto errorWith = [&](int subdivision)
  {
    DeformationTransferOptions options;
    options.Correspondence.MaximumSubdivision = subdivision;
    const Points found = DeformationTransfer(source, target, {}, options)
                           .transfer(rippled(source.Positions, 0.01))
                           .Positions;
    return std::sqrt((found - wanted).rowwise().squaredNorm().mean());
  };
  EXPECT_LT(errorWith(12), 0.7 * errorWith(1));
}

TEST(DeformationTransfer, ContactsMoveWithTheirSourcePoints)
{
  const MappedMesh source = body(16, egg), target = body(11, bean);
  std::vector<int> contacts;
  for (Index v = 0; v < target.Positions.rows(); ++v)
  {
    if (std::abs(target.SpherePositions(v, 0)) > 0.9)
    {
      contacts.push_back(static_cast<int>(v));
    }
  }
  DeformationTransferOptions options;
  options.AlignRotation = false;
  const DeformationTransfer transfer(source, target, contacts, options);
  // Both ends rest, the middle is lifted.
  const auto lifted = [](const Points& points)
  {
    return shapes::over(points,
      [](const Vector3& p) -> Vector3
      { return p + Vector3(0.0, 0.0, std::max(0.0, 1.0 - p[0] * p[0] / 4.0)); });
  };
  const Points found = transfer.transfer(lifted(source.Positions)).Positions;
  for (const int contact : contacts)
  {
    EXPECT_LT((found.row(contact) - target.Positions.row(contact)).norm(), 1e-12);
  }
  EXPECT_GT((found - target.Positions).col(2).maxCoeff(), 0.5);
  // All vertices are contacts: plain displacement.
  std::vector<int> all(target.Positions.rows());
  for (std::size_t v = 0; v < all.size(); ++v)
  {
    all[v] = static_cast<int>(v);
  }
  const Points shifted = rigid(source.Positions, Eigen::Matrix3d::Identity(), { 1.0, 0.0, 0.0 });
  const Points plain =
    DeformationTransfer(source, target, all, options).transfer(shifted).Positions;
  const Points moves = plain - target.Positions;
  EXPECT_LT((moves.rowwise() - moves.row(0)).norm(), 1e-12);
}

// Small changes of the source cause changes of the target of the same order, even where the source
// has rotated by 180 degrees.
TEST(DeformationTransfer, AContinuousSourceGivesAContinuousTarget)
{
  const MappedMesh source = body(14, egg), target = body(11, bean);
  const DeformationTransfer transfer(source, target, {});
  Points before = transfer.transfer(bent(source.Positions, 0.0)).Positions;
  Points pose = bent(source.Positions, 0.0);
  for (double angle = 0.05; angle < 7.0; angle += 0.05)
  {
    const Points next = bent(source.Positions, angle);
    const Points shape = transfer.transfer(next).Positions;
    EXPECT_LT(largestDistance(shape, before), 3.0 * largestDistance(next, pose)) << angle;
    before = shape;
    pose = next;
  }
}

TEST(DeformationTransfer, TrianglesWithoutAreaDoNotMatter)
{
  const MappedMesh source = body(14, egg);
  MappedMesh target = source;
  const auto corners = target.Triangles.row(100);
  target.Positions.row(corners[1]) = target.Positions.row(corners[0]);
  target.Positions.row(corners[2]) = target.Positions.row(corners[0]);
  const Points pose = bent(source.Positions, 0.4);
  const TransferredShape shape = DeformationTransfer(source, target, {}).transfer(pose);
  ASSERT_TRUE(shape.Positions.allFinite());
  EXPECT_LT(largestDistance(shape.Positions, pose), 0.5);
  EXPECT_LT((shape.Positions.row(corners[1]) - shape.Positions.row(corners[0])).norm(), 1e-5);
  // A source with such triangles.
  const TransferredShape other =
    DeformationTransfer(target, source, {}).transfer(bent(target.Positions, 0.4));
  ASSERT_TRUE(other.Positions.allFinite());
  EXPECT_LT(largestDistance(other.Positions, pose), 0.5);
}

TEST(DeformationTransfer, PointsWithoutTrianglesMoveWithTheSource)
{
  const MappedMesh source = body(10, egg);
  MappedMesh target = source;
  const Index size = source.Positions.rows();
  target.Positions.conservativeResize(size + 1, 3);
  target.SpherePositions.conservativeResize(size + 1, 3);
  target.SpherePositions.row(size) = source.SpherePositions.row(7);
  target.Positions.row(size) = source.Positions.row(7);
  const Points pose = bent(source.Positions, 1.0);
  const Points found = DeformationTransfer(source, target, {}).transfer(pose).Positions;
  EXPECT_LT(largestDistance(found.topRows(size), pose), 1e-10);
  EXPECT_LT((found.row(size) - pose.row(7)).norm(), 1e-10);
}

TEST(DeformationTransfer, MirroredMapsMustBothBeMirrored)
{
  const MappedMesh source = body(10, egg);
  MappedMesh mirrored = source;
  mirrored.SpherePositions.col(2) *= -1.0;
  EXPECT_NE(messageOf(source, mirrored).find("reflects it"), std::string::npos);
  const Points pose = bent(source.Positions, 1.0);
  const Points found = DeformationTransfer(mirrored, mirrored, {}).transfer(pose).Positions;
  EXPECT_LT(largestDistance(found, pose), 1e-10);
}

TEST(DeformationTransfer, SurfacesMayBeInsideOut)
{
  const MappedMesh source = body(10, egg);
  MappedMesh target = source;
  target.Triangles.col(1).swap(target.Triangles.col(2));
  const Points pose = bent(source.Positions, 1.0);
  const Points found = DeformationTransfer(source, target, {}).transfer(pose).Positions;
  EXPECT_LT(largestDistance(found, pose), 1e-10);
}

TEST(DeformationTransfer, BadInputIsReported)
{
  const MappedMesh good = body(10, egg);
  MappedMesh bad = good;
  bad.Positions(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(messageOf(bad, good), "some points of the source are not finite");
  EXPECT_EQ(messageOf(good, bad), "some points of the target are not finite");
  bad = good;
  bad.Triangles.conservativeResize(good.Triangles.rows() - 1, 3);
  EXPECT_NE(messageOf(good, bad).find("the target is open"), std::string::npos);
  bad.Triangles.resize(0, 3);
  EXPECT_EQ(messageOf(bad, good), "the source has no triangles");
  bad = good;
  bad.Positions.setZero();
  EXPECT_EQ(messageOf(good, bad), "all triangles of the target have zero area");
  EXPECT_EQ(messageOf(bad, good), "all triangles of the source have zero area");
  bad = good;
  bad.SpherePositions.row(0) = bad.SpherePositions.row(1).eval();
  bad.SpherePositions.row(20) *= -1.0;
  EXPECT_NE(messageOf(good, bad).find("without folds"), std::string::npos);

  const DeformationTransfer transfer(good, good, {});
  EXPECT_THROW(transfer.transfer(body(9, egg).Positions), std::invalid_argument);
  Points pose = good.Positions;
  pose(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(transfer.transfer(pose), std::invalid_argument);
}

TEST(DeformationTransfer, CanBeAbortedAndHasTheSameBitsOnAllThreads)
{
  const MappedMesh source = body(24, egg), target = body(20, bean);
  const Points pose = bent(source.Positions, 1.0);
  const auto with = [&](const conformal::Run& run) {
    return DeformationTransfer(source, target, { 1, 2, 3 }, {}, run).transfer(pose, run).Positions;
  };
  EXPECT_EQ(with({}), with(runs::backwards()));
  EXPECT_THROW(with(runs::stoppingAt(0.3)), conformal::Aborted);
  const DeformationTransfer transfer(source, target, {});
  EXPECT_THROW(transfer.transfer(pose, runs::stoppingAt(0.4)), conformal::Aborted);
  runs::Watch preparing, watch;
  const DeformationTransfer watched(source, target, {}, {}, preparing.run());
  EXPECT_EQ(preparing.last(), 1.0);
  watched.transfer(pose, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
}
