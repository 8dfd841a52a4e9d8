#include "Measure/SurfaceShape.h"

#include "Linear/EdgeWeights.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

using conformal::Index;
using conformal::Mesh;
using conformal::Pi;
using conformal::SurfaceShape;
using conformal::SurfaceShapeOptions;
using conformal::Vector3;

namespace
{
Mesh sphere(int frequency)
{
  return conformal::makeGeodesicSphere(frequency);
}

double legendre(int degree, double x)
{
  double before = 1.0, value = x;
  for (int l = 1; l < degree; ++l)
  {
    before = std::exchange(value, ((2 * l + 1) * x * value - l * before) / (l + 1));
  }
  return value;
}

Mesh ellipsoid(int frequency, const Vector3& radii)
{
  Mesh mesh = sphere(frequency);
  mesh.Positions = (mesh.Positions * radii.asDiagonal()).eval();
  return mesh;
}

// A unit sphere pressed in around its north pole.
Mesh dimpled(int frequency, double depth, double width)
{
  Mesh mesh = sphere(frequency);
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const double angle = std::acos(std::clamp(mesh.Positions(v, 2), -1.0, 1.0)) / width;
    mesh.Positions.row(v) *= 1.0 - depth * std::exp(-0.5 * angle * angle);
  }
  return mesh;
}

Index north(const Mesh& mesh)
{
  Index v = 0;
  mesh.Positions.col(2).maxCoeff(&v);
  return v;
}

double largest(const Eigen::VectorXd& values)
{
  return values.cwiseAbs().maxCoeff();
}

// H and K of x^2/a^2 + y^2/b^2 + z^2/c^2 = 1 are known in closed form.
// Returns the largest relative errors.
std::pair<double, double> errors(const Mesh& mesh, const Vector3& radii, const SurfaceShape& shape)
{
  const Vector3 squares = radii.cwiseAbs2();
  double mean = 0.0, gaussian = 0.0;
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    const Vector3 p = mesh.Positions.row(v);
    const double height = 1.0 / p.cwiseQuotient(squares).norm(), product = squares.prod();
    const double h = std::pow(height, 3) * (squares.sum() - p.squaredNorm()) / (2.0 * product);
    const double k = std::pow(height, 4) / product;
    mean = std::max(mean, std::abs(shape.MeanCurvature[v] / h - 1.0));
    gaussian = std::max(gaussian, std::abs(shape.GaussianCurvature[v] / k - 1.0));
  }
  return { mean, gaussian };
}
}

// Of a polyhedron in a sphere the error is a matter of the edges' squares, at every vertex.
TEST(SurfaceShape, ASphereOfRadiusRHasTheCurvatures1ByRAndIsNowhereDeep)
{
  constexpr double radius = 2.5;
  for (const double scale : { 0.0, 0.01, 0.2 })
  {
    double before = 1.0;
    for (const int frequency : { 8, 16, 32 })
    {
      Mesh mesh = sphere(frequency);
      mesh.Positions *= radius;
      SurfaceShapeOptions options;
      options.CurvatureScale = scale;
      const SurfaceShape shape = conformal::measureSurfaceShape(mesh, options);
      const double mean = largest((radius * shape.MeanCurvature).array() - 1.0);
      const double gaussian = largest((radius * radius * shape.GaussianCurvature).array() - 1.0);
      EXPECT_LT(std::max(mean, gaussian), 0.3 * before) << frequency << " " << scale;
      EXPECT_LT(largest(shape.SulcalDepth) / radius, 0.3 * before);
      before = std::max(mean, gaussian);
    }
    EXPECT_LT(before, 1e-3);
  }
}

TEST(SurfaceShape, CurvaturesOfAnEllipsoidBecomeRightWithRefinement)
{
  const Vector3 radii(1.0, 0.8, 0.6);
  double meanBefore = 1.0, gaussianBefore = 1.0;
  for (const int frequency : { 12, 24, 48 })
  {
    const Mesh mesh = ellipsoid(frequency, radii);
    SurfaceShapeOptions options;
    options.CurvatureScale = 0.1 / std::sqrt(frequency); // smooths less, over more edges
    const SurfaceShape shape = conformal::measureSurfaceShape(mesh, options);
    const auto [mean, gaussian] = errors(mesh, radii, shape);
    EXPECT_LT(mean, 0.75 * meanBefore);
    EXPECT_LT(gaussian, 0.75 * gaussianBefore);
    meanBefore = mean;
    gaussianBefore = gaussian;
  }
  EXPECT_LT(meanBefore, 0.03);
  EXPECT_LT(gaussianBefore, 0.05);
}

