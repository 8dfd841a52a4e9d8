#include "Sphere/LandmarkFlow.h"

#include "Mesh/GeodesicSphere.h"
#include "Sphere/SphereOrientation.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

using conformal::countFlippedTriangles;
using conformal::flowToLandmarks;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Points;
using conformal::Vector3;

namespace
{
Points rowsOf(const Points& points, const std::vector<int>& ids)
{
  Points rows(ids.size(), 3);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    rows.row(i) = points.row(ids[i]);
  }
  return rows;
}
}

TEST(LandmarkFlow, WithoutLandmarksNothingMoves)
{
  const auto sphere = makeGeodesicSphere(8);
  Points places = sphere.Positions;
  const auto result = flowToLandmarks(sphere.Triangles, {}, Points(0, 3), places);
  EXPECT_EQ(places, sphere.Positions);
  EXPECT_EQ(result.Error, 0.0);
  EXPECT_EQ(result.NumberOfUnmet, 0);
}

TEST(LandmarkFlow, LandmarksThatAreMetMoveNothing)
{
  const auto sphere = makeGeodesicSphere(8);
  Points places = sphere.Positions;
  flowToLandmarks(sphere.Triangles, { 3, 100 }, rowsOf(places, { 3, 100 }), places);
  EXPECT_EQ(places, sphere.Positions);
}

// Far, and close together: all are met, nothing folds, and the way back leads home.
TEST(LandmarkFlow, MeetsLandmarksWithoutFoldsAndReturns)
{
  const auto sphere = makeGeodesicSphere(20);
  const std::vector<int> ids = { 0, 3, 1000, 2000, 2001, 3500 };
  Points targets(6, 3);
  for (Index i = 0; i < 6; ++i)
  {
    const Vector3 place = sphere.Positions.row(ids[i]);
    const double angle = i < 3 ? 0.5 : 0.3;
    targets.row(i) = Eigen::AngleAxisd(angle, place.unitOrthogonal()) * place;
  }
  targets.row(4) =
    (targets.row(3) + (sphere.Positions.row(2001) - sphere.Positions.row(2000))).normalized();
  Points places = sphere.Positions;
  const auto result = flowToLandmarks(sphere.Triangles, ids, targets, places);
  EXPECT_LT(result.Error, 1e-9);
  EXPECT_EQ(result.NumberOfUnmet, 0);
  EXPECT_EQ(countFlippedTriangles(places, sphere.Triangles), 0);
  const Points home = rowsOf(sphere.Positions, ids);
  EXPECT_LT(flowToLandmarks(sphere.Triangles, ids, home, places).Error, 1e-9);
  EXPECT_EQ(countFlippedTriangles(places, sphere.Triangles), 0);
}

// Two landmarks that are to change places across a third one, closer than triangles: something is
// left, and nothing folds.
TEST(LandmarkFlow, LeavesWhatWouldFold)
{
  const auto sphere = makeGeodesicSphere(6);
  // A triangle that is to be mirrored.
  const std::vector<int> ids = { sphere.Triangles(50, 0), sphere.Triangles(50, 1),
    sphere.Triangles(50, 2) };
  Points targets = rowsOf(sphere.Positions, ids);
  targets.row(0).swap(targets.row(1));
  Points places = sphere.Positions;
  const auto result = flowToLandmarks(sphere.Triangles, ids, targets, places);
  EXPECT_GT(result.NumberOfUnmet, 0);
  EXPECT_GT(result.Error, 1e-3);
  EXPECT_EQ(countFlippedTriangles(places, sphere.Triangles), 0);
}
