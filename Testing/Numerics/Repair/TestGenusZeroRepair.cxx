#include "Repair/GenusZeroRepair.h"

#include "Base/Random.h"
#include "HandleMeshes.h"
#include "Mesh/GenusZeroCheck.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>
#include <string>

using conformal::checkGenusZero;
using conformal::GenusZeroRepairOptions;
using conformal::GenusZeroRepairResult;
using conformal::Index;
using conformal::Points;
using conformal::repairGenusZero;
using conformal::RepairLoopType;
using conformal::Triangles;

namespace
{
GenusZeroRepairResult repair(
  const conformal::Mesh& mesh, const conformal::Run& run = {}, double maximumHoleArea = 0.25)
{
  GenusZeroRepairOptions options;
  options.MaximumHoleArea = maximumHoleArea;
  return repairGenusZero(mesh.Positions, mesh.Triangles, options, run);
}

// What was not added has the coordinates of the input, to the bit, and turns as there.
void expectUntouched(const conformal::Mesh& mesh, const GenusZeroRepairResult& result)
{
  Index untouched = 0;
  for (Index r = 0; r < result.Triangles.rows(); ++r)
  {
    const int id = result.TriangleIds[r];
    if (id < 0)
    {
      continue;
    }
    ++untouched;
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_TRUE(
        result.Positions.row(result.Triangles(r, k)) == mesh.Positions.row(mesh.Triangles(id, k)));
    }
  }
  EXPECT_EQ(untouched, result.NumberOfTrianglesUntouched);
  EXPECT_EQ(result.Triangles.rows() - untouched, result.NumberOfTrianglesAdded);
  std::size_t added = 0;
  for (std::size_t v = 0; v < result.PointIds.size(); ++v)
  {
    added += result.PointIds[v] < 0;
    EXPECT_TRUE(v == 0 || result.PointIds[v] >= 0 || result.PointIds[v] == -1);
  }
  ASSERT_EQ(added, result.Parents.size());
  for (const auto& parents : result.Parents)
  {
    EXPECT_FALSE(parents.empty());
    for (const int id : parents)
    {
      EXPECT_GE(id, 0);
      EXPECT_LT(id, mesh.Positions.rows());
    }
  }
}

void expectGenusZero(const GenusZeroRepairResult& result)
{
  const auto report = checkGenusZero(result.Triangles, result.Positions.rows(), result.Positions);
  EXPECT_TRUE(report.isGenusZero());
  EXPECT_TRUE(report.InconsistentEdges.empty());
  EXPECT_FALSE(report.InsideOut);
  EXPECT_TRUE(report.IsolatedPoints.empty());
  EXPECT_EQ(report.EulerNumber, 2);
  EXPECT_TRUE(result.IsGenusZero);
}

void appendSphere(conformal::Mesh& mesh, double radius, double x)
{
  const conformal::Mesh other = conformal::makeGeodesicSphere(4);
  const Index points = mesh.Positions.rows(), triangles = mesh.Triangles.rows();
  mesh.Positions.conservativeResize(points + other.Positions.rows(), 3);
  mesh.Positions.bottomRows(other.Positions.rows()) = radius * other.Positions;
  mesh.Positions.bottomRows(other.Positions.rows()).col(0).array() += x;
  mesh.Triangles.conservativeResize(triangles + other.Triangles.rows(), 3);
  mesh.Triangles.bottomRows(other.Triangles.rows()) =
    other.Triangles.array() + static_cast<int>(points);
}

std::string messageOf(const conformal::Mesh& mesh)
{
  try
  {
    repair(mesh);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}
}

TEST(GenusZeroRepair, LeavesAClosedSurfaceAlone)
{
  const conformal::Mesh mesh = conformal::makeGeodesicSphere(8);
  const GenusZeroRepairResult result = repair(mesh);
  EXPECT_TRUE(result.Triangles == mesh.Triangles);
  EXPECT_TRUE(result.Positions == mesh.Positions);
  EXPECT_TRUE(result.Loops.empty());
  expectGenusZero(result);
}

TEST(GenusZeroRepair, CutsHandles)
{
  for (const int count : { 1, 5, 50 })
  {
    SCOPED_TRACE(count);
    const conformal::Mesh mesh = handles::sphereWithHandles(count, 60);
    EXPECT_EQ(checkGenusZero(mesh.Triangles, mesh.Positions.rows()).EulerNumber, 2 - 2 * count);
    const GenusZeroRepairResult result = repair(mesh);
    expectGenusZero(result);
    expectUntouched(mesh, result);
    EXPECT_EQ(result.count(RepairLoopType::CutHandle), count);
    EXPECT_EQ(static_cast<Index>(result.Loops.size()), count);
    EXPECT_EQ(result.NumberOfTrianglesUntouched, mesh.Triangles.rows());
    for (const auto& loop : result.Loops)
    {
      EXPECT_LE(loop.Positions.rows(), 12);
    }
  }
}