// To first order, bumps e P_l on the unit sphere change H by e (l (l + 1) - 2) / 2 P_l and K by
// twice that. Smoothing over a length s divides both by 1 + s^2 l (l + 1); the depth potential is
// -e (l (l + 1) - 2) / (l (l + 1) + 1 / s^2) P_l.
TEST(SurfaceShape, BumpsOnASphereAreMeasuredAndSmoothedAsTheEquationsSay)
{
  const double root = std::sqrt(4.0 * Pi); // of the area
  for (const int degree : { 2, 3, 6 })
  {
    for (const double scale : { 0.05, 0.2 })
    {
      double before = 0.02;
      for (const int frequency : { 12, 24 })
      {
        Mesh mesh = sphere(frequency);
        const SurfaceShape flat = conformal::measureSurfaceShape(mesh, { scale, scale });
        constexpr double size = 1e-6;
        Eigen::VectorXd bumps(mesh.Positions.rows());
        for (Index v = 0; v < bumps.size(); ++v)
        {
          bumps[v] = legendre(degree, mesh.Positions(v, 2));
          mesh.Positions.row(v) *= 1.0 + size * bumps[v];
        }
        const SurfaceShape shape = conformal::measureSurfaceShape(mesh, { scale, scale });
        const double product = degree * (degree + 1.0);
        const double time = std::pow(scale * root, 2);
        const double mean = 0.5 * (product - 2.0) / (1.0 + time * product);
        const double depth = -(product - 2.0) / (product + 1.0 / time);
        const auto error = [&](
                             const Eigen::VectorXd& now, const Eigen::VectorXd& then, double known)
        { return largest((now - then) / size - known * bumps) / std::abs(known); };
        const double after = std::max({ error(shape.MeanCurvature, flat.MeanCurvature, mean),
          error(shape.GaussianCurvature, flat.GaussianCurvature, 2.0 * mean),
          error(shape.SulcalDepth, flat.SulcalDepth, depth) });
        EXPECT_LT(after, frequency == 12 ? before : 0.3 * before) << degree << " " << scale;
        before = after;
      }
    }
  }
}

TEST(SurfaceShape, TheBottomOfADimpleIsAboutAsDeepAsItWasMade)
{
  constexpr double depth = 0.02, width = 0.12;
  const Index bottom = north(sphere(32));
  const Mesh mesh = dimpled(32, depth, width);
  double before = 0.6;
  for (const double scale : { 0.05, 0.1, 0.2, 0.4 }) // the farther it looks, the better
  {
    const SurfaceShape shape = conformal::measureSurfaceShape(mesh, { 0.0, scale });
    Index deepest = 0, highest = 0;
    const double height =
      shape.SulcalDepth.maxCoeff(&deepest) - shape.SulcalDepth.minCoeff(&highest);
    EXPECT_EQ(deepest, bottom);
    EXPECT_GT(height / depth, before);
    EXPECT_LT(height / depth, 1.0);
    before = height / depth;
    // A ridge as high is as deep the other way.
    const SurfaceShape ridge =
      conformal::measureSurfaceShape(dimpled(32, -depth, width), { 0.0, scale });
    EXPECT_NEAR(ridge.SulcalDepth[bottom], -shape.SulcalDepth[bottom], 0.1 * depth);
    EXPECT_LT(shape.MeanCurvature[bottom], 0.0);
    EXPECT_GT(ridge.MeanCurvature[bottom], 2.0);
    EXPECT_GT(shape.GaussianCurvature[bottom], 0.0); // a pit
  }
  EXPECT_GT(before, 0.95);
}

