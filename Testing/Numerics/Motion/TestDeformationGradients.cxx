#include "Motion/DeformationGradients.h"

#include "Runs.h"
#include "Shapes.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using conformal::DeformationGradients;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
Mesh bentEgg()
{
  return spheres::shaped(6,
    [](const Vector3& n) -> Vector3 {
      return { 3.0 * n[0] + n[1] * n[1], 2.0 * n[1], n[2] };
    });
}
}

TEST(DeformationGradients, ASimilarityIsTheGradientOfAllTriangles)
{
  const Mesh mesh = bentEgg();
  const Eigen::Matrix3d wanted =
    1.7 * Eigen::AngleAxisd(2.0, Vector3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  Points pose = mesh.Positions * wanted.transpose();
  pose.rowwise() += Eigen::RowVector3d(5.0, -3.0, 1.0);
  for (const Eigen::Matrix3d& gradient : DeformationGradients(mesh).of(pose))
  {
    EXPECT_LT((gradient - wanted).norm(), 1e-12);
  }
}

TEST(DeformationGradients, MapsEdgesAndNormal)
{
  const Mesh mesh = bentEgg();
  const Points pose = shapes::over(mesh.Positions,
    [](const Vector3& p) -> Vector3 {
      return { p[0] + 0.3 * p[2] * p[2], p[1] * p[0], p[2] };
    });
  const std::vector<Eigen::Matrix3d> gradients = DeformationGradients(mesh).of(pose);
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    for (int k = 1; k < 3; ++k)
    {
      const int a = mesh.Triangles(r, 0), b = mesh.Triangles(r, k);
      const Vector3 before = mesh.Positions.row(b) - mesh.Positions.row(a);
      const Vector3 after = pose.row(b) - pose.row(a);
      EXPECT_LT((gradients[r] * before - after).norm(), 1e-12);
    }
    const Vector3 normal = conformal::areaVector(mesh.Positions, mesh.Triangles, r);
    const Vector3 wanted = conformal::areaVector(pose, mesh.Triangles, r);
    // Fourth vertices are at the distance of the square root of twice the area.
    EXPECT_LT((gradients[r] * normal / std::sqrt(normal.norm()) -
                wanted / std::sqrt(std::max(wanted.norm(), 1e-300)))
                .norm(),
      1e-12);
  }
}

TEST(DeformationGradients, ATriangleWithoutAreaHasTheGradientOfItsNeighbor)
{
  Mesh mesh;
  mesh.Positions.resize(6, 3);
  mesh.Positions << 0, 0, 0, 2, 0, 0, 1, 0, 0, 1, 1, 0, 1, -1, 0, 1, 0, 0;
  mesh.Triangles.resize(4, 3);
  mesh.Triangles << 0, 2, 3, 2, 1, 3, 0, 1, 2, 2, 1, 5; // the last two have no area
  Points pose = mesh.Positions;
  pose.col(1) *= 3.0;
  const auto gradients = DeformationGradients(mesh).of(pose);
  EXPECT_EQ(gradients[2], gradients[0]);
  EXPECT_TRUE(gradients[3].allFinite());
  mesh.Positions.col(1).setZero();
  EXPECT_THROW(DeformationGradients{ mesh }, std::invalid_argument);
}

TEST(DeformationGradients, ACollapsedPoseIsFinite)
{
  const Mesh mesh = bentEgg();
  const Points pose = Points::Zero(mesh.Positions.rows(), 3);
  for (const Eigen::Matrix3d& gradient : DeformationGradients(mesh).of(pose))
  {
    EXPECT_EQ(gradient, Eigen::Matrix3d::Zero());
  }
}

TEST(DeformationGradients, CanBeAbortedAndHaveTheSameBitsOnAllThreads)
{
  const Mesh mesh = bentEgg();
  const DeformationGradients gradients(mesh);
  EXPECT_EQ(gradients.of(mesh.Positions), gradients.of(mesh.Positions, runs::backwards()));
  EXPECT_THROW(gradients.of(mesh.Positions, runs::stoppingAt(0.5)), conformal::Aborted);
}
