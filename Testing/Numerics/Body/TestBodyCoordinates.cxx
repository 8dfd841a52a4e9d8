#include "Body/BodyCoordinates.h"

#include "Mesh/MeshTopology.h"
#include "Runs.h"
#include "Search/TriangleTree.h"
#include "Sphere/MoebiusTransform.h"
#include "Sphere/SphereOrientation.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using conformal::BodyCoordinates;
using conformal::BodyCoordinatesOptions;
using conformal::findBodyCoordinates;
using conformal::Index;
using conformal::MappedMesh;
using conformal::Pi;
using conformal::placeOnBody;
using conformal::Points;
using conformal::toDirection;
using conformal::toLongitudeLatitude;
using conformal::Vector2;
using conformal::Vector3;

namespace
{
// Two lobes and a neck between them, mapped somehow.
MappedMesh twoLobes(int frequency = 30)
{
  MappedMesh body = spheres::mapped(frequency);
  for (Index v = 0; v < body.Positions.rows(); ++v)
  {
    const Vector3 n = body.Positions.row(v);
    const double neck = 1.0 - 0.6 * std::exp(-8.0 * n[0] * n[0]);
    body.Positions.row(v) = neck * n.cwiseProduct(Vector3(1.8 + 0.4 * n[0], 1.1, 1.0 + 0.1 * n[1]));
  }
  conformal::MoebiusTransform transform;
  transform.Center = { 0.2, -0.3, 0.1 };
  transform.Rotation = Eigen::AngleAxisd(1.0, Vector3(3, 1, 2).normalized()).toRotationMatrix();
  transform.applyTo(body.SpherePositions);
  return body;
}

MappedMesh withCoordinates(const MappedMesh& body, const BodyCoordinatesOptions& options = {})
{
  MappedMesh result = body;
  result.SpherePositions = findBodyCoordinates(body, options).SpherePositions;
  return result;
}

// Mean of the sine of the latitude over the area of the body.
double meanHeight(const MappedMesh& body, const Points& map)
{
  double sum = 0.0, area = 0.0;
  for (Index r = 0; r < body.Triangles.rows(); ++r)
  {
    const double own = conformal::areaVector(body.Positions, body.Triangles, r).norm();
    area += own;
    for (int k = 0; k < 3; ++k)
    {
      sum += own / 3.0 * map(body.Triangles(r, k), 2);
    }
  }
  return sum / area;
}

Points directions(const std::vector<Vector2>& degrees)
{
  Points n(static_cast<Index>(degrees.size()), 3);
  for (std::size_t i = 0; i < degrees.size(); ++i)
  {
    n.row(static_cast<Index>(i)) = toDirection(degrees[i]);
  }
  return n;
}
}

TEST(BodyCoordinates, GoFromDegreesToDirectionsAndBack)
{
  const Points n = spheres::random(10000);
  for (Index i = 0; i < n.rows(); ++i)
  {
    const Vector2 degrees = toLongitudeLatitude(n.row(i));
    EXPECT_GE(degrees[0], 0.0);
    EXPECT_LT(degrees[0], 360.0);
    EXPECT_LT((toDirection(degrees) - n.row(i).transpose()).norm(), 1e-14);
  }
  EXPECT_EQ(toLongitudeLatitude({ 1.0, -1e-300, 0.0 })[0], 0.0);
  EXPECT_EQ(toLongitudeLatitude({ 0, 0, 1 })[1], 90.0);
}

