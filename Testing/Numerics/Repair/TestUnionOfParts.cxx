#include "Repair/UnionOfParts.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Repair/GenusZeroRepair.h"
#include "Runs.h"
#include "Search/SelfIntersections.h"

#include <gtest/gtest.h>

#include <vector>

using conformal::GenusZeroRepairResult;
using conformal::Index;
using conformal::Mesh;
using conformal::Pi;
using conformal::Points;
using conformal::uniteParts;
using conformal::Vector3;

namespace
{
struct Ball
{
  Vector3 Center;
  double Radius;
};

Mesh ballsOf(const std::vector<Ball>& balls, int frequency)
{
  Mesh all;
  for (const Ball& ball : balls)
  {
    const Mesh sphere = conformal::makeGeodesicSphere(frequency);
    const Index points = all.Positions.rows(), triangles = all.Triangles.rows();
    all.Positions.conservativeResize(points + sphere.Positions.rows(), 3);
    all.Triangles.conservativeResize(triangles + sphere.Triangles.rows(), 3);
    all.Positions.bottomRows(sphere.Positions.rows()) =
      (ball.Radius * sphere.Positions).rowwise() + ball.Center.transpose();
    all.Triangles.bottomRows(sphere.Triangles.rows()) =
      sphere.Triangles.array() + static_cast<int>(points);
  }
  return all;
}

// @param[in] corners  lowest and highest corner of each box
Mesh boxesOf(const std::vector<Vector3>& corners)
{
  const Index count = static_cast<Index>(corners.size()) / 2;
  Mesh mesh;
  mesh.Positions.resize(8 * count, 3);
  mesh.Triangles.resize(12 * count, 3);
  for (Index box = 0; box < count; ++box)
  {
    for (int i = 0; i < 8; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        mesh.Positions(8 * box + i, k) = corners[2 * box + ((i >> k) & 1)][k];
      }
    }
    mesh.Triangles.middleRows(12 * box, 12) << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
      2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5;
    mesh.Triangles.middleRows(12 * box, 12).array() += static_cast<int>(8 * box);
  }
  return mesh;
}

GenusZeroRepairResult repairOf(const Mesh& mesh)
{
  return conformal::repairGenusZero(mesh.Positions, mesh.Triangles);
}

// Volume of the union of two balls of radius 1 whose centers have distance d.
double volumeOfTwo(double d)
{
  const double lens = Pi * (4.0 + d) * (2.0 - d) * (2.0 - d) / 12.0;
  return 8.0 * Pi / 3.0 - lens;
}

void expectClean(const GenusZeroRepairResult& result)
{
  EXPECT_TRUE(result.IsGenusZero);
  EXPECT_TRUE(conformal::selfIntersections(result.Positions, result.Triangles).empty());
}
}

TEST(UnionOfParts, HasTheVolumeOfTwoOverlappingBalls)
{
  double before = 0.0;
  for (const int frequency : { 10, 20, 40 })
  {
    const Mesh mesh =
      ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3(0.9, 0.7, 0.3), 1.0 } }, frequency);
    const GenusZeroRepairResult result = repairOf(mesh);
    expectClean(result);
    EXPECT_EQ(result.NumberOfPartsJoined, 1);
    EXPECT_EQ(result.Gluing.NumberOfPartsRemoved, 0);
    const double error = std::abs(conformal::signedVolume(result.Positions, result.Triangles) /
        volumeOfTwo(Vector3(0.9, 0.7, 0.3).norm()) -
      1.0);
    EXPECT_LT(error, 1.6 / frequency / frequency);
    EXPECT_TRUE(before == 0.0 || error < 0.3 * before); // quadratic in the size of triangles
    before = error;
  }
}

// Each point of the union is on a sphere and in none of the others.
TEST(UnionOfParts, JoinsChainsWithCommonCurves)
{
  const std::vector<Ball> balls = { { Vector3::Zero(), 1.0 }, { Vector3(1.2, 0.1, 0.05), 0.8 },
    { Vector3(0.6, 1.0, 0.1), 0.7 }, { Vector3(2.2, 0.2, 0.3), 0.6 } };
  const Mesh mesh = ballsOf(balls, 16);
  const GenusZeroRepairResult result = repairOf(mesh);
  expectClean(result);
  EXPECT_EQ(result.NumberOfPartsJoined, 3);
  for (Index v = 0; v < result.Positions.rows(); ++v)
  {
    int touched = 0;
    for (const Ball& ball : balls)
    {
      const double distance =
        (Vector3(result.Positions.row(v)) - ball.Center).norm() / ball.Radius - 1.0;
      EXPECT_GT(distance, -0.01);
      touched += std::abs(distance) < 0.01;
    }
    EXPECT_GE(touched, 1);
  }
}