// A straight tube through the sphere is a hole through the body: it is filled.
TEST(GenusZeroRepair, FillsTunnels)
{
  handles::Mesh sphere = handles::sphere(40);
  handles::addTube(sphere, 500, static_cast<int>(handles::spread(sphere, 2, 500)[1]), 2, 60, false);
  const conformal::Mesh mesh = handles::toCore(sphere);
  const GenusZeroRepairResult result = repair(mesh);
  expectGenusZero(result);
  expectUntouched(mesh, result);
  EXPECT_EQ(result.count(RepairLoopType::FilledTunnel), 1);
  EXPECT_EQ(result.count(RepairLoopType::CutHandle), 0);
}

TEST(GenusZeroRepair, CutsATorusWhereItIsThinnest)
{
  GenusZeroRepairResult result = repair(handles::torus(12, 60));
  expectGenusZero(result);
  EXPECT_EQ(result.count(RepairLoopType::CutHandle), 1);
  result = repair(handles::torus(60, 16, 0.8));
  expectGenusZero(result);
  EXPECT_EQ(result.count(RepairLoopType::FilledTunnel), 1);
}

TEST(GenusZeroRepair, FillsHolesAndDropsParts)
{
  handles::Mesh sphere = handles::sphere(40);
  handles::addHandles(sphere, 3, 2, 0.4, 20);
  const Index closed = static_cast<Index>(sphere.Triangles.size());
  for (const int point : { 100, 3000, 9000 })
  {
    handles::cutDisk(sphere, point, 3);
  }
  conformal::Mesh mesh = handles::toCore(sphere);
  const Index open = mesh.Triangles.rows();
  appendSphere(mesh, 0.1, 3.0);
  appendSphere(mesh, 0.2, -3.0);
  const GenusZeroRepairResult result = repair(mesh);
  expectGenusZero(result);
  expectUntouched(mesh, result);
  EXPECT_EQ(result.count(RepairLoopType::FilledHole), 3);
  EXPECT_EQ(result.count(RepairLoopType::CutHandle), 3);
  EXPECT_EQ(result.Gluing.NumberOfPartsRemoved, 2);
  EXPECT_EQ(result.Gluing.NumberOfTrianglesRemoved, 640);
  EXPECT_EQ(result.NumberOfTrianglesUntouched, open);
  EXPECT_LT(open, closed);
}

TEST(GenusZeroRepair, LeavesLargeHolesOpen)
{
  handles::Mesh sphere = handles::sphere(40);
  handles::addHandles(sphere, 2, 2, 0.4, 20);
  handles::cutDisk(sphere, 100, 3);
  conformal::Mesh mesh = handles::toCore(sphere);
  Index kept = 0;
  double area = 0.0; // of the hole, seen along x
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const bool isCap = mesh.Positions(mesh.Triangles(r, 0), 0) > 0.8 &&
      mesh.Positions(mesh.Triangles(r, 1), 0) > 0.8 &&
      mesh.Positions(mesh.Triangles(r, 2), 0) > 0.8;
    if (isCap)
    {
      area += conformal::areaVector(mesh.Positions, mesh.Triangles, r)[0];
    }
    else
    {
      mesh.Triangles.row(kept++) = mesh.Triangles.row(r);
    }
  }
  mesh.Triangles.conservativeResize(kept, 3);
  const GenusZeroRepairResult open = repair(mesh, {}, 0.02);
  EXPECT_FALSE(open.IsGenusZero);
  EXPECT_EQ(open.count(RepairLoopType::OpenHole), 1);
  EXPECT_EQ(open.count(RepairLoopType::FilledHole), 1);
  const auto report = checkGenusZero(open.Triangles, open.Positions.rows());
  EXPECT_EQ(report.NumberOfBoundaryLoops, 1);
  EXPECT_EQ(report.EulerNumber, 1); // but for that hole it is a sphere
  EXPECT_TRUE(report.manifold());
  expectUntouched(mesh, open);
  EXPECT_EQ(open.NumberOfTrianglesUntouched, kept);

  const GenusZeroRepairResult filled = repair(mesh);
  expectGenusZero(filled);
  for (const auto& loop : open.Loops)
  {
    if (loop.Type == RepairLoopType::OpenHole)
    {
      area /= conformal::surfaceArea(mesh.Positions, mesh.Triangles);
      EXPECT_NEAR(loop.AreaFraction, area, 0.03 * area); // its rim is jagged
    }
  }
}

TEST(GenusZeroRepair, MergesTurnsAndOrientsOutward)
{
  const conformal::Mesh sphere = handles::sphereWithHandles(2);
  conformal::Mesh soup;
  soup.Positions.resize(sphere.Triangles.size(), 3);
  soup.Triangles.resize(sphere.Triangles.rows(), 3);
  for (Index i = 0; i < sphere.Triangles.size(); ++i)
  {
    soup.Positions.row(i) = sphere.Positions.row(sphere.Triangles.data()[i]);
    soup.Triangles.data()[i] = static_cast<int>(i);
  }
  for (Index r = 0; r < soup.Triangles.rows(); ++r)
  {
    if (r % 5 > 0) // most of them
    {
      std::swap(soup.Triangles(r, 1), soup.Triangles(r, 2));
    }
  }
  const GenusZeroRepairResult result = repair(soup);
  expectGenusZero(result);
  const Index used = checkGenusZero(sphere.Triangles, sphere.Positions.rows()).NumberOfVertices;
  EXPECT_EQ(result.NumberOfPointsMerged, soup.Positions.rows() - used);
  EXPECT_EQ(result.NumberOfTrianglesUntouched, soup.Triangles.rows());
  EXPECT_EQ(
    result.Gluing.NumberOfTurnedTriangles, soup.Triangles.rows() - (soup.Triangles.rows() + 4) / 5);
  EXPECT_EQ(result.count(RepairLoopType::CutHandle), 2);
}