// Theorems of Gauss and Bonnet, and of Green: whatever the mesh, the scale and the noise.
TEST(SurfaceShape, TotalsAreKeptExactly)
{
  Mesh mesh = ellipsoid(12, { 3.0, 1.0, 0.5 });
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    mesh.Positions.row(v) *= 1.0 + 0.1 * std::sin(37.0 * static_cast<double>(v));
  }
  const Eigen::VectorXd areas = conformal::nearestAreas(mesh);
  const Eigen::VectorXd corners = conformal::vertexAreas(mesh.Positions, mesh.Triangles);
  EXPECT_NEAR(areas.sum(), corners.sum() / 6.0, 1e-12 * areas.sum());
  EXPECT_GT(areas.minCoeff(), 0.0);
  EXPECT_NEAR(conformal::gaussianCurvatureIntegrals(mesh).sum(), 4.0 * Pi, 1e-10);
  const double mean = conformal::meanCurvatureIntegrals(mesh).sum();
  for (const double scale : { 0.0, 0.01, 1.0 })
  {
    SurfaceShapeOptions options;
    options.CurvatureScale = scale;
    const SurfaceShape shape = conformal::measureSurfaceShape(mesh, options);
    EXPECT_NEAR(areas.dot(shape.GaussianCurvature), 4.0 * Pi, 1e-9);
    EXPECT_NEAR(areas.dot(shape.MeanCurvature), mean, 1e-9 * mean);
    EXPECT_NEAR(areas.dot(shape.SulcalDepth), 0.0, 1e-9);
  }
}

TEST(SurfaceShape, MovingChangesNothingAndSizesAreLengths)
{
  Mesh mesh = dimpled(16, 0.2, 0.3);
  const SurfaceShape shape = conformal::measureSurfaceShape(mesh);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  mesh.Positions = (4.0 * mesh.Positions * turn.transpose()).eval();
  mesh.Positions.rowwise() += Eigen::RowVector3d(5.0, -6.0, 7.0);
  const SurfaceShape moved = conformal::measureSurfaceShape(mesh);
  EXPECT_LT(largest(4.0 * moved.MeanCurvature - shape.MeanCurvature), 1e-10);
  EXPECT_LT(largest(16.0 * moved.GaussianCurvature - shape.GaussianCurvature), 1e-10);
  EXPECT_LT(largest(moved.SulcalDepth / 4.0 - shape.SulcalDepth), 1e-10);
}

TEST(SurfaceShape, ResultsHaveTheSameBitsOnAnyNumberOfThreads)
{
  const Mesh mesh = dimpled(32, 0.2, 0.3);
  const SurfaceShape forwards = conformal::measureSurfaceShape(mesh);
  const SurfaceShape backwards = conformal::measureSurfaceShape(mesh, {}, runs::backwards());
  EXPECT_EQ(forwards.MeanCurvature, backwards.MeanCurvature);
  EXPECT_EQ(forwards.GaussianCurvature, backwards.GaussianCurvature);
  EXPECT_EQ(forwards.SulcalDepth, backwards.SulcalDepth);
}

TEST(SurfaceShape, TrianglesWithoutAreaDoNoHarm)
{
  Mesh mesh = sphere(6);
  const Index moved = mesh.Triangles(0, 1);
  mesh.Positions.row(moved) = mesh.Positions.row(mesh.Triangles(0, 0));
  for (const double scale : { 0.0, 0.05 })
  {
    SurfaceShapeOptions options;
    options.CurvatureScale = scale;
    const SurfaceShape shape = conformal::measureSurfaceShape(mesh, options);
    EXPECT_TRUE(shape.MeanCurvature.allFinite());
    EXPECT_TRUE(shape.GaussianCurvature.allFinite());
    EXPECT_TRUE(shape.SulcalDepth.allFinite());
  }
}

TEST(SurfaceShape, RefusesScalesOutOfRange)
{
  const Mesh mesh = sphere(4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double scale : { -0.1, 1.1, nan })
  {
    EXPECT_THROW(conformal::measureSurfaceShape(mesh, { scale, 0.1 }), std::invalid_argument);
    EXPECT_THROW(conformal::measureSurfaceShape(mesh, { 0.1, scale }), std::invalid_argument);
  }
  EXPECT_THROW(conformal::measureSurfaceShape(mesh, { 0.1, 0.0 }), std::invalid_argument);
}

TEST(SurfaceShape, RefusesASurfaceWithoutArea)
{
  Mesh mesh = sphere(4);
  mesh.Positions.setConstant(0.1);
  EXPECT_THROW(conformal::measureSurfaceShape(mesh, {}), std::invalid_argument);
}

TEST(SurfaceShape, StopsWhenAsked)
{
  for (const double fraction : { 0.0, 0.5 })
  {
    EXPECT_THROW(conformal::measureSurfaceShape(sphere(8), {}, runs::stoppingAt(fraction)),
      conformal::Aborted);
  }
}
