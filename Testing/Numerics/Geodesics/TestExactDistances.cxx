#include "Geodesics/ExactDistances.h"

#include "Base/AllColumns.h"
#include "Mesh/GeodesicSphere.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

using conformal::ExactDistances;
using conformal::Index;
using conformal::Mesh;
using conformal::NearestSources;
using conformal::PathPoint;
using conformal::Points;
using conformal::Vector3;

namespace
{
// A rectangle of cells with sides of length 1, divided by diagonals of random directions. Cells for
// which `isHole` is true are left out.
template <typename IsHole>
Mesh grid(int columns, int rows, const IsHole& isHole)
{
  std::mt19937 random(5);
  Mesh mesh;
  mesh.Positions.resize((columns + 1) * (rows + 1), 3);
  std::vector<Eigen::RowVector3i> triangles;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const int a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
      mesh.Positions.row(a) << i, j, 0.0;
      if (i < columns && j < rows && !isHole(i, j))
      {
        const bool isRising = random() % 2 == 0;
        triangles.emplace_back(a, b, isRising ? c : d);
        triangles.emplace_back(
          isRising ? Eigen::RowVector3i(a, c, d) : Eigen::RowVector3i(b, c, d));
      }
    }
  }
  mesh.Triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    mesh.Triangles.row(t) = triangles[t];
  }
  return mesh;
}

Mesh sphere(int frequency)
{
  const auto geodesic = conformal::makeGeodesicSphere(frequency);
  return { geodesic.Positions, geodesic.Triangles };
}

// A sphere with bumps and dents, which has many saddles.
Mesh bumpySphere(int frequency)
{
  Mesh mesh = sphere(frequency);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const Vector3 p = mesh.Positions.row(v);
    mesh.Positions.row(v) *= 1.0 + 0.3 * std::sin(5.0 * p.x()) * std::cos(4.0 * p.y() + p.z());
  }
  return mesh;
}
}

TEST(ExactDistances, AreStraightInThePlane)
{
  const Mesh mesh = grid(17, 11, [](int, int) { return false; });
  for (const int source : { 0, 40, 17 })
  {
    const ExactDistances exact(mesh, { source });
    const NearestSources nearest = exact.nearestSources();
    for (Index v = 0; v < mesh.Positions.rows(); ++v)
    {
      const double length = (mesh.Positions.row(v) - mesh.Positions.row(source)).norm();
      EXPECT_NEAR(nearest.Distances[v], length, 1e-12);
      EXPECT_NEAR(lengthOf(exact.pathFrom(static_cast<int>(v)), mesh.Positions), length, 1e-11);
    }
  }
}

TEST(ExactDistances, BendAtTheCornersOfAHole)
{
  // From (0, 3), paths to points in the shade of the hole bend at (4, 1) or (4, 5), or also at (6,
  // 1) or (6, 5).
  const Mesh mesh = grid(10, 6, [](int i, int j) { return i >= 4 && i < 6 && j >= 1 && j < 5; });
  const ExactDistances exact(mesh, { 33 });
  const NearestSources nearest = exact.nearestSources();
  EXPECT_NEAR(nearest.Distances[3 * 11 + 10], 2.0 * std::hypot(4.0, 2.0) + 2.0, 1e-12);
  EXPECT_NEAR(nearest.Distances[6], std::hypot(4.0, 2.0) + std::hypot(2.0, 1.0), 1e-12);
  EXPECT_EQ(exact.pathFrom(33).size(), 1u);
  EXPECT_NEAR(lengthOf(exact.pathFrom(43), mesh.Positions), nearest.Distances[43], 1e-12);
}

// The distance of opposite corners of a box is that of one of three unfoldings.
TEST(ExactDistances, CrossTheEdgesOfABox)
{
  Mesh box;
  box.Positions.resize(8, 3);
  for (int v = 0; v < 8; ++v)
  {
    box.Positions.row(v) << 3.0 * (v & 1), 2.0 * (v >> 1 & 1), (v >> 2 & 1);
  }
  box.Triangles.resize(12, 3);
  box.Triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6,
    0, 6, 2, 1, 3, 7, 1, 7, 5;
  const NearestSources nearest = ExactDistances(box, { 0 }).nearestSources();
  EXPECT_NEAR(
    nearest.Distances[7], std::hypot(3.0, 2.0 + 1.0), 1e-12); // 5 + 1 and 4 + 2 are longer
  EXPECT_NEAR(nearest.Distances[3], std::hypot(3.0, 2.0), 1e-12);
}

TEST(ExactDistances, AreSymmetricAndNotLongerThanOtherPaths)
{
  const Mesh mesh = bumpySphere(9);
  const int size = static_cast<int>(mesh.Positions.rows());
  const conformal::PathStraightener straightener(mesh);
  for (const int source : { 0, 100, 555 })
  {
    const ExactDistances exact(mesh, { source });
    const NearestSources nearest = exact.nearestSources();
    const std::vector<int> ways = conformal::pathsAlongEdges(mesh, { source }).Ways;
    for (int v = 0; v < size; v += 7)
    {
      EXPECT_NEAR(lengthOf(exact.pathFrom(v), mesh.Positions), nearest.Distances[v], 1e-9);
      EXPECT_NEAR(ExactDistances(mesh, { v }).nearestSources().Distances[source],
        nearest.Distances[v], 1e-10);
      std::vector<int> along = { v };
      while (along.back() != source)
      {
        along.push_back(ways[along.back()]);
      }
      if (along.size() > 1)
      {
        EXPECT_LE(
          nearest.Distances[v], lengthOf(straightener.straighten(along), mesh.Positions) + 1e-10);
      }
    }
  }
}

