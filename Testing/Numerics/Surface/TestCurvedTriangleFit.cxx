#include "Surface/CurvedTriangleFit.h"

#include "Mesh/GeodesicSphere.h"
#include "Mesh/VertexNormals.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

using conformal::CurvedTriangleFitOptions;
using conformal::CurvedTriangles;
using conformal::CurvedTriangleTree;
using conformal::fitCurvedTriangles;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
CurvedTriangles ball(int frequency, double radius)
{
  const Mesh sphere = makeGeodesicSphere(frequency);
  return CurvedTriangles(radius * sphere.Positions, sphere.Positions, sphere.Triangles);
}

Points ellipsoid(int frequency)
{
  Points points = makeGeodesicSphere(frequency).Positions;
  points.col(0) *= 1.2;
  points.col(2) *= 0.8;
  return points;
}

double meanSquare(const CurvedTriangles& surface, const Points& cloud)
{
  const CurvedTriangleTree tree(surface);
  double sum = 0.0;
  for (Index i = 0; i < cloud.rows(); ++i)
  {
    sum += tree.closestPoint(cloud.row(i)).SquareDistance;
  }
  return sum / static_cast<double>(cloud.rows());
}
}

TEST(CurvedTriangleFit, DrawsABallToAnEllipsoid)
{
  const Points cloud = ellipsoid(40);
  const TrainingSamples samples{ PointView(cloud) };
  const CurvedTriangles start = ball(6, 1.0);
  const double before = meanSquare(start, cloud);
  double last = before;
  for (const int rounds : { 1, 2, 6 })
  {
    CurvedTriangleFitOptions options;
    options.NumberOfFitRounds = rounds;
    const double after = meanSquare(fitCurvedTriangles(start, samples, options), cloud);
    EXPECT_LT(after, last);
    last = after;
  }
  EXPECT_LT(last, 1e-5 * before);
}

TEST(CurvedTriangleFit, WithoutRoundsNothingMoves)
{
  const Points cloud = ellipsoid(10);
  const TrainingSamples samples{ PointView(cloud) };
  CurvedTriangleFitOptions options;
  options.NumberOfFitRounds = 0;
  const CurvedTriangles start = ball(4, 1.1), end = fitCurvedTriangles(start, samples, options);
  EXPECT_LT((start.positions() - end.positions()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_EQ(start.normals(), end.normals());
}

TEST(CurvedTriangleFit, LeavesTheMapAlone)
{
  // Vertices of a ball move along its radii.
  const Points cloud = 1.05 * makeGeodesicSphere(30).Positions;
  const TrainingSamples samples{ PointView(cloud) };
  const CurvedTriangles start = ball(5, 1.0), end = fitCurvedTriangles(start, samples);
  for (Index i = 0; i < start.positions().rows(); ++i)
  {
    const Vector3 n = start.positions().row(i), w = end.positions().row(i);
    EXPECT_NEAR(w.norm(), 1.05, 1e-3);
    EXPECT_LT(n.cross(w).norm(), 2e-3);
  }
}

TEST(CurvedTriangleFit, OutliersDoNotPull)
{
  const Points clean = ellipsoid(40);
  Points cloud = clean;
  for (Index i = 0; i < cloud.rows(); i += 200)
  {
    cloud.row(i) *= 1.4;
  }
  const CurvedTriangles start = ball(6, 1.0);
  const TrainingSamples samples{ PointView(cloud) };
  EXPECT_LT(meanSquare(fitCurvedTriangles(start, samples), clean), 1e-3 * meanSquare(start, clean));
}

TEST(CurvedTriangleFit, ThreadsChangeNothing)
{
  const Points cloud = ellipsoid(30);
  const TrainingSamples samples{ PointView(cloud) };
  const CurvedTriangles start = ball(5, 1.0);
  const CurvedTriangles alone = fitCurvedTriangles(start, samples),
                        together = fitCurvedTriangles(start, samples, {}, runs::backwards());
  EXPECT_EQ(alone.positions(), together.positions());
  EXPECT_EQ(alone.normals(), together.normals());
}

TEST(CurvedTriangleFit, RefusesOptionsOutOfRangeAndStopsWhenAsked)
{
  const Points cloud = ellipsoid(10);
  const TrainingSamples samples{ PointView(cloud) };
  const CurvedTriangles start = ball(3, 1.0);
  CurvedTriangleFitOptions options;
  options.NumberOfFitRounds = -1;
  EXPECT_THROW(fitCurvedTriangles(start, samples, options), std::invalid_argument);
  options.NumberOfFitRounds = 1;
  options.FitSmoothness = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fitCurvedTriangles(start, samples, options), std::invalid_argument);
  EXPECT_THROW(fitCurvedTriangles(start, samples, {}, runs::stoppingAt(0.5)), conformal::Aborted);
}
