#include "Harmonics/HarmonicFit.h"

#include "Harmonics/SphericalHarmonics.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Shapes.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::Columns;
using conformal::fitHarmonics;
using conformal::harmonicIndex;
using conformal::Index;
using conformal::MappedMesh;
using conformal::numberOfHarmonics;
using conformal::Points;
using conformal::Vector3;
using spheres::mapped;

namespace
{
/// An ellipsoid, somewhere; the map is that of the sphere that was stretched, moved along it.
MappedMesh ellipsoid(int frequency, double crowded = 0.0)
{
  MappedMesh mesh = mapped(frequency);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    Vector3 n = mesh.SpherePositions.row(i);
    n[0] += crowded * (1.0 - n[0] * n[0]);
    n.normalize();
    mesh.SpherePositions.row(i) = n;
    mesh.Positions.row(i) << 3.0 * n[0] + 1.0, 2.0 * n[1] - 5.0, n[2];
  }
  return mesh;
}

/// What they must be.
Columns ofEllipsoid(int degree)
{
  Columns exact = Columns::Zero(numberOfHarmonics(degree), 3);
  const double zero = std::sqrt(4.0 * conformal::Pi), one = std::sqrt(4.0 * conformal::Pi / 3.0);
  exact.row(0) << zero, -5.0 * zero, 0.0;
  exact(harmonicIndex(1, 1), 0) = 3.0 * one;
  exact(harmonicIndex(1, -1), 1) = 2.0 * one;
  exact(harmonicIndex(1, 0), 2) = one;
  return exact;
}

/// A function that no degree has.
double bump(const Vector3& p)
{
  return std::exp(2.0 * p[0] + p[1]);
}
}

TEST(HarmonicFit, CoefficientsOfAnEllipsoidAreExact)
{
  for (const double crowded : { 0.0, 0.5 })
  {
    for (const int degree : { 1, 8, 16 })
    {
      const MappedMesh mesh = ellipsoid(30, crowded);
      const Columns found = fitHarmonics(mesh, mesh.Positions, degree);
      EXPECT_LT((found - ofEllipsoid(degree)).cwiseAbs().maxCoeff(), 1e-12)
        << degree << " " << crowded;
    }
  }
}

TEST(HarmonicFit, KnownHarmonicsAreRecovered)
{
  const MappedMesh mesh = ellipsoid(30, 0.3);
  Columns known = Columns::Zero(numberOfHarmonics(12), 5);
  known(harmonicIndex(7, -3), 0) = 1.0;
  known(harmonicIndex(12, 12), 1) = -2.0;
  known(harmonicIndex(5, 0), 3) = 1e6; // columns of other sizes, and more of them than three
  known(harmonicIndex(2, 1), 4) = 1e-6;
  const Columns values = conformal::evaluateHarmonics(known, mesh.SpherePositions);
  const Columns found = fitHarmonics(mesh, values, 12);
  for (Index c = 0; c < known.cols(); ++c)
  {
    EXPECT_LE((found.col(c) - known.col(c)).cwiseAbs().maxCoeff(),
      1e-12 * known.col(c).cwiseAbs().maxCoeff())
      << c;
  }
}

TEST(HarmonicFit, ConstantValuesAreOfDegreeZero)
{
  const MappedMesh mesh = ellipsoid(10);
  const Columns found = fitHarmonics(mesh, Columns::Constant(mesh.Positions.rows(), 1, 7.0), 12);
  EXPECT_NEAR(found(0, 0), 7.0 * std::sqrt(4.0 * conformal::Pi), 1e-12);
  EXPECT_LT(found.bottomRows(found.rows() - 1).cwiseAbs().maxCoeff(), 1e-12);
}

// No other coefficients are closer to the values, area by area: the derivative is zero.
TEST(HarmonicFit, ResidualIsOrthogonalToAllHarmonics)
{
  const MappedMesh mesh = ellipsoid(24, 0.4);
  Columns values(mesh.Positions.rows(), 1);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(values.rows());
  for (Index i = 0; i < values.rows(); ++i)
  {
    values(i, 0) = bump(mesh.SpherePositions.row(i));
  }
  for (Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      areas[mesh.Triangles(t, k)] +=
        conformal::areaVector(mesh.Positions, mesh.Triangles, t).norm();
    }
  }
  const Columns found = fitHarmonics(mesh, values, 6);
  const Columns residual = areas.asDiagonal() *
    Columns(values - conformal::evaluateHarmonics(found, mesh.SpherePositions));
  EXPECT_GT(residual.cwiseAbs().sum(), 1e-4);
  EXPECT_LT(
    conformal::harmonicMoments(mesh.SpherePositions, residual, 6).cwiseAbs().maxCoeff(), 1e-11);
}