// Triangles divided in the plane are the same surface.
TEST(ExactDistances, DoNotDependOnTriangles)
{
  const Mesh mesh = bumpySphere(6);
  Mesh fine = mesh;
  const Index size = mesh.Positions.rows(), count = mesh.Triangles.rows();
  fine.Positions.conservativeResize(size + count, 3);
  fine.Triangles.resize(3 * count, 3);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0.05, 1.0);
  for (Index t = 0; t < count; ++t)
  {
    const Vector3 weights = Vector3(part(random), part(random), part(random));
    const auto ids = mesh.Triangles.row(t);
    fine.Positions.row(size + t) = weights.transpose() / weights.sum() *
      mesh.Positions({ ids[0], ids[1], ids[2] }, conformal::AllColumns);
    for (int k = 0; k < 3; ++k)
    {
      fine.Triangles.row(3 * t + k) << ids[k], ids[conformal::next(k)], static_cast<int>(size + t);
    }
  }
  const Eigen::VectorXd coarse = ExactDistances(mesh, { 5 }).nearestSources().Distances;
  const Eigen::VectorXd divided = ExactDistances(fine, { 5 }).nearestSources().Distances;
  EXPECT_LT((coarse - divided.head(size)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ExactDistances, AssignTheNearestSource)
{
  const Mesh mesh = bumpySphere(8);
  const std::vector<int> sources = { 3, 200, 411 };
  const NearestSources nearest = ExactDistances(mesh, sources).nearestSources();
  Eigen::MatrixXd each(mesh.Positions.rows(), 3);
  for (int s = 0; s < 3; ++s)
  {
    each.col(s) = ExactDistances(mesh, { sources[s] }).nearestSources().Distances;
  }
  for (Index v = 0; v < each.rows(); ++v)
  {
    EXPECT_NEAR(nearest.Distances[v], each.row(v).minCoeff(), 1e-10);
    EXPECT_NEAR(nearest.Distances[v], each(v, nearest.Positions[v]), 1e-10);
  }
}

TEST(ExactDistances, OtherPartsAreNotReached)
{
  Mesh mesh = grid(3, 2, [](int i, int) { return i == 1; });
  const NearestSources nearest = ExactDistances(mesh, { 0 }).nearestSources();
  EXPECT_EQ(nearest.Distances[3], -1.0);
  EXPECT_EQ(nearest.Positions[3], -1);
  mesh.Triangles.row(1) = mesh.Triangles.row(0);
  EXPECT_THROW(ExactDistances(mesh, { 0 }), std::invalid_argument);
}

// On a needle, many paths around it have equal lengths except for rounding. Parallels of the needle
// have 40 points each.
TEST(ExactDistances, AreFoundInFewStepsOnANeedle)
{
  constexpr int columns = 40, rows = 19;
  constexpr double thickness = 1e-5;
  Mesh mesh;
  mesh.Positions.resize(columns * rows + 2, 3);
  mesh.Positions.row(columns * rows) << 0.0, 0.0, 1.0;
  mesh.Positions.row(columns * rows + 1) << 0.0, 0.0, -1.0;
  mesh.Triangles.resize(2 * columns * rows, 3);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const double along = conformal::Pi * (j + 1) / (rows + 1),
                   around = 2.0 * conformal::Pi * i / columns;
      const int a = j * columns + i, right = j * columns + (i + 1) % columns;
      mesh.Positions.row(a) << thickness * std::sin(along) * std::cos(around),
        thickness * std::sin(along) * std::sin(around), std::cos(along);
      const bool isLast = j + 1 == rows;
      const int below = isLast ? columns * rows + 1 : a + columns,
                diagonal = isLast ? below : right + columns;
      mesh.Triangles.row(2 * a) << a, below, isLast ? right : diagonal;
      mesh.Triangles.row(2 * a + 1) << a, isLast ? below : diagonal, right;
      if (isLast) // no second triangle; that at the first pole instead
      {
        mesh.Triangles.row(2 * a + 1) << columns * rows, i, (i + 1) % columns;
      }
    }
  }
  int reports = 0; // one for many steps
  const conformal::Run run({},
    [&](double)
    {
      ++reports;
      return reports < 100;
    });
  const NearestSources nearest = ExactDistances(mesh, { columns * rows }, run).nearestSources();
  EXPECT_NEAR(nearest.Distances[columns * rows + 1], 2.0, 1e-8);
}

TEST(ExactDistances, FlatTrianglesDoNoHarm)
{
  Mesh mesh = bumpySphere(5);
  mesh.Positions.row(40) = mesh.Positions.row(mesh.Triangles(0, 0));
  mesh.Positions.row(60) = 0.5 * (mesh.Positions.row(61) + mesh.Positions.row(62));
  const ExactDistances exact(mesh, { 7 });
  const Eigen::VectorXd distances = exact.nearestSources().Distances;
  EXPECT_TRUE(distances.allFinite());
  EXPECT_GE(distances.minCoeff(), 0.0);
  const std::vector<double> along = conformal::pathsAlongEdges(mesh, { 7 }).Lengths;
  for (Index v = 0; v < distances.size(); ++v)
  {
    EXPECT_LE(distances[v], along[v]);
    EXPECT_GE(distances[v], (mesh.Positions.row(v) - mesh.Positions.row(7)).norm() - 1e-12);
  }
}
