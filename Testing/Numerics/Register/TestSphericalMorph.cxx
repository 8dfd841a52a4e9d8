#include "Register/SphericalMorph.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

using conformal::Index;
using conformal::Mesh;
using conformal::MorphPath;
using conformal::morphShapes;
using conformal::morphWeights;
using conformal::Points;
using conformal::rigidMean;
using conformal::Vector3;
using shapes::moved;

namespace
{
const Mesh& sphere()
{
  static const Mesh mesh = conformal::makeGeodesicSphere(16);
  return mesh;
}

/// A bent egg.
Points egg()
{
  return shapes::over(sphere().Positions,
    [](const Vector3& n)
    { return Vector3(3.0 * n[0] + 0.4 * n[1] * n[1], 2.0 * n[1], n[2] * (1.0 + 0.3 * n[0])); });
}

/// A bar along z that is bent by an angle in its middle, about x.
/// @param[in] width  half of the extent along x
Points bar(double angle, double width = 0.3)
{
  return shapes::over(sphere().Positions,
    [=](const Vector3& n) -> Vector3
    {
      const Vector3 straight(width * n[0], 0.3 * n[1], 4.0 * n[2]);
      const double share = 1.0 / (1.0 + std::exp(-12.0 * n[2]));
      return Eigen::AngleAxisd(share * angle, Vector3::UnitX()) * straight;
    });
}

Points between(const std::vector<Points>& shapes, double factor, MorphPath path)
{
  return morphShapes(sphere(), shapes, morphWeights(factor, shapes.size()), { path });
}

double largestDistance(const Points& a, const Points& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}

std::vector<double> edgeLengths(const Points& points)
{
  std::vector<double> lengths;
  for (Index r = 0; r < sphere().Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      lengths.push_back(
        (points.row(sphere().Triangles(r, k)) - points.row(sphere().Triangles(r, (k + 1) % 3)))
          .norm());
    }
  }
  return lengths;
}

/// Largest relative difference of the edges.
double stretch(const Points& a, const Points& b)
{
  const std::vector<double> ofA = edgeLengths(a), ofB = edgeLengths(b);
  double most = 0.0;
  for (std::size_t i = 0; i < ofA.size(); ++i)
  {
    most = std::max(most, std::abs(ofA[i] / ofB[i] - 1.0));
  }
  return most;
}

constexpr MorphPath Paths[] = { MorphPath::Linear, MorphPath::Rigid };
}

TEST(SphericalMorph, WeightsWalkThroughTheShapes)
{
  using Weights = std::vector<double>;
  EXPECT_EQ(morphWeights(0.0, 2), (Weights{ 1.0, 0.0 }));
  EXPECT_EQ(morphWeights(1.0, 2), (Weights{ 0.0, 1.0 }));
  EXPECT_EQ(morphWeights(0.25, 2), (Weights{ 0.75, 0.25 }));
  EXPECT_EQ(morphWeights(0.5, 3), (Weights{ 0.0, 1.0, 0.0 }));
  EXPECT_EQ(morphWeights(0.75, 3), (Weights{ 0.0, 0.5, 0.5 }));
  EXPECT_EQ(morphWeights(1.0, 3), (Weights{ 0.0, 0.0, 1.0 }));
  EXPECT_EQ(morphWeights(0.3, 1), (Weights{ 1.0 }));
}

TEST(SphericalMorph, AtTheEndsItIsTheShapes)
{
  const std::vector<Points> shapes = { egg(), bar(1.0), moved(egg(), 2.0, { 5.0, 0.0, 1.0 }) };
  for (const MorphPath path : Paths)
  {
    EXPECT_EQ(between(shapes, 0.0, path), shapes[0]);
    EXPECT_EQ(between(shapes, 0.5, path), shapes[1]);
    EXPECT_EQ(between(shapes, 1.0, path), shapes[2]);
    // And it comes close to them without a jump.
    const double scale = largestDistance(shapes[0], shapes[1]);
    EXPECT_LT(largestDistance(between(shapes, 1e-7, path), shapes[0]), 1e-5 * scale);
    EXPECT_LT(largestDistance(between(shapes, 0.5 - 1e-7, path), shapes[1]), 1e-5 * scale);
  }
}

// If the first shape and the second face the same way, positions are averaged.
TEST(SphericalMorph, LinearIsTheMean)
{
  const Points a = egg();
  const Points b = (1.5 * a).rowwise() + Eigen::RowVector3d(1.0, -2.0, 0.5);
  EXPECT_LT(largestDistance(between({ a, b }, 0.3, MorphPath::Linear), 0.7 * a + 0.3 * b), 1e-13);
}

// A copy that faces another way and is larger: all sizes in between are those of the copies.
TEST(SphericalMorph, LinearTurnsTheWholeShape)
{
  const Points a = egg(), b = moved(egg(), 2.5, { 4.0, 1.0, -3.0 }, 1.4);
  const Points half = between({ a, b }, 0.5, MorphPath::Linear);
  const Points expected = moved(egg(), 1.25, Vector3::Zero(), 1.2);
  const Vector3 offset = (half - expected).colwise().mean();
  EXPECT_LT(largestDistance(half.rowwise() - offset.transpose(), expected), 1e-12);
}