// A plinth of twelve triangles is split by thousands of small ones.
TEST(UnionOfParts, JoinsLargeTrianglesWithSmallOnes)
{
  Mesh mesh = ballsOf({ { Vector3(0.1, 0.05, 0.8), 1.0 } }, 60);
  const Index first = mesh.Positions.rows(), triangles = mesh.Triangles.rows();
  mesh.Positions.conservativeResize(first + 8, 3);
  for (int i = 0; i < 8; ++i)
  {
    mesh.Positions.row(first + i) << (i & 1 ? 2.0 : -2.0), (i & 2 ? 2.0 : -2.0),
      (i & 4 ? 0.0 : -1.0);
  }
  mesh.Triangles.conservativeResize(triangles + 12, 3);
  mesh.Triangles.bottomRows(12) << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3,
    6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5;
  mesh.Triangles.bottomRows(12).array() += static_cast<int>(first);
  const GenusZeroRepairResult result = repairOf(mesh);
  expectClean(result);
  const double below = Pi * 0.2 * 0.2 * (3.0 - 0.2) / 3.0; // part of the ball inside of the plinth
  EXPECT_NEAR(conformal::signedVolume(result.Positions, result.Triangles),
    16.0 + 4.0 * Pi / 3.0 - below, 4e-3);
}

// Points, edges and triangles of symmetric parts coincide.
TEST(UnionOfParts, JoinsSymmetricParts)
{
  const Mesh ball = ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3(0.5, 0.0, 0.0), 1.0 } }, 8);
  const GenusZeroRepairResult result = repairOf(ball);
  EXPECT_TRUE(result.IsGenusZero);
  EXPECT_EQ(result.NumberOfPartsJoined, 1);
  EXPECT_NEAR(
    conformal::signedVolume(result.Positions, result.Triangles) / volumeOfTwo(0.5), 1.0, 0.03);
}

TEST(UnionOfParts, LeavesSeparateNestedAndReversedPartsAlone)
{
  Mesh apart = ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3(3.0, 0.0, 0.0), 1.0 } }, 8);
  EXPECT_EQ(uniteParts(apart.Positions, apart.Triangles).NumberOfPartsJoined, 0);
  Mesh nested = ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3::Zero(), 0.5 } }, 8);
  EXPECT_EQ(uniteParts(nested.Positions, nested.Triangles).NumberOfPartsJoined, 0);
  nested.Triangles.bottomRows(nested.Triangles.rows() / 2).rowwise().reverseInPlace();
  EXPECT_EQ(uniteParts(nested.Positions, nested.Triangles).NumberOfPartsJoined, 0);
}

// Faults of single triangles do not open a part, and a part that crosses another is no cavity.
TEST(UnionOfParts, JoinsPartsWithFaultyTriangles)
{
  const Mesh sound = ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3(0.9, 0.7, 0.3), 1.0 } }, 8);
  const Index count = sound.Triangles.rows();
  const GenusZeroRepairResult expected = repairOf(sound);
  Mesh duplicate = sound, repeated = sound, turned = sound, inside = sound;
  duplicate.Triangles.conservativeResize(count + 1, 3);
  duplicate.Triangles.row(count) = sound.Triangles.row(count - 1);
  repeated.Triangles.conservativeResize(count + 1, 3);
  repeated.Triangles.row(count) = sound.Triangles.row(count - 1);
  repeated.Triangles(count, 1) = repeated.Triangles(count, 0);
  turned.Triangles.row(5).reverseInPlace();
  inside.Triangles.bottomRows(count / 2).rowwise().reverseInPlace();
  for (const Mesh& mesh : { duplicate, repeated, turned, inside })
  {
    const GenusZeroRepairResult result = repairOf(mesh);
    expectClean(result);
    EXPECT_EQ(result.NumberOfPartsJoined, 1);
    EXPECT_EQ(result.Gluing.NumberOfPartsRemoved, 0);
    EXPECT_NEAR(conformal::signedVolume(result.Positions, result.Triangles),
      conformal::signedVolume(expected.Positions, expected.Triangles), 1e-9);
  }
  EXPECT_EQ(repairOf(duplicate).Gluing.NumberOfDuplicates, 1);
  EXPECT_EQ(repairOf(repeated).Gluing.NumberOfRepeatedPoints, 1);
  EXPECT_EQ(repairOf(sound).Gluing.NumberOfTurnedTriangles, 0);
  EXPECT_GT(repairOf(inside).Gluing.NumberOfTurnedTriangles, count / 4);
}

