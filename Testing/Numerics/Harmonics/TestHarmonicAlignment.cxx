#include "Harmonics/HarmonicAlignment.h"

#include "Harmonics/HarmonicFit.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Shapes.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Columns;
using conformal::HarmonicAlignment;
using conformal::harmonicIndex;
using conformal::Index;
using conformal::numberOfHarmonics;
using conformal::Points;
using conformal::Vector3;
using Eigen::Matrix3d;

namespace
{
/// Coefficients of a surface without symmetry, with axes of these lengths.
Columns shape(const Vector3& lengths, int degree = 8)
{
  Columns coefficients(numberOfHarmonics(degree), 3);
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      for (int c = 0; c < 3; ++c)
      {
        coefficients(harmonicIndex(l, m), c) =
          0.3 * std::sin(1.0 + 3.7 * l + 1.3 * m * m + 2.1 * m + 5.0 * c) / (l + 1.0);
      }
    }
  }
  coefficients.middleRows(1, 3).setZero();
  coefficients(harmonicIndex(1, 1), 0) = lengths[0];
  coefficients(harmonicIndex(1, -1), 1) = lengths[1];
  coefficients(harmonicIndex(1, 0), 2) = lengths[2];
  return coefficients;
}

Matrix3d turned(double angle, const Vector3& axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// The surface and its map, turned and moved.
Columns moved(const Columns& coefficients, const Matrix3d& map, const Matrix3d& surface)
{
  Columns result = conformal::rotateHarmonics(coefficients, map) * surface.transpose();
  result.row(0) += Eigen::RowVector3d(5.0, -2.0, 1.0);
  return result;
}

Columns aligned(const Columns& coefficients, const HarmonicAlignment& alignment)
{
  Columns centered = coefficients;
  centered.row(0) -= std::sqrt(4.0 * conformal::Pi) * alignment.Center.transpose();
  return conformal::rotateHarmonics(centered, alignment.MapRotation) *
    alignment.SurfaceRotation.transpose();
}

double difference(const Columns& a, const Columns& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}

const Matrix3d MapTurn = turned(1.1, { 1.0, 2.0, -0.4 });
const Matrix3d SurfaceTurn = turned(-2.3, { -0.3, 0.2, 1.0 });
}

TEST(HarmonicAlignment, RotatedFunctionsHaveTheirValuesElsewhere)
{
  const Columns coefficients = shape({ 3.0, 2.0, 1.0 });
  const Points directions = spheres::random(100), there = directions * MapTurn.transpose();
  const Columns rotated = conformal::rotateHarmonics(coefficients, MapTurn);
  EXPECT_LT(difference(conformal::evaluateHarmonics(rotated, there),
              conformal::evaluateHarmonics(coefficients, directions)),
    1e-13);
}

TEST(HarmonicAlignment, PowerOfEachDegreeDoesNotDependOnRotations)
{
  const Columns coefficients = shape({ 3.0, 2.0, 1.0 }, 40);
  const Columns other = conformal::rotateHarmonics(coefficients, MapTurn) * SurfaceTurn.transpose();
  EXPECT_LT((conformal::powerPerDegree(coefficients) - conformal::powerPerDegree(other))
              .cwiseAbs()
              .maxCoeff(),
    1e-12);
}

TEST(HarmonicAlignment, EllipsoidLiesAlongTheAxes)
{
  const Columns start = moved(shape({ 3.0, 2.0, 1.0 }), MapTurn, SurfaceTurn);
  const Columns result = aligned(start, conformal::alignToEllipsoid(start));
  EXPECT_LT(result.row(0).cwiseAbs().maxCoeff(), 1e-13);
  Columns first = Columns::Zero(3, 3);
  first(2, 0) = 3.0;
  first(0, 1) = 2.0;
  first(1, 2) = 1.0;
  EXPECT_LT(difference(result.middleRows(1, 3), first), 1e-13);
}

TEST(HarmonicAlignment, TheSameSurfaceTurnedIsAlignedTheSame)
{
  const Columns one = shape({ 3.0, 2.0, 1.0 });
  const Columns expected = aligned(one, conformal::alignToEllipsoid(one));
  for (const double angle : { 0.5, 2.0, 3.1 })
  {
    const Columns other =
      moved(one, turned(angle, { 0.2, 1.0, 0.4 }), turned(2.0 * angle, { 1.0, 0.1, 0.4 }));
    EXPECT_LT(difference(aligned(other, conformal::alignToEllipsoid(other)), expected), 1e-12);
  }
}

