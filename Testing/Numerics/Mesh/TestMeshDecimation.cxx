#include "Mesh/MeshDecimation.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Search/TriangleTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::DecimatedMesh;
using conformal::Index;
using conformal::Points;

namespace
{
conformal::Mesh bumpySphere(int frequency)
{
  conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency);
  for (Index i = 0; i < sphere.Positions.rows(); ++i)
  {
    sphere.Positions.row(i) *= 1.0 + 0.2 * std::sin(4.0 * sphere.Positions(i, 0));
  }
  return sphere;
}
}

TEST(MeshDecimation, StaysClosedOfGenusZeroAndNearTheSurface)
{
  const auto sphere = bumpySphere(20);
  const conformal::TriangleTree original(sphere.Positions, sphere.Triangles);
  for (Index size : { 4, 50, 700, 3000 })
  {
    const DecimatedMesh mesh = conformal::decimate(sphere, size);
    ASSERT_EQ(mesh.Positions.rows(), size);
    ASSERT_EQ(mesh.Triangles.rows(), 2 * size - 4);
    EXPECT_TRUE(conformal::checkGenusZero(mesh.Triangles, size).isGenusZero());
    EXPECT_GT(conformal::signedVolume(mesh.Positions, mesh.Triangles), 0.0);
    double farthest = 0.0;
    for (Index r = 0; r < mesh.Triangles.rows(); ++r)
    {
      const conformal::Vector3 center =
        (mesh.Positions.row(mesh.Triangles(r, 0)) + mesh.Positions.row(mesh.Triangles(r, 1)) +
          mesh.Positions.row(mesh.Triangles(r, 2))) /
        3.0;
      farthest = std::max(farthest, original.closestPoint(center).SquareDistance);
    }
    // The sagitta of triangles falls as their area does.
    EXPECT_LT(std::sqrt(farthest), 9.0 / static_cast<double>(size)) << size;
  }
}

TEST(MeshDecimation, KeepsSomeOfThePointsInTheirOrder)
{
  const auto sphere = bumpySphere(8);
  const DecimatedMesh mesh = conformal::decimate(sphere, 100);
  for (Index i = 0; i < 100; ++i)
  {
    EXPECT_EQ(mesh.Positions.row(i), sphere.Positions.row(mesh.PointIds[i]));
    EXPECT_TRUE(i == 0 || mesh.PointIds[i - 1] < mesh.PointIds[i]);
  }
}

TEST(MeshDecimation, DoesNothingWhereThereIsNothingToDo)
{
  const auto sphere = bumpySphere(3);
  const DecimatedMesh mesh = conformal::decimate(sphere, 92);
  EXPECT_EQ(mesh.Positions, sphere.Positions);
  EXPECT_EQ(mesh.Triangles.rows(), sphere.Triangles.rows());
}

TEST(MeshDecimation, RefusesSurfacesThatAreNotOfGenusZero)
{
  auto open = bumpySphere(3);
  open.Triangles.conservativeResize(open.Triangles.rows() - 1, 3);
  EXPECT_THROW(conformal::decimate(open, 50), std::invalid_argument);
}

TEST(MeshDecimation, StopsWhenToldTo)
{
  const auto sphere = bumpySphere(20);
  EXPECT_THROW(conformal::decimate(sphere, 50, runs::stoppingAt(0.0)), conformal::Aborted);
}