TEST(UnionOfParts, JoinsPartsWithACommonPoint)
{
  Mesh mesh = ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3(0.9, 0.7, 0.3), 1.0 } }, 8);
  const Index points = mesh.Positions.rows() / 2;
  Index closest = 0, first = 0;
  double least = 10.0;
  for (Index i = 0; i < points; ++i)
  {
    for (Index j = points; j < 2 * points; ++j)
    {
      const double distance = (mesh.Positions.row(i) - mesh.Positions.row(j)).norm();
      if (distance < least)
      {
        least = distance;
        first = i;
        closest = j;
      }
    }
  }
  for (Index i = 0; i < mesh.Triangles.size(); ++i)
  {
    int& id = mesh.Triangles.data()[i];
    id = id == closest ? static_cast<int>(first) : id;
  }
  const GenusZeroRepairResult result = repairOf(mesh);
  EXPECT_TRUE(result.IsGenusZero);
  EXPECT_EQ(result.NumberOfPartsJoined, 1);
  EXPECT_EQ(result.Gluing.NumberOfPartsRemoved, 0);
  for (std::size_t v = 0; v < result.PointIds.size(); ++v)
  {
    const int id = result.PointIds[v];
    EXPECT_TRUE(id < 0 || result.Positions.row(static_cast<Index>(v)) == mesh.Positions.row(id));
  }
}

TEST(UnionOfParts, JoinsPartsFarFromTheOrigin)
{
  Mesh mesh = ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3(0.9, 0.7, 0.3), 1.0 } }, 8);
  mesh.Positions.rowwise() += Eigen::RowVector3d(5e5, 4e6, 100.0);
  const GenusZeroRepairResult result = repairOf(mesh);
  EXPECT_TRUE(result.IsGenusZero);
  EXPECT_EQ(result.NumberOfPartsJoined, 1);
}

TEST(UnionOfParts, JoinsBoxesWithFlushFaces)
{
  const GenusZeroRepairResult result = repairOf(
    boxesOf({ { 0.0, 0.0, 0.0 }, { 2.0, 1.0, 1.0 }, { 1.0, 0.0, 0.0 }, { 3.0, 1.0, 1.0 } }));
  EXPECT_TRUE(result.IsGenusZero);
  EXPECT_EQ(result.NumberOfPartsJoined, 1);
  EXPECT_NEAR(conformal::signedVolume(result.Positions, result.Triangles), 3.0, 1e-8);
  const auto joinedOf = [](const std::vector<Vector3>& corners)
  {
    const Mesh mesh = boxesOf(corners);
    return uniteParts(mesh.Positions, mesh.Triangles).NumberOfPartsJoined;
  };
  const Vector3 zero = Vector3::Zero(), one = Vector3::Ones();
  EXPECT_EQ(joinedOf({ zero, one, zero, one }), 0);                            // a copy
  EXPECT_EQ(joinedOf({ zero, one, zero, 0.5 * one }), 0);                      // inside
  EXPECT_EQ(joinedOf({ zero, one, { 1.0, 0.0, 0.0 }, { 2.0, 1.0, 1.0 } }), 0); // touching
  EXPECT_EQ(joinedOf({ zero, one, { -1.0, 0.0, 0.0 }, { 0.0, 1.0, 1.0 } }), 0);
}

TEST(UnionOfParts, KeepsTrianglesOutsideBitByBit)
{
  const Mesh mesh = ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3(0.9, 0.7, 0.3), 1.0 } }, 12);
  const GenusZeroRepairResult result = repairOf(mesh);
  for (Index r = 0; r < result.NumberOfTrianglesUntouched; ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(result.Positions.row(result.Triangles(r, k)),
        mesh.Positions.row(mesh.Triangles(result.TriangleIds[r], k)));
    }
  }
  // A piece is inside of the triangle that it is a piece of.
  for (Index r = result.NumberOfTrianglesUntouched; r < result.Triangles.rows(); ++r)
  {
    const int id = result.TriangleIds[r];
    ASSERT_GE(id, 0);
    const Vector3 a = mesh.Positions.row(mesh.Triangles(id, 0)),
                  b = mesh.Positions.row(mesh.Triangles(id, 1)),
                  c = mesh.Positions.row(mesh.Triangles(id, 2)), normal = (b - a).cross(c - a);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 x = result.Positions.row(result.Triangles(r, k));
      EXPECT_LT(std::abs((x - a).dot(normal)) / normal.norm(), 1e-12);
      EXPECT_GT((b - a).cross(x - a).dot(normal), -1e-12 * normal.squaredNorm());
      EXPECT_GT((c - b).cross(x - b).dot(normal), -1e-12 * normal.squaredNorm());
      EXPECT_GT((a - c).cross(x - c).dot(normal), -1e-12 * normal.squaredNorm());
    }
  }
}

TEST(UnionOfParts, HasTheSameBitsOnAnyThreadsAndStops)
{
  const Mesh mesh = ballsOf({ { Vector3::Zero(), 1.0 }, { Vector3(0.9, 0.7, 0.3), 1.0 } }, 12);
  const auto of = [&](const conformal::Run& run)
  { return uniteParts(mesh.Positions, mesh.Triangles, run); };
  const conformal::UnionOfParts one = of({}), two = of(runs::backwards());
  EXPECT_EQ(one.Positions, two.Positions);
  EXPECT_EQ(one.Triangles, two.Triangles);
  EXPECT_THROW(of(runs::stoppingAt(0.0)), conformal::Aborted);
  runs::Watch watch; // each triangle that is split is reported
  of(watch.run());
  EXPECT_GT(watch.calls(), 100);
}
