#include "TorusMap/ClosedForms.h"

#include "HandleMeshes.h"
#include "Tori.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cstdlib>
#include <stdexcept>

using conformal::integerForms;
using conformal::Mesh;
using conformal::next;
using conformal::SideForms;
using conformal::sidesAcross;

namespace
{
Mesh torus()
{
  return tori::gridTorus(9, 7, [](double s, double t) { return tori::onRevolution(0.5, s, t); });
}

// Sum the forms along the edges of a closed path of vertices.
Eigen::RowVector2i sumAlong(const Mesh& mesh, const SideForms& forms, const std::vector<int>& path)
{
  Eigen::RowVector2i sum = Eigen::RowVector2i::Zero();
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const int from = path[i], to = path[(i + 1) % path.size()];
    for (int side = 0; side < forms.rows(); ++side)
    {
      if (mesh.Triangles(side / 3, side % 3) == from &&
        mesh.Triangles(side / 3, next(side % 3)) == to)
      {
        sum += forms.row(side);
      }
    }
  }
  return sum;
}
}

TEST(ClosedForms, FindTheSideAcrossEachEdge)
{
  const Mesh mesh = torus();
  const std::vector<int> across = sidesAcross(mesh.Triangles, mesh.Positions.rows());
  for (int side = 0; side < static_cast<int>(across.size()); ++side)
  {
    const int other = across[side];
    EXPECT_EQ(across[other], side);
    EXPECT_EQ(mesh.Triangles(side / 3, side % 3), mesh.Triangles(other / 3, next(other % 3)));
    EXPECT_EQ(mesh.Triangles(side / 3, next(side % 3)), mesh.Triangles(other / 3, other % 3));
  }
}

// The sum is zero around each triangle. Of the two generators of the torus, sums are the rows of an
// integer matrix of determinant 1 or -1, so that the forms count all closed paths.
TEST(ClosedForms, CountPathsAroundTheTorus)
{
  const Mesh mesh = torus();
  const std::vector<int> across = sidesAcross(mesh.Triangles, mesh.Positions.rows());
  const SideForms forms = integerForms(mesh.Triangles, mesh.Positions.rows(), across);
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    EXPECT_TRUE(forms.middleRows(3 * t, 3).colwise().sum().isZero());
  }
  for (int side = 0; side < forms.rows(); ++side)
  {
    EXPECT_EQ(forms.row(side), -forms.row(across[side]));
  }
  std::vector<int> along, around;
  for (int i = 0; i < 9; ++i)
  {
    along.push_back(7 * i + 2);
  }
  for (int j = 0; j < 7; ++j)
  {
    around.push_back(7 * 4 + j);
  }
  Eigen::Matrix2i sums;
  sums << sumAlong(mesh, forms, along), sumAlong(mesh, forms, around);
  EXPECT_EQ(std::abs(sums.determinant()), 1);
}

TEST(ClosedForms, RejectOtherGenera)
{
  for (const Mesh& mesh : { conformal::makeGeodesicSphere(4), handles::sphereWithHandles(2, 20) })
  {
    const std::vector<int> across = sidesAcross(mesh.Triangles, mesh.Positions.rows());
    EXPECT_THROW(
      integerForms(mesh.Triangles, mesh.Positions.rows(), across), std::invalid_argument);
  }
}
