#include "Repair/LoopCap.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/Mesh.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::areaOf;
using conformal::capLoop;
using conformal::checkGenusZero;
using conformal::Index;
using conformal::LoopCap;
using conformal::Pi;
using conformal::Points;
using conformal::Vector3;

namespace
{
bool noneJoined(int, int)
{
  return false;
}

Points circle(int size)
{
  Points corners(size, 3);
  for (int i = 0; i < size; ++i)
  {
    const double t = 2.0 * Pi * i / size;
    corners.row(i) << std::cos(t), std::sin(t), 3.0;
  }
  return corners;
}

// A comb: bays so deep that a ring inside would cross them.
Points comb(int teeth)
{
  Points corners(4 * teeth + 2, 3);
  Index n = 0;
  corners.row(n++) << 0.0, -1.0, 0.0;
  corners.row(n++) << 2.0 * teeth - 1.0, -1.0, 0.0;
  for (int i = teeth - 1; i >= 0; --i)
  {
    corners.row(n++) << 2.0 * i + 1.0, 5.0, 0.0;
    corners.row(n++) << 2.0 * i, 5.0, 0.0;
    if (i > 0)
    {
      corners.row(n++) << 2.0 * i, 0.0, 0.0;
      corners.row(n++) << 2.0 * i - 1.0, 0.0, 0.0;
    }
  }
  corners.conservativeResize(n, 3);
  return corners;
}

// The boundary of a cap is its loop, once around and in its direction, and it is a disk.
void expectDisk(const LoopCap& cap, Index size)
{
  const auto report = checkGenusZero(cap.Triangles, size + cap.Added.rows());
  EXPECT_EQ(report.EulerNumber, 1);
  EXPECT_TRUE(report.manifold());
  EXPECT_TRUE(report.InconsistentEdges.empty());
  EXPECT_EQ(report.NumberOfComponents, 1);
  EXPECT_TRUE(report.IsolatedPoints.empty());
  ASSERT_EQ(static_cast<Index>(report.BoundaryEdges.size()), size);
  for (const auto& [from, to] : report.BoundaryEdges)
  {
    EXPECT_LT(from, size);
    EXPECT_EQ(to, (from + 1) % size);
  }
  ASSERT_EQ(cap.Added.rows(), static_cast<Index>(cap.Parents.size()));
  for (const auto& [first, last] : cap.Parents)
  {
    EXPECT_GE(first, 0);
    EXPECT_LT(first, last);
    EXPECT_LE(last, size);
  }
}
}

TEST(LoopCap, IsADiskWhateverTheNumberOfCorners)
{
  for (int size = 3; size < 200; ++size)
  {
    SCOPED_TRACE(size);
    expectDisk(capLoop(circle(size), noneJoined), size);
  }
}

// A flat convex loop is filled by as much as it encloses, so nothing folds.
TEST(LoopCap, FillsWhatACircleEncloses)
{
  for (const int size : { 3, 4, 7, 11, 64, 1001 })
  {
    const Points corners = circle(size);
    const double area = 0.5 * size * std::sin(2.0 * Pi / size);
    EXPECT_NEAR(areaOf(capLoop(corners, noneJoined), corners), area, 1e-12 * area) << size;
  }
}

TEST(LoopCap, HasWellShapedTrianglesInACircle)
{
  for (const int size : { 12, 50, 64, 500, 4096 })
  {
    const Points corners = circle(size);
    const LoopCap cap = capLoop(corners, noneJoined);
    Points all(size + cap.Added.rows(), 3);
    all << corners, cap.Added;
    double least = 1.0; // 1 for an equilateral triangle
    for (Index r = 0; r < cap.Triangles.rows(); ++r)
    {
      double squares = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        squares +=
          (all.row(cap.Triangles(r, k)) - all.row(cap.Triangles(r, (k + 1) % 3))).squaredNorm();
      }
      least = std::min(least,
        4.0 * std::sqrt(3.0) * conformal::areaVector(all, cap.Triangles, r).norm() / squares);
    }
    EXPECT_GT(least, 0.4) << size;
    EXPECT_LT(cap.Added.rows(), 2 * size);
  }
}

TEST(LoopCap, FillsBaysWithoutFolds)
{
  const int teeth = 5;
  const Points corners = comb(teeth);
  const LoopCap cap = capLoop(corners, noneJoined);
  expectDisk(cap, corners.rows());
  EXPECT_NEAR(areaOf(cap, corners), 5.0 * teeth + (2.0 * teeth - 1.0), 1e-12);
}

// Then rings, though folded, are better than an edge that is there twice.
TEST(LoopCap, JoinsNoCornersThatAreJoined)
{
  const Points corners = comb(5);
  const LoopCap cap = capLoop(corners, [](int, int) { return true; });
  expectDisk(cap, corners.rows());
  EXPECT_GT(cap.Added.rows(), 0);
}

TEST(LoopCap, ClosesFlatLoopsToo)
{
  Points corners = Points::Zero(12, 3);
  expectDisk(capLoop(corners, noneJoined), 12);
  for (int i = 0; i < 12; ++i)
  {
    corners(i, 0) = i;
  }
  const LoopCap cap = capLoop(corners, noneJoined);
  expectDisk(cap, 12);
  EXPECT_TRUE(cap.Added.allFinite());
}

TEST(LoopCap, IsAFanWhereAsked)
{
  expectDisk(conformal::fanOf(circle(3)), 3);
  EXPECT_EQ(conformal::fanOf(circle(30)).Added.rows(), 1);
}
