#include "Measure/SurfaceMismatch.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Search/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

using conformal::Index;
using conformal::measureSurfaceMismatch;
using conformal::MismatchUnit;
using conformal::Pi;
using conformal::Points;
using conformal::SurfaceMismatch;
using conformal::SurfaceMismatchOptions;
using conformal::Triangles;
using conformal::Vector3;

namespace
{
SurfaceMismatchOptions fewSamples()
{
  SurfaceMismatchOptions options;
  options.NumberOfSamples = 5000;
  return options;
}

SurfaceMismatchOptions inUnit(MismatchUnit unit)
{
  SurfaceMismatchOptions options;
  options.LengthUnit = unit;
  return options;
}

// The square [-1, 1]^2 at a height, of two triangles.
Points square(double z)
{
  Points points(4, 3);
  points << -1, -1, z, 1, -1, z, 1, 1, z, -1, 1, z;
  return points;
}

Triangles squareFaces()
{
  Triangles triangles(2, 3);
  triangles << 0, 1, 2, 0, 2, 3;
  return triangles;
}
}

// All distances between parallel squares, one above the other, are the same.
TEST(SurfaceMismatch, KnowsParallelSquares)
{
  const SurfaceMismatch figures = measureSurfaceMismatch(
    square(0.5), squareFaces(), square(0), squareFaces(), inUnit(MismatchUnit::None));
  EXPECT_DOUBLE_EQ(figures.LengthUnit, 1.0);
  EXPECT_DOUBLE_EQ(figures.MeanSquarePointToSurface, 0.25);
  EXPECT_DOUBLE_EQ(figures.MeanSquarePointToVertex, 0.25);
  EXPECT_NEAR(figures.MeanSquareSurfaceToPoint, 0.25, 1e-14);
  EXPECT_DOUBLE_EQ(figures.HausdorffDistance, 0.5);
  EXPECT_EQ(figures.WebFraction, 1.0);
  EXPECT_EQ(figures.ModelDistances, std::vector<double>(4, 0.5));
  EXPECT_EQ(figures.ReferenceDistances, std::vector<double>(4, 0.5));
}

TEST(SurfaceMismatch, AnglesAreThoseBetweenPlanes)
{
  const Triangles faces = squareFaces();
  Points tilted = square(3.0);
  tilted.col(2) += std::tan(Pi / 6.0) * tilted.col(0);
  const auto angleOf = [&](const Triangles& triangles) {
    return measureSurfaceMismatch(tilted, triangles, square(0), faces, inUnit(MismatchUnit::None));
  };
  EXPECT_TRUE(angleOf(faces).HasNormalAngle);
  EXPECT_NEAR(angleOf(faces).RootMeanSquareNormalAngle, 30.0, 1e-10);
  Triangles reversed = faces;
  reversed.col(0).swap(reversed.col(1));
  EXPECT_NEAR(angleOf(reversed).RootMeanSquareNormalAngle, 30.0, 1e-10);
  const SurfaceMismatch toCloud = measureSurfaceMismatch(tilted, faces, square(0), {}, {});
  EXPECT_FALSE(toCloud.HasNormalAngle);
}

// The facets of a coarse sphere are inclined to those of a fine one as their size demands.
TEST(SurfaceMismatch, AnglesShrinkWithTheTriangles)
{
  const auto fine = conformal::makeGeodesicSphere(80);
  const auto angleOf = [&](int frequency)
  {
    const auto coarse = conformal::makeGeodesicSphere(frequency);
    return measureSurfaceMismatch(
      coarse.Positions, coarse.Triangles, fine.Positions, fine.Triangles, fewSamples())
      .RootMeanSquareNormalAngle;
  };
  EXPECT_NEAR(angleOf(5) / angleOf(10), 2.0, 0.1);
}

TEST(SurfaceMismatch, KnowsConcentricSpheres)
{
  const auto sphere = conformal::makeGeodesicSphere(20);
  const Points outer = 1.25 * sphere.Positions;
  const SurfaceMismatch figures = measureSurfaceMismatch(
    outer, sphere.Triangles, sphere.Positions, sphere.Triangles, fewSamples());
  EXPECT_NEAR(figures.LengthUnit, 1.0, 1e-12);
  EXPECT_NEAR(std::sqrt(figures.MeanSquarePointToSurface), 0.25, 1.6e-3); // facets lie inside
  EXPECT_NEAR(std::sqrt(figures.MeanSquarePointToVertex), 0.25, 1e-12);
  EXPECT_NEAR(std::sqrt(figures.MeanSquareSurfaceToPoint), 0.25, 2e-3);
  EXPECT_NEAR(figures.HausdorffDistance, 0.25, 2e-3);
}