// 162 vertices cannot tell 1,089 functions apart: without places in between they would be free.
// What is linear in triangles with sides of 0.3 differs from the function by up to 0.5.
TEST(HarmonicFit, CoarseMeshesLeaveNothingFree)
{
  const MappedMesh coarse = mapped(4);
  Columns values(coarse.Positions.rows(), 1);
  for (Index i = 0; i < values.rows(); ++i)
  {
    values(i, 0) = bump(coarse.Positions.row(i));
  }
  const Columns found = fitHarmonics(coarse, values, 32);
  const Points between = conformal::makeGeodesicSphere(13).Positions;
  const Columns there = conformal::evaluateHarmonics(found, between);
  for (Index i = 0; i < between.rows(); ++i)
  {
    EXPECT_NEAR(there(i, 0), bump(between.row(i)), 0.5);
  }
}

// The power of each degree does not depend on the orientation of surface and map, though large
// triangles are sampled inside.
TEST(HarmonicFit, PowerDoesNotDependOnOrientation)
{
  for (const int frequency : { 4, 20 })
  {
    MappedMesh mesh = ellipsoid(frequency, 0.4);
    for (Index i = 0; i < mesh.Positions.rows(); ++i)
    {
      mesh.Positions.row(i) *= 1.0 + 0.2 * std::abs(bump(mesh.SpherePositions.row(i)) - 0.3) +
        0.2 * std::abs(mesh.SpherePositions(i, 0) + 0.4 * mesh.SpherePositions(i, 1));
    }
    const Eigen::VectorXd power = conformal::powerPerDegree(fitHarmonics(mesh, mesh.Positions, 16));
    EXPECT_GT(power.minCoeff(), 1e-14);
    for (const double angle : { 0.4, 1.7, 2.9 })
    {
      MappedMesh other = mesh;
      other.SpherePositions = shapes::moved(mesh.SpherePositions, angle, Vector3::Zero());
      other.Positions = shapes::moved(mesh.Positions, 2.0 - angle, Vector3::Zero());
      const Eigen::VectorXd found =
        conformal::powerPerDegree(fitHarmonics(other, other.Positions, 16));
      EXPECT_LT((found - power).tail(16).cwiseAbs().cwiseQuotient(power.tail(16)).maxCoeff(), 1e-10)
        << frequency << ", " << angle;
    }
  }
}

TEST(HarmonicFit, MirroredMapsAreFitted)
{
  MappedMesh mesh = ellipsoid(20);
  mesh.Triangles.col(0).swap(mesh.Triangles.col(1));
  const Columns found = fitHarmonics(mesh, mesh.Positions, 8);
  EXPECT_LT((found - ofEllipsoid(8)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(HarmonicFit, BadSurfacesAreRefused)
{
  MappedMesh folded = ellipsoid(10);
  folded.SpherePositions.row(500) *= -1.0;
  EXPECT_THROW(fitHarmonics(folded, folded.Positions, 4), std::invalid_argument);
  MappedMesh twice = ellipsoid(10);
  twice.SpherePositions.setZero();
  twice.SpherePositions.col(2).setOnes();
  EXPECT_THROW(fitHarmonics(twice, twice.Positions, 4), std::invalid_argument);
  MappedMesh open = ellipsoid(10);
  open.Triangles.conservativeResize(open.Triangles.rows() - 1, 3);
  EXPECT_THROW(fitHarmonics(open, open.Positions, 4), std::invalid_argument);
  MappedMesh point = mapped(10);
  point.Positions.setZero();
  EXPECT_THROW(fitHarmonics(point, point.SpherePositions, 4), std::invalid_argument);
}

TEST(HarmonicFit, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const MappedMesh mesh = ellipsoid(20, 0.4);
  const Columns one = fitHarmonics(mesh, mesh.Positions, 10);
  EXPECT_EQ(one, fitHarmonics(mesh, mesh.Positions, 10, runs::backwards()));
  EXPECT_THROW(fitHarmonics(mesh, mesh.Positions, 10, runs::stoppingAt(0.5)), conformal::Aborted);
  runs::Watch watch;
  fitHarmonics(mesh, mesh.Positions, 10, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
}