TEST(SphericalMorph, SwappedShapesMirror)
{
  const Points a = bar(0.0), b = moved(bar(2.0), 1.0, { 3.0, 1.0, 0.0 });
  for (const MorphPath path : Paths)
  {
    for (const double factor : { 0.1, 0.5, 0.8 })
    {
      EXPECT_LT(
        largestDistance(between({ a, b }, factor, path), between({ b, a }, 1.0 - factor, path)),
        1e-10);
    }
  }
}

TEST(SphericalMorph, ATurnedCopyStaysRigid)
{
  const Points a = egg();
  for (const double angle : { 0.5, 2.0, 3.1 })
  {
    const Points b = moved(a, angle, { 7.0, -2.0, 1.0 });
    for (const double factor : { 0.25, 0.5, 0.9 })
    {
      const Points rigid = between({ a, b }, factor, MorphPath::Rigid);
      EXPECT_LT(stretch(rigid, a), 1e-10);
    }
    EXPECT_LT(stretch(between({ a, b }, 0.5, MorphPath::Linear), a), 1e-10);
    // Half of the way it has turned by half of the angle.
    const Points half = between({ a, b }, 0.5, MorphPath::Rigid);
    const Points expected = moved(a, 0.5 * angle, Vector3::Zero());
    const Vector3 offset = (half - expected).colwise().mean();
    EXPECT_LT(largestDistance(half.rowwise() - offset.transpose(), expected), 1e-10);
  }
}

// Its ends turn, so they keep their size; by straight lines they come together.
TEST(SphericalMorph, ALimbTurnsAndKeepsItsLength)
{
  const Points a = bar(0.0), b = bar(2.4);
  const auto lengthOfEnds = [](const Points& points)
  {
    double sum = 0.0;
    for (Index r = 0; r < sphere().Triangles.rows(); ++r)
    {
      if (sphere().Positions(sphere().Triangles(r, 0), 2) > 0.6)
      {
        sum += conformal::areaVector(points, sphere().Triangles, r).norm();
      }
    }
    return sum;
  };
  const double whole = lengthOfEnds(a);
  EXPECT_NEAR(lengthOfEnds(b), whole, 0.01 * whole);
  const Points rigid = between({ a, b }, 0.5, MorphPath::Rigid),
               linear = between({ a, b }, 0.5, MorphPath::Linear);
  EXPECT_NEAR(lengthOfEnds(rigid), whole, 0.01 * whole);
  EXPECT_LT(lengthOfEnds(linear), 0.8 * whole);
  // It is about the bar that is bent by half as much.
  const Points expected = bar(1.2);
  Points turned = rigid;
  const Eigen::Matrix4d fit = Eigen::umeyama(
    Eigen::Matrix3Xd(rigid.transpose()), Eigen::Matrix3Xd(expected.transpose()), false);
  turned = (rigid * fit.topLeftCorner<3, 3>().transpose()).rowwise() +
    fit.topRightCorner<3, 1>().transpose();
  EXPECT_LT(largestDistance(turned, expected), 0.05 * 4.0);
}

// Two shapes that are stretched in different directions: the area of the mean is the mean area.
TEST(SphericalMorph, RigidKeepsTheMeanArea)
{
  const auto areaOf = [](const Points& points)
  {
    double sum = 0.0;
    for (Index r = 0; r < sphere().Triangles.rows(); ++r)
    {
      sum += conformal::areaVector(points, sphere().Triangles, r).norm();
    }
    return sum;
  };
  const Points a = egg(), b = bar(1.5), c = 2.0 * bar(-1.0);
  const Points mean = morphShapes(sphere(), { a, b, c }, { 0.5, 0.25, 0.25 }, { MorphPath::Rigid });
  const double expected = 0.5 * areaOf(a) + 0.25 * areaOf(b) + 0.25 * areaOf(c);
  EXPECT_NEAR(areaOf(mean), expected, 1e-10 * expected);
}

TEST(SphericalMorph, WeightsOfManyShapesAddUp)
{
  const Points a = egg(), b = 2.0 * egg(), c = egg().rowwise() + Eigen::RowVector3d(1.0, 0.0, 5.0);
  const std::vector<double> weights = { 0.2, 0.3, 0.5 };
  EXPECT_LT(
    largestDistance(morphShapes(sphere(), { a, b, c }, weights), 0.2 * a + 0.3 * b + 0.5 * c),
    1e-13);
  // Of equal shapes, however they are weighted, comes that shape.
  EXPECT_LT(
    largestDistance(morphShapes(sphere(), { a, a, a }, weights, { MorphPath::Rigid }), a), 1e-11);
  // Two turned copies of a shape and itself: a rotation by the weighted sum of their vectors.
  const Points twice =
    morphShapes(sphere(), { a, moved(a, 1.0, { 1.0, 0.0, 0.0 }), moved(a, 2.0, Vector3::Zero()) },
      { 0.2, 0.4, 0.4 }, { MorphPath::Rigid });
  EXPECT_LT(stretch(twice, a), 1e-10);
}