// Poles, marker and balance: what the coordinates promise, found again from them alone.
TEST(BodyCoordinates, PutPolesAndMarkerWhereTheyBelong)
{
  const MappedMesh body = twoLobes();
  BodyCoordinatesOptions options;
  options.RotationAxis = { 0.3, 0.2, 2.0 };
  options.Center = { 0.3, 0.0, 0.05 };
  options.UseMarkerPoint = true;
  options.MarkerPoint = { -1.0, 1.0, 0.3 };
  const BodyCoordinates found = findBodyCoordinates(body, options);
  MappedMesh placed = body;
  placed.SpherePositions = found.SpherePositions;
  const Points poles = placeOnBody(placed, directions({ { 0, 90 }, { 0, -90 } }));
  EXPECT_LT((poles.row(0).transpose() - found.NorthPole).norm(), 1e-9);
  EXPECT_LT((poles.row(1).transpose() - found.SouthPole).norm(), 1e-9);
  // On the axis, to either side, with nothing beyond.
  const Vector3 axis = options.RotationAxis.normalized();
  for (const Vector3& pole : { found.NorthPole, found.SouthPole })
  {
    EXPECT_LT((pole - options.Center).cross(axis).norm(), 1e-12);
  }
  EXPECT_GT((found.NorthPole - options.Center).dot(axis), 0.0);
  EXPECT_LT((found.SouthPole - options.Center).dot(axis), 0.0);
  const conformal::TriangleTree tree(body.Positions, body.Triangles);
  EXPECT_LT((tree.closestPoint(options.MarkerPoint).Position - found.Marker).norm(), 1e-12);
  double closest = 1.0;
  std::vector<Vector2> meridian;
  for (double latitude = -90.0; latitude <= 90.0; latitude += 0.01)
  {
    meridian.emplace_back(0.0, latitude);
  }
  const Points line = placeOnBody(placed, directions(meridian));
  for (Index i = 0; i < line.rows(); ++i)
  {
    closest = std::min(closest, (line.row(i).transpose() - found.Marker).norm());
  }
  EXPECT_LT(closest, 1e-3);

  EXPECT_NEAR(meanHeight(body, found.SpherePositions), 0.0, 1e-12);
}

// Also where both poles lie opposite to each other from the beginning.
TEST(BodyCoordinates, BalanceNorthAndSouth)
{
  MappedMesh pear = spheres::mapped(20);
  pear.Positions.array().colwise() *= 1.0 + 0.5 * pear.SpherePositions.col(2).array();
  EXPECT_GT(meanHeight(pear, pear.SpherePositions), 0.1);
  const BodyCoordinates found = findBodyCoordinates(pear);
  EXPECT_NEAR(meanHeight(pear, found.SpherePositions), 0.0, 1e-12);
  EXPECT_NEAR(found.NorthPole[2], 1.5, 1e-12);
}

// On a sphere that is its own map they are the usual ones.
TEST(BodyCoordinates, AreTheUsualOnesOnASphere)
{
  const MappedMesh sphere = spheres::mapped(20);
  const BodyCoordinates found = findBodyCoordinates(sphere);
  EXPECT_LT((found.SpherePositions - sphere.Positions).norm(), 1e-10);
  // A mirrored map, and one seen from inside, say the same.
  MappedMesh mirrored = sphere;
  mirrored.SpherePositions.col(0) *= -1.0;
  EXPECT_LT((findBodyCoordinates(mirrored).SpherePositions - sphere.Positions).norm(), 1e-10);
  mirrored.Triangles.col(1).swap(mirrored.Triangles.col(2));
  EXPECT_LT((findBodyCoordinates(mirrored).SpherePositions - sphere.Positions).norm(), 1e-10);
}

// Only places change: angles are as before, so a conformal map stays one, and nothing flips.
TEST(BodyCoordinates, KeepAnglesOfTheMap)
{
  const MappedMesh body = twoLobes(60), placed = withCoordinates(body);
  EXPECT_EQ(conformal::countFlippedTriangles(placed.SpherePositions, placed.Triangles), 0);
  double worst = 0.0;
  for (Index r = 0; r < body.Triangles.rows(); ++r)
  {
    const auto angle = [&](const Points& p)
    {
      const Vector3 a = p.row(body.Triangles(r, 0)), b = p.row(body.Triangles(r, 1)),
                    c = p.row(body.Triangles(r, 2));
      return std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
    };
    worst = std::max(worst, std::abs(angle(placed.SpherePositions) - angle(body.SpherePositions)));
  }
  EXPECT_LT(worst, 0.05); // of finite triangles
}

