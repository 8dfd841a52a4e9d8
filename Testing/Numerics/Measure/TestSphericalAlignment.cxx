#include "Measure/SphericalAlignment.h"

#include "Mesh/GeodesicSphere.h"
#include "SphereMap/GlobalConformalMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <stdexcept>

using conformal::AlignmentKind;
using conformal::alignSpheres;
using conformal::Index;
using conformal::Points;
using conformal::Vector3;

namespace
{
conformal::MoebiusTransform someTransform()
{
  conformal::MoebiusTransform transform;
  transform.Center = { 0.2, 0.3, -0.4 };
  transform.Rotation =
    Eigen::AngleAxisd(2.5, Vector3(-1.0, 2.0, 1.0).normalized()).toRotationMatrix();
  return transform;
}

// An egg as a mesh of any density.
conformal::Mesh egg(int frequency)
{
  auto mesh = conformal::makeGeodesicSphere(frequency);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const Vector3 n = mesh.Positions.row(v);
    mesh.Positions.row(v) << 0.9 * n[0], (1.0 + 0.2 * n[2]) * n[1], (1.4 + 0.2 * n[0]) * n[2];
  }
  return mesh;
}
}

// Three places say all about a Moebius transform.
TEST(SphericalAlignment, ThreePlacesFixAMoebiusTransform)
{
  const Points all = conformal::makeGeodesicSphere(3).Positions;
  Points moved = all;
  someTransform().applyTo(moved);
  const Points from = all.topRows(3), to = moved.topRows(3);
  const auto result = alignSpheres(from, to, Eigen::VectorXd::Ones(3), AlignmentKind::Moebius);
  EXPECT_LT(result.Error, 1e-6);
  Points found = all;
  result.Transform.applyTo(found);
  EXPECT_LT((found - moved).rowwise().norm().maxCoeff(), 1e-4);
}

TEST(SphericalAlignment, RotationLeavesWhatItCannotDo)
{
  const Points all = conformal::makeGeodesicSphere(3).Positions;
  Points moved = all;
  someTransform().applyTo(moved);
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(all.rows());
  const auto rotation = alignSpheres(all, moved, weights);
  const auto both = alignSpheres(all, moved, weights, AlignmentKind::Moebius);
  EXPECT_TRUE(rotation.Transform.Center.isZero());
  EXPECT_GT(rotation.Error, 0.1);
  EXPECT_LT(both.Error, 1e-7);
}

TEST(SphericalAlignment, RefusesTooFewPlaces)
{
  const Points two = conformal::makeGeodesicSphere(1).Positions.topRows(2);
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(2);
  EXPECT_NO_THROW(alignSpheres(two, two, weights));
  EXPECT_THROW(alignSpheres(two, two, weights, AlignmentKind::Moebius), std::invalid_argument);
}

// Copies of one pair, or antipodal points, determine no rotation; copies determine no Moebius
// transform.
TEST(SphericalAlignment, RefusesPairsThatAreNotDifferent)
{
  Points points(4, 3);
  points << 0.6, 0.8, 0.0, 0.6, 0.8, 0.0, -0.6, -0.8, 0.0, 0.0, 0.0, 1.0;
  const auto refuses = [&](std::initializer_list<int> rows, AlignmentKind kind)
  {
    Points some(static_cast<Index>(rows.size()), 3);
    Index i = 0;
    for (const int row : rows)
    {
      some.row(i++) = points.row(row);
    }
    EXPECT_THROW(
      alignSpheres(some, some, Eigen::VectorXd::Ones(some.rows()), kind), std::invalid_argument);
  };
  refuses({ 0, 1 }, AlignmentKind::Rotation);
  refuses({ 0, 2 }, AlignmentKind::Rotation);
  refuses({ 0, 1, 3 }, AlignmentKind::Moebius);
  refuses({ 0, 1, 2, 1 }, AlignmentKind::Moebius);
  EXPECT_NO_THROW(alignSpheres(points, points, Eigen::VectorXd::Ones(4)));
  EXPECT_NO_THROW(alignSpheres(points, points, Eigen::VectorXd::Ones(4), AlignmentKind::Moebius));
  EXPECT_THROW(alignSpheres(points, points, Eigen::VectorXd::Unit(4, 3)), std::invalid_argument);
}

// Two meshes of one object, mapped each on its own, the second one's map moved: conformal maps are
// unique but for what the alignment finds.
TEST(SphericalAlignment, MapsOfOneSurfaceAgree)
{
  const auto coarse = egg(20), fine = egg(31);
  const Points map = conformal::globalConformalMap(coarse).Positions;
  conformal::MappedMesh other = { fine.Positions, fine.Triangles,
    conformal::globalConformalMap(fine).Positions };
  someTransform().applyTo(other.SpherePositions);
  const Points carried = conformal::carryMap(coarse.Positions, other);
  const auto result =
    alignSpheres(map, carried, Eigen::VectorXd::Ones(map.rows()), AlignmentKind::Moebius);
  EXPECT_LT(result.Error, 0.005);
}