// Its own output needs nothing.
TEST(GenusZeroRepair, IsDoneOnce)
{
  const GenusZeroRepairResult first = repair(handles::sphereWithHandles(5));
  const GenusZeroRepairResult second = repair(first);
  EXPECT_TRUE(first.Triangles == second.Triangles);
  EXPECT_TRUE(first.Positions == second.Positions);
}

TEST(GenusZeroRepair, HasTheSameBitsOnAnyThreadsAndAtAnyScale)
{
  conformal::Mesh mesh = handles::sphereWithHandles(5);
  const GenusZeroRepairResult one = repair(mesh), two = repair(mesh, runs::backwards());
  EXPECT_TRUE(one.Triangles == two.Triangles);
  EXPECT_TRUE(one.Positions == two.Positions);
  mesh.Positions *= 1024.0;
  const GenusZeroRepairResult large = repair(mesh);
  EXPECT_TRUE(one.Triangles == large.Triangles);
  EXPECT_TRUE(1024.0 * one.Positions == large.Positions);
}

TEST(GenusZeroRepair, ReportsProgressAndStops)
{
  const conformal::Mesh mesh = handles::sphereWithHandles(5);
  runs::Watch watch;
  repair(mesh, watch.run());
  EXPECT_GT(watch.calls(), 5);
  EXPECT_THROW(repair(mesh, runs::stoppingAt(0.6)), conformal::Aborted);
}

TEST(GenusZeroRepair, SaysWhatItCannotRepair)
{
  conformal::Mesh mesh;
  mesh.Positions.resize(0, 3);
  mesh.Triangles.resize(0, 3);
  EXPECT_EQ(messageOf(mesh), "the surface has no triangles");
  mesh = conformal::makeGeodesicSphere(3);
  mesh.Positions(7, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(messageOf(mesh), "1 of 92 points of the surface are not finite");
  mesh = conformal::makeGeodesicSphere(3);
  mesh.Triangles.col(1) = mesh.Triangles.col(0);
  EXPECT_EQ(messageOf(mesh), "every triangle of the surface has a repeated point");

  // A tube closed upon itself with the wrong side in: a Klein bottle.
  const int around = 10, along = 12;
  mesh = handles::torus(around, along);
  for (Index i = 0; i < mesh.Triangles.size(); ++i)
  {
    const Index r = i / 3;
    int& id = mesh.Triangles.data()[i];
    if (r / (2 * around) == along - 1 && id < around) // the last ring of quads meets the first
    {
      id = (around - id) % around;
    }
  }
  EXPECT_NE(messageOf(mesh).find("not orientable"), std::string::npos) << messageOf(mesh);
  EXPECT_THROW(repair(conformal::makeGeodesicSphere(3), {}, 1.5), std::invalid_argument);
}

TEST(GenusZeroRepair, ForgivesPointsOfNoTriangleThatAreNotFinite)
{
  conformal::Mesh mesh = conformal::makeGeodesicSphere(3);
  mesh.Positions.conservativeResize(93, 3);
  mesh.Positions.bottomRows(1).setConstant(std::numeric_limits<double>::quiet_NaN());
  const GenusZeroRepairResult result = repair(mesh);
  expectGenusZero(result);
  EXPECT_EQ(result.Positions.rows(), 92);
}

// Random triangles between few points: every way in which meshes can be broken.
TEST(GenusZeroRepair, MakesASphereOfWhateverIsOrientable)
{
  conformal::Random random(3);
  int repaired = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Index points = 4 + random.index(12), triangles = 1 + random.index(40);
    conformal::Mesh mesh;
    mesh.Positions.resize(points, 3);
    for (Index k = 0; k < mesh.Positions.size(); ++k)
    {
      mesh.Positions.data()[k] = static_cast<double>(random.index(5));
    }
    mesh.Triangles.resize(triangles, 3);
    for (Index k = 0; k < mesh.Triangles.size(); ++k)
    {
      mesh.Triangles.data()[k] = static_cast<int>(random.index(points));
    }
    try
    {
      const GenusZeroRepairResult result = repair(mesh, {}, 1.0);
      bool isOpen = result.count(RepairLoopType::OpenHole) > 0;
      ASSERT_TRUE(isOpen || result.IsGenusZero) << i;
      ++repaired;
    }
    catch (const std::invalid_argument&)
    {
    }
  }
  EXPECT_GT(repaired, 1000);
}