TEST(SphericalMorph, TrianglesWithoutAreaDoNotHarm)
{
  Points a = egg();
  a.row(sphere().Triangles(50, 0)) = a.row(sphere().Triangles(50, 1));
  a.row(sphere().Triangles(700, 0)) = a.row(sphere().Triangles(700, 2));
  const Points b = moved(a, 1.0, { 1.0, 0.0, 0.0 });
  const Points rigid = between({ a, b }, 0.5, MorphPath::Rigid);
  ASSERT_TRUE(rigid.allFinite());
  EXPECT_LT(
    largestDistance(rigid.rowwise() - rigid.colwise().mean(),
      (moved(a, 0.5, Vector3::Zero()).rowwise() - moved(a, 0.5, Vector3::Zero()).colwise().mean())),
    1e-9);
  const Points nothing = Points::Zero(a.rows(), 3);
  EXPECT_TRUE(between({ nothing, a }, 0.5, MorphPath::Rigid).allFinite());
  EXPECT_LT(largestDistance(between({ nothing, nothing }, 0.5, MorphPath::Rigid), nothing), 1e-14);
}

TEST(RigidMean, OfEqualShapesIsThisShape)
{
  const Points a = egg();
  EXPECT_EQ(rigidMean(sphere(), { a }), a);
  EXPECT_LT(largestDistance(rigidMean(sphere(), { a, a, a }), a), 1e-10);
}

TEST(RigidMean, OfMovedCopiesIsCongruent)
{
  const Points a = egg();
  const std::vector<Points> shapes = { a, moved(a, 1.0, { 7.0, -2.0, 1.0 }),
    moved(a, -0.7, { 0.0, 3.0, 1.0 }) };
  EXPECT_LT(stretch(rigidMean(sphere(), shapes), a), 1e-10);
}

// Plates that are bent to both sides: the mean is straight, and as long as they are.
TEST(RigidMean, OfOppositeBendsIsStraightInAnyOrder)
{
  // Narrow bars that are bent to opposite sides would be turned about their axis.
  constexpr double width = 3.0;
  const Points straight = bar(0.0, width);
  const std::vector<Points> shapes = { bar(1.2, width), bar(-1.2, width), bar(0.4, width),
    bar(-0.4, width) };
  const Points mean = rigidMean(sphere(), shapes);
  const auto heightOf = [](const Points& points) { return points.rowwise().norm().maxCoeff(); };
  const auto distanceBetween = [](const Points& from, const Points& to)
  {
    const Eigen::Matrix4d fit =
      Eigen::umeyama(Eigen::Matrix3Xd(from.transpose()), Eigen::Matrix3Xd(to.transpose()), false);
    const Points fitted = (from * fit.topLeftCorner<3, 3>().transpose()).rowwise() +
      fit.topRightCorner<3, 1>().transpose();
    return largestDistance(fitted, to);
  };
  EXPECT_LT(distanceBetween(mean, straight), 0.01 * heightOf(straight));
  const Points otherOrder = rigidMean(sphere(), { shapes[2], shapes[1], shapes[3], shapes[0] });
  EXPECT_LT(distanceBetween(otherOrder, mean), 1e-3 * heightOf(straight));
}

TEST(RigidMean, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const std::vector<Points> shapes = { egg(), bar(1.0), bar(0.3) };
  EXPECT_EQ(rigidMean(sphere(), shapes), rigidMean(sphere(), shapes, runs::backwards()));
  EXPECT_THROW(rigidMean(sphere(), shapes, runs::stoppingAt(0.2)), conformal::Aborted);
  runs::Watch watch;
  rigidMean(sphere(), shapes, watch.run());
  EXPECT_GT(watch.calls(), 5);
  EXPECT_THROW(rigidMean(sphere(), {}), std::invalid_argument);
}

TEST(SphericalMorph, BadWeightsAreRefused)
{
  const std::vector<Points> shapes = { egg(), egg() };
  for (const std::vector<double>& weights :
    { std::vector<double>{ 1.0 }, { 0.5, 0.6 }, { -0.5, 1.5 }, { NAN, 1.0 }, {} })
  {
    EXPECT_THROW(morphShapes(sphere(), shapes, weights), std::invalid_argument);
  }
  for (const double factor : { -0.1, 1.1, double(NAN) })
  {
    EXPECT_THROW(morphWeights(factor, 2), std::invalid_argument);
  }
}

TEST(SphericalMorph, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const std::vector<Points> shapes = { bar(0.0), bar(2.0) };
  const auto with = [&](const conformal::Run& run) {
    return morphShapes(sphere(), shapes, { 0.4, 0.6 }, { MorphPath::Rigid }, run);
  };
  EXPECT_EQ(with({}), with(runs::backwards()));
  EXPECT_THROW(with(runs::stoppingAt(0.6)), conformal::Aborted);
  runs::Watch watch;
  with(watch.run());
  EXPECT_GT(watch.calls(), 5);
}