// An ellipsoid with two limbs, the longer one to the right or to the left. Both limbs are at
// positive ends.
TEST(HarmonicAlignment, EndsAreThoseThatExtendFarther)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(30);
  for (const double side : { 1.0, -1.0 })
  {
    conformal::MappedMesh mesh;
    mesh.Triangles = sphere.Triangles;
    mesh.SpherePositions = sphere.Positions;
    mesh.Positions = shapes::over(sphere.Positions,
      [=](const conformal::Vector3& n) -> conformal::Vector3
      {
        const double limb = std::exp((side * n[0] - 1.0) / 0.1);
        return { 2.0 * n[0] + side * 2.0 * limb, 1.3 * n[1] + 0.8 * std::exp((n[1] - 1.0) / 0.2),
          n[2] };
      });
    const Columns found = conformal::fitHarmonics(mesh, mesh.Positions, 16);
    const HarmonicAlignment alignment = conformal::alignToEllipsoid(found);
    EXPECT_GT(alignment.EndMargin, 0.1);
    EXPECT_LT(alignment.EndMargin, 4.0);
    EXPECT_GT((alignment.SurfaceRotation * conformal::Vector3(side, 0.0, 0.0))[0], 0.9);
    EXPECT_GT((alignment.SurfaceRotation * conformal::Vector3(0.0, 1.0, 0.0))[1], 0.9);
  }
}

// A plain ellipsoid has no ends that differ; and a mirrored one stays mirrored.
TEST(HarmonicAlignment, SymmetricAndMirroredSurfacesHaveProperRotations)
{
  Columns plain = Columns::Zero(4, 3);
  plain.bottomRows(3) = shape({ 3.0, 2.0, 1.0 }).middleRows(1, 3);
  for (const double sign : { 1.0, -1.0 })
  {
    Columns start = plain;
    start.col(1) *= sign;
    const HarmonicAlignment alignment = conformal::alignToEllipsoid(start);
    EXPECT_LT(alignment.EndMargin, 1e-3);
    EXPECT_NEAR(alignment.MapRotation.determinant(), 1.0, 1e-14);
    EXPECT_NEAR(alignment.SurfaceRotation.determinant(), 1.0, 1e-14);
    const Columns result = aligned(start, alignment);
    EXPECT_NEAR(result(3, 0), 3.0, 1e-13);
    EXPECT_NEAR(result(1, 1), 2.0, 1e-13);
    EXPECT_NEAR(result(2, 2), sign, 1e-13);
  }
}

TEST(HarmonicAlignment, ReferenceDecidesBetweenTheEndsOfAxes)
{
  const Columns one = shape({ 3.0, 2.0, 1.0 });
  const Columns other = moved(one, turned(3.0, { 0.1, 0.3, 1.0 }), SurfaceTurn);
  Columns reference = one;
  reference.row(0).setZero();
  EXPECT_LT(
    difference(aligned(other, conformal::alignToReference(other, reference, true)), reference),
    1e-12);
}

// Axes that are alike say nothing: the rest of the shape does.
TEST(HarmonicAlignment, ReferenceDecidesWhereAxesAreAlike)
{
  for (const Vector3& lengths :
    { Vector3(2.0, 2.0, 1.0), Vector3(2.0, 1.0, 1.0), Vector3(2.0, 2.0, 2.0) })
  {
    const Columns one = shape(lengths);
    const Columns other = moved(one, turned(2.2, { 0.1, 0.3, 1.0 }), SurfaceTurn);
    Columns reference = one;
    reference.row(0).setZero();
    EXPECT_LT(
      difference(aligned(other, conformal::alignToReference(other, reference, true)), reference),
      1e-4)
      << lengths.transpose();
  }
}

TEST(HarmonicAlignment, MapAloneIsTurnedWhereTheSurfaceStays)
{
  const Columns one = shape({ 3.0, 2.0, 1.0 });
  const Columns other = conformal::rotateHarmonics(one, MapTurn);
  const HarmonicAlignment alignment = conformal::alignToReference(other, one, false);
  EXPECT_EQ(alignment.SurfaceRotation, Matrix3d::Identity());
  EXPECT_EQ(alignment.Center, Vector3::Zero());
  EXPECT_LT(difference(aligned(other, alignment), one), 1e-12);
}

TEST(HarmonicAlignment, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const Columns one = shape({ 2.0, 2.0, 2.0 }), other = moved(one, MapTurn, SurfaceTurn);
  EXPECT_EQ(conformal::alignToReference(other, one, true).MapRotation,
    conformal::alignToReference(other, one, true, runs::backwards()).MapRotation);
  EXPECT_THROW(
    conformal::alignToReference(other, one, true, runs::stoppingAt(0.5)), conformal::Aborted);
}