// Divided by the unit, figures know no scale; distances of points keep the input's.
TEST(SurfaceMismatch, TakesItsUnitFromTheReference)
{
  const SurfaceMismatchOptions radius = inUnit(MismatchUnit::MaxRadius),
                               diagonal = inUnit(MismatchUnit::HalfDiagonal);
  Points reference = square(0);
  reference.row(0) << -2, -2, 0; // centroid (-1/4, -1/4), radius sqrt(2) 7/4, diagonal sqrt(2) 3
  const SurfaceMismatch a =
    measureSurfaceMismatch(square(0.5), squareFaces(), reference, squareFaces(), radius);
  EXPECT_DOUBLE_EQ(a.LengthUnit, std::sqrt(2.0) * 7 / 4);
  const SurfaceMismatch b =
    measureSurfaceMismatch(square(0.5), squareFaces(), reference, squareFaces(), diagonal);
  EXPECT_DOUBLE_EQ(b.LengthUnit, std::sqrt(2.0) * 3 / 2);
  EXPECT_NEAR(a.MeanSquarePointToSurface * a.LengthUnit * a.LengthUnit,
    b.MeanSquarePointToSurface * b.LengthUnit * b.LengthUnit, 1e-14);
  EXPECT_NEAR(a.ModelDistances[2], 0.5, 1e-15);

  const Points largeModel = 1024.0 * square(0.5), largeReference = 1024.0 * reference;
  const SurfaceMismatch c =
    measureSurfaceMismatch(largeModel, squareFaces(), largeReference, squareFaces(), radius);
  EXPECT_EQ(c.LengthUnit, 1024.0 * a.LengthUnit);
  EXPECT_EQ(c.MeanSquarePointToSurface, a.MeanSquarePointToSurface);
  EXPECT_EQ(c.MeanSquareSurfaceToPoint, a.MeanSquareSurfaceToPoint);
  EXPECT_EQ(c.ReferenceDistances[0], 1024.0 * a.ReferenceDistances[0]);
}

// A model that passes through all data and spans a gap between them.
TEST(SurfaceMismatch, SeesAWeb)
{
  Points model(8, 3);
  model << square(0), square(1);
  Triangles data(4, 3), triangles(6, 3);
  data << 0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7;
  triangles << data, 0, 1, 4, 1, 5, 4; // a wall of area 2 beside two squares of area 4
  const SurfaceMismatch figures =
    measureSurfaceMismatch(model, triangles, model, data, inUnit(MismatchUnit::None));
  EXPECT_EQ(figures.MeanSquarePointToSurface, 0.0);
  EXPECT_NEAR(figures.WebFraction, 0.2 * (1.0 - 2.0 * conformal::WebDistance), 1e-4);
  // On the wall the square distance is min(z, 1 - z)^2, in the mean 1/12.
  EXPECT_NEAR(figures.MeanSquareSurfaceToPoint, 0.2 / 12.0, 1e-5);
  EXPECT_NEAR(figures.HausdorffDistance, 0.5, 1e-3);
}

TEST(SurfaceMismatch, MeasuresToPointsWhereTheReferenceIsACloud)
{
  Points cloud(2, 3);
  cloud << 0, 0, 0, 10, 0, 0;
  const SurfaceMismatch figures = measureSurfaceMismatch(
    square(0.5), squareFaces(), cloud, Triangles(0, 3), inUnit(MismatchUnit::None));
  // The mean of x^2 + y^2 over the square is 2/3.
  EXPECT_NEAR(figures.MeanSquareSurfaceToPoint, 2.0 / 3.0 + 0.25, 2e-3);
  EXPECT_DOUBLE_EQ(figures.ModelDistances[0], 1.5);
  EXPECT_DOUBLE_EQ(figures.MeanSquarePointToSurface, 0.5 * (0.25 + 81.25));
}

// Model points of no triangle are not of its surface; reference points of none are data.
TEST(SurfaceMismatch, CountsIsolatedPointsOnOneSideOnly)
{
  Points points(5, 3);
  points << square(0), 0, 0, 2;
  const SurfaceMismatch asModel = measureSurfaceMismatch(
    points, squareFaces(), square(0), squareFaces(), inUnit(MismatchUnit::None));
  EXPECT_EQ(asModel.MeanSquarePointToVertex, 0.0);
  EXPECT_LT(asModel.HausdorffDistance, 1e-7);
  EXPECT_DOUBLE_EQ(asModel.ModelDistances[4], 2.0);
  const SurfaceMismatch asReference = measureSurfaceMismatch(
    square(0), squareFaces(), points, squareFaces(), inUnit(MismatchUnit::None));
  EXPECT_DOUBLE_EQ(asReference.MeanSquarePointToSurface, 0.8);
  EXPECT_DOUBLE_EQ(asReference.HausdorffDistance, 2.0);
}