TEST(BodyCoordinates, ComeBackToTheBody)
{
  const MappedMesh body = withCoordinates(twoLobes());
  Points n(body.Positions.rows(), 3);
  for (Index v = 0; v < n.rows(); ++v)
  {
    n.row(v) = toDirection(toLongitudeLatitude(body.SpherePositions.row(v)));
  }
  const Points back = placeOnBody(body, n);
  EXPECT_LT((back - body.Positions).rowwise().norm().maxCoeff(), 1e-9);
}

TEST(BodyCoordinates, DrawAGraticuleOnTheSurface)
{
  const MappedMesh body = withCoordinates(twoLobes());
  const auto lines = conformal::makeGraticule(body, 30.0);
  ASSERT_EQ(lines.size(), 12u + 5u);
  const conformal::TriangleTree tree(body.Positions, body.Triangles);
  for (const auto& line : lines)
  {
    ASSERT_GT(line.Positions.rows(), 50);
    for (Index i = 0; i < line.Positions.rows(); ++i)
    {
      EXPECT_LT(tree.closestPoint(line.Positions.row(i)).SquareDistance, 1e-24);
      EXPECT_TRUE(i == 0 || (line.Positions.row(i) - line.Positions.row(i - 1)).norm() < 0.025);
    }
    const auto ends = placeOnBody(body, directions({ { 0, -90 }, { 0, 90 } }));
    if (line.IsMeridian)
    {
      EXPECT_LT((line.Positions.row(0) - ends.row(0)).norm(), 1e-9);
      EXPECT_LT((line.Positions.bottomRows(1) - ends.row(1)).norm(), 1e-9);
    }
    else
    {
      EXPECT_LT((line.Positions.row(0) - line.Positions.bottomRows(1)).norm(), 1e-9);
    }
  }
  const auto fromBehind = conformal::makeGraticule(body, 30.0, runs::backwards());
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    EXPECT_TRUE(lines[i].Positions == fromBehind[i].Positions);
  }
  EXPECT_THROW(conformal::makeGraticule(body, 0.5), std::invalid_argument);
}

// A hole ends lines, and others begin behind it.
TEST(BodyCoordinates, GraticuleDoesNotCrossHoles)
{
  MappedMesh body = withCoordinates(twoLobes());
  Index kept = 0;
  for (Index r = 0; r < body.Triangles.rows(); ++r)
  {
    double x = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      x = std::max(x, body.SpherePositions(body.Triangles(r, k), 0));
    }
    if (x < 0.8)
    {
      body.Triangles.row(kept++) = body.Triangles.row(r);
    }
  }
  body.Triangles.conservativeResize(kept, 3);
  const auto lines = conformal::makeGraticule(body, 30.0);
  EXPECT_GT(lines.size(), 12u + 5u);
  for (const auto& line : lines)
  {
    ASSERT_GE(line.Positions.rows(), 2);
    for (Index i = 1; i < line.Positions.rows(); ++i)
    {
      EXPECT_LT((line.Positions.row(i) - line.Positions.row(i - 1)).norm(), 0.025);
    }
  }
}

TEST(BodyCoordinates, SayWhatIsWrong)
{
  const MappedMesh body = twoLobes(8);
  const auto refuses = [&](const BodyCoordinatesOptions& options)
  { EXPECT_THROW(findBodyCoordinates(body, options), std::invalid_argument); };
  BodyCoordinatesOptions options;
  options.RotationAxis.setZero();
  refuses(options);
  options.RotationAxis = { 0, 0, std::numeric_limits<double>::quiet_NaN() };
  refuses(options);
  options = {};
  options.Center = { 0, 0, 50 };
  refuses(options); // nothing to the north
  options = {};
  options.UseMarkerPoint = true;
  options.MarkerPoint = findBodyCoordinates(body).NorthPole;
  refuses(options);
  MappedMesh broken = body;
  broken.Positions(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(findBodyCoordinates(broken), std::invalid_argument);
  EXPECT_THROW(findBodyCoordinates(MappedMesh()), std::invalid_argument);
}