TEST(SurfaceMismatch, DoesNotDependOnThreads)
{
  const auto coarse = conformal::makeGeodesicSphere(6), fine = conformal::makeGeodesicSphere(20);
  const SurfaceMismatch one = measureSurfaceMismatch(
    coarse.Positions, coarse.Triangles, fine.Positions, fine.Triangles, fewSamples());
  const SurfaceMismatch two = measureSurfaceMismatch(coarse.Positions, coarse.Triangles,
    fine.Positions, fine.Triangles, fewSamples(), {}, runs::backwards());
  EXPECT_EQ(one.MeanSquarePointToSurface, two.MeanSquarePointToSurface);
  EXPECT_EQ(one.MeanSquareSurfaceToPoint, two.MeanSquareSurfaceToPoint);
  EXPECT_EQ(one.ModelDistances, two.ModelDistances);
}

TEST(SurfaceMismatch, SeedChangesTheSamplesOnly)
{
  const auto coarse = conformal::makeGeodesicSphere(3), fine = conformal::makeGeodesicSphere(10);
  SurfaceMismatchOptions options = fewSamples();
  const SurfaceMismatch one = measureSurfaceMismatch(
    coarse.Positions, coarse.Triangles, fine.Positions, fine.Triangles, options);
  options.RandomSeed = 2;
  const SurfaceMismatch two = measureSurfaceMismatch(
    coarse.Positions, coarse.Triangles, fine.Positions, fine.Triangles, options);
  EXPECT_NE(one.MeanSquareSurfaceToPoint, two.MeanSquareSurfaceToPoint);
  EXPECT_NEAR(one.MeanSquareSurfaceToPoint / two.MeanSquareSurfaceToPoint, 1.0, 2e-2);
  EXPECT_EQ(one.MeanSquarePointToSurface, two.MeanSquarePointToSurface);
}

TEST(SurfaceMismatch, MeasuresAModelWithoutArea)
{
  const Points needle = Points::Zero(4, 3);
  const SurfaceMismatch figures = measureSurfaceMismatch(
    needle, squareFaces(), square(0), squareFaces(), inUnit(MismatchUnit::None));
  EXPECT_DOUBLE_EQ(figures.MeanSquarePointToSurface, 2.0);
  EXPECT_EQ(figures.MeanSquareSurfaceToPoint, 0.0);
}

TEST(SurfaceMismatch, RefusesWhatCannotBeMeasured)
{
  const Points good = square(0), none(0, 3), spot = Points::Ones(3, 3);
  const Triangles triangles = squareFaces(), noFaces(0, 3);
  EXPECT_THROW(measureSurfaceMismatch(good, noFaces, good, triangles), std::invalid_argument);
  EXPECT_THROW(measureSurfaceMismatch(good, triangles, none, noFaces), std::invalid_argument);
  EXPECT_THROW(measureSurfaceMismatch(good, triangles, spot, noFaces), std::invalid_argument);
  Points bad = good;
  bad(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(measureSurfaceMismatch(bad, triangles, good, triangles), std::invalid_argument);
  EXPECT_THROW(measureSurfaceMismatch(good, triangles, bad, triangles), std::invalid_argument);
  SurfaceMismatchOptions options = inUnit(MismatchUnit::None);
  EXPECT_THROW(measureSurfaceMismatch(Points(1e200 * good), triangles, good, triangles, options),
    std::invalid_argument);
  options.NumberOfSamples = 0;
  EXPECT_THROW(
    measureSurfaceMismatch(good, triangles, good, triangles, options), std::invalid_argument);
}

TEST(SurfaceMismatch, ReportsProgressAndStops)
{
  const auto sphere = conformal::makeGeodesicSphere(8);
  runs::Watch watch;
  measureSurfaceMismatch(sphere.Positions, sphere.Triangles, sphere.Positions, sphere.Triangles,
    fewSamples(), {}, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_THROW(measureSurfaceMismatch(sphere.Positions, sphere.Triangles, sphere.Positions,
                 sphere.Triangles, {}, {}, runs::stoppingAt(0.0)),
    conformal::Aborted);
}
