#include "TriangleMap/NetworkShapes.h"

#include "Mesh/GeodesicSphere.h"

#include <boost/math/special_functions/beta.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <random>
#include <vector>

using conformal::HalfDiskPoint;
using conformal::Index;
using conformal::NetworkShapes;
using conformal::Points;
using conformal::Triangles;
using conformal::TriangleShape;
using conformal::Vector3;
using Complex = std::complex<double>;

namespace
{
const double Pi = std::acos(-1.0);
const double Degree = 1.0 / 180.0;

/// Vertices as complex numbers, angles in units of pi; the circumcircle's diameter is 1.
struct FlatTriangle
{
  std::array<Complex, 3> Corners;

  Complex at(const Vector3& barycentric) const
  {
    return barycentric[0] * this->Corners[0] + barycentric[1] * this->Corners[1] +
      barycentric[2] * this->Corners[2];
  }
  Vector3 barycentric(const Complex& z) const
  {
    const Complex u = this->Corners[1] - this->Corners[0], v = this->Corners[2] - this->Corners[0],
                  p = z - this->Corners[0];
    const double area = std::imag(std::conj(u) * v);
    const double second = std::imag(std::conj(p) * v) / area;
    const double third = std::imag(std::conj(u) * p) / area;
    return { 1.0 - second - third, second, third };
  }
  TriangleShape shape() const
  {
    const auto vertex = [&](int k)
    { return Vector3(this->Corners[k].real(), this->Corners[k].imag(), 0.0); };
    return TriangleShape(vertex(0), vertex(1), vertex(2));
  }
};

FlatTriangle fromAngles(double a, double b)
{
  return { { Complex(0.0), Complex(std::sin(Pi * (a + b))),
    std::polar(std::sin(Pi * b), Pi * a) } };
}

class RandomTriangles
{
public:
  double number() { return this->Uniform(this->Engine); }

  /// Angles of any size, but at least the smallest, half of the triangles near that.
  FlatTriangle triangle(double smallest)
  {
    for (;;)
    {
      const double a = this->angle(smallest), b = this->angle(smallest);
      if (a > smallest && b > smallest && 1.0 - a - b > smallest)
      {
        return fromAngles(a, b);
      }
    }
  }

  Vector3 inside()
  {
    double x = this->number(), y = this->number();
    if (x + y > 1.0)
    {
      x = 1.0 - x;
      y = 1.0 - y;
    }
    return { x, y, 1.0 - x - y };
  }

private:
  double angle(double smallest)
  {
    return this->number() < 0.5 ? this->number() : std::pow(smallest, this->number());
  }
  std::mt19937_64 Engine{ 1 };
  std::uniform_real_distribution<double> Uniform{ 0.0, 1.0 };
};

Vector3 mapBetween(const TriangleShape& from, const TriangleShape& to, const Vector3& barycentric)
{
  return to.fromHalfDisk(from.toHalfDisk(barycentric));
}

double distance(const Vector3& a, const Vector3& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}
}

TEST(SchwarzChristoffel, VerticesGoToVertices)
{
  RandomTriangles random;
  for (int i = 0; i < 200; ++i)
  {
    const TriangleShape from = random.triangle(Degree).shape(),
                        to = random.triangle(Degree).shape();
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(mapBetween(from, to, Vector3::Unit(k)), Vector3(Vector3::Unit(k)));
    }
  }
}

// With the corner opposite sent to infinity the map along an edge is the incomplete beta function.
TEST(SchwarzChristoffel, EdgesAgreeWithTheIncompleteBetaFunction)
{
  RandomTriangles random;
  for (int i = 0; i < 2000; ++i)
  {
    const TriangleShape from = random.triangle(Degree).shape(),
                        to = random.triangle(Degree).shape();
    const int k = i % 3, next = (k + 1) % 3;
    Vector3 barycentric = Vector3::Zero();
    barycentric[next] = 0.02 + 0.96 * random.number();
    barycentric[k] = 1.0 - barycentric[next];
    double rest = 0.0;
    const double x =
      boost::math::ibeta_inv(from.angles()[k], from.angles()[next], barycentric[next], &rest);
    const Vector3 mapped = mapBetween(from, to, barycentric);
    EXPECT_EQ(mapped[3 - k - next], 0.0);
    EXPECT_NEAR(mapped.sum(), 1.0, 1e-15);
    if (x > 1e-200 && rest > 1e-200) // beyond, Boost's inverse has fewer digits
    {
      const double expected = x < rest
        ? boost::math::ibeta(to.angles()[k], to.angles()[next], x)
        : boost::math::ibetac(to.angles()[next], to.angles()[k], rest);
      EXPECT_NEAR(mapped[next], expected, 2e-12)
        << from.angles()[k] << " " << from.angles()[next] << " " << x;
    }
  }
}

// Each corner has constants and a series of its own.
TEST(SchwarzChristoffel, TheThreeCornersAgreeAtTheirCommonPoint)
{
  RandomTriangles random;
  const Complex center(0.0, 2.0 - std::sqrt(3.0));
  for (int i = 0; i < 1000; ++i)
  {
    const FlatTriangle triangle = random.triangle(Degree);
    const TriangleShape shape = triangle.shape();
    std::array<Complex, 3> images;
    for (int k = 0; k < 3; ++k)
    {
      images[k] = triangle.at(shape.fromHalfDisk({ k, center, std::log(center) }));
    }
    EXPECT_LT(std::abs(images[1] - images[0]), 2e-15);
    EXPECT_LT(std::abs(images[2] - images[0]), 2e-15);
  }
}

TEST(SchwarzChristoffel, TheCenterOfAnEquilateralTriangleIsTheHalfDisks)
{
  const TriangleShape shape = fromAngles(1.0 / 3.0, 1.0 / 3.0).shape();
  const HalfDiskPoint point = shape.toHalfDisk(Vector3::Constant(1.0 / 3.0));
  EXPECT_LT(std::abs(point.S - Complex(0.0, 2.0 - std::sqrt(3.0))), 1e-15);
}

TEST(SchwarzChristoffel, GoesThereAndBack)
{
  RandomTriangles random;
  for (int i = 0; i < 50000; ++i)
  {
    const TriangleShape from = random.triangle(Degree).shape(),
                        to = random.triangle(Degree).shape();
    const Vector3 point = random.inside();
    const HalfDiskPoint between = from.toHalfDisk(point);
    ASSERT_LT(between.LogS.real(), std::log(0.34));
    ASSERT_LT(distance(from.fromHalfDisk(between), point), 2e-15);
    const Vector3 image = to.fromHalfDisk(between);
    ASSERT_GE(image.minCoeff(), 0.0);
    ASSERT_LT(distance(mapBetween(to, from, image), point), 1e-12);
  }
}

TEST(SchwarzChristoffel, SimilarTrianglesMapByIdentity)
{
  RandomTriangles random;
  for (int i = 0; i < 1000; ++i)
  {
    const FlatTriangle triangle = random.triangle(Degree);
    FlatTriangle similar;
    for (int k = 0; k < 3; ++k)
    {
      similar.Corners[k] = Complex(3.0, -2.0) * triangle.Corners[k] + Complex(0.1, 0.2);
    }
    const Vector3 point = random.inside();
    EXPECT_LT(distance(mapBetween(triangle.shape(), similar.shape(), point), point), 1e-12);
  }
}

TEST(SchwarzChristoffel, MirroredTrianglesMapToMirroredPoints)
{
  RandomTriangles random;
  const auto mirrored = [](FlatTriangle triangle)
  {
    std::swap(triangle.Corners[1], triangle.Corners[2]);
    return triangle;
  };
  for (int i = 0; i < 1000; ++i)
  {
    const FlatTriangle from = random.triangle(Degree), to = random.triangle(Degree);
    const Vector3 point = random.inside();
    const Vector3 image = mapBetween(from.shape(), to.shape(), point);
    const Vector3 mirror =
      mapBetween(mirrored(from).shape(), mirrored(to).shape(), { point[0], point[2], point[1] });
    EXPECT_LT(distance({ mirror[0], mirror[2], mirror[1] }, image), 1e-12);
  }
}

// Complex differences in two directions: the derivative's values, and Cauchy-Riemann.
TEST(SchwarzChristoffel, IsAnalyticWithTheDerivativeStated)
{
  RandomTriangles random;
  for (int i = 0; i < 2000; ++i)
  {
    const FlatTriangle from = random.triangle(10.0 * Degree), to = random.triangle(10.0 * Degree);
    const TriangleShape fromShape = from.shape(), toShape = to.shape();
    const Vector3 point = 0.1 * Vector3::Constant(1.0 / 3.0) + 0.9 * random.inside();
    const HalfDiskPoint between = fromShape.toHalfDisk(point);
    // Both derivatives are for the corner's edge on the real axis; turn to the planes of the test.
    const int k = between.Corner, next = (k + 1) % 3;
    const auto along = [&](const FlatTriangle& triangle)
    {
      const Complex edge = triangle.Corners[next] - triangle.Corners[k];
      return edge / std::abs(edge);
    };
    const Complex expected =
      toShape.derivative(between) / fromShape.derivative(between) * along(to) / along(from);

    const double step = 1e-5 * point.minCoeff();
    const Complex z = from.at(point);
    const auto difference = [&](const Complex& direction)
    {
      const auto image = [&](const Complex& at)
      { return to.at(mapBetween(fromShape, toShape, from.barycentric(at))); };
      return (image(z + step * direction) - image(z - step * direction)) / (2.0 * step * direction);
    };
    const Complex alongReal = difference(1.0), alongImaginary = difference(Complex(0.0, 1.0));
    const double tolerance = 1e-6 * std::abs(expected) + 1e-9; // 1e-9: rounding over the step
    EXPECT_LT(std::abs(alongReal - expected), tolerance);
    EXPECT_LT(std::abs(alongReal - alongImaginary), tolerance);
  }
}

TEST(SchwarzChristoffel, NeedlesAreMappedThereAndBack)
{
  RandomTriangles random;
  const TriangleShape network = fromAngles(0.31, 0.35).shape();
  for (const double height : { 1e-3, 1e-6, 1e-8 })
  {
    for (int i = 0; i < 5000; ++i)
    {
      const double foot = 2.0 * random.number() - 0.5;
      FlatTriangle needle{ { Complex(0.0), Complex(1.0), Complex(foot, height) } };
      const TriangleShape model = needle.shape();
      const Vector3 point = random.inside();
      // Rounding of the needle's coordinates is magnified by 1 / height.
      const Vector3 image = mapBetween(network, model, point);
      ASSERT_LT(distance(mapBetween(model, network, image), point), 1e-15 / height + 1e-13);
      const Vector3 inverse = mapBetween(model, network, point);
      ASSERT_TRUE(inverse.allFinite());
      ASSERT_GE(inverse.minCoeff(), 0.0);
      ASSERT_NEAR(inverse.sum(), 1.0, 1e-15);
    }
  }
}

TEST(SchwarzChristoffel, TakesAnyUnit)
{
  RandomTriangles random;
  const FlatTriangle triangle = random.triangle(Degree);
  const TriangleShape network = fromAngles(0.31, 0.35).shape();
  const Vector3 point(0.5, 0.3, 0.2);
  const Vector3 expected = mapBetween(network, triangle.shape(), point);
  for (const double unit : { 1e-200, 1e-30, 1e30, 1e200 })
  {
    FlatTriangle scaled = triangle;
    for (Complex& corner : scaled.Corners)
    {
      corner *= unit;
    }
    ASSERT_FALSE(scaled.shape().degenerate());
    EXPECT_LT(distance(mapBetween(network, scaled.shape(), point), expected), 1e-13);
  }
}

TEST(SchwarzChristoffel, DegenerateTrianglesAreFlagged)
{
  const Vector3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(TriangleShape().degenerate());
  EXPECT_TRUE(TriangleShape(o, o, o).degenerate());
  EXPECT_TRUE(TriangleShape(o, o, x).degenerate());
  EXPECT_TRUE(TriangleShape(o, 0.25 * x, x).degenerate());
  EXPECT_TRUE(TriangleShape(o, x, infinity * y).degenerate());
  EXPECT_TRUE(TriangleShape(o, x, std::nan("") * y).degenerate());
  EXPECT_TRUE(TriangleShape(o, x, 0.5 * x + 1e-10 * y).degenerate());
  EXPECT_FALSE(TriangleShape(o, x, 0.5 * x + 1e-8 * y).degenerate());
}

TEST(SchwarzChristoffel, TablesOfANetworkChangeNothing)
{
  const auto sphere = conformal::makeGeodesicSphere(18);
  const NetworkShapes shapes(sphere.Positions, sphere.Triangles);
  EXPECT_GE(shapes.numberOfTables(), 42);
  EXPECT_LE(shapes.numberOfTables(), 2 * 42);
  RandomTriangles random;
  for (int i = 0; i < 20000; ++i)
  {
    const Index r =
      static_cast<Index>(random.number() * static_cast<double>(sphere.Triangles.rows()));
    const TriangleShape network(sphere.Positions.row(sphere.Triangles(r, 0)),
      sphere.Positions.row(sphere.Triangles(r, 1)), sphere.Positions.row(sphere.Triangles(r, 2)));
    const TriangleShape model = random.triangle(Degree).shape();
    const Vector3 point = random.inside();
    const Vector3 image = shapes.toModel(r, model, point);
    ASSERT_LT(distance(image, mapBetween(network, model, point)), 2e-13);
    ASSERT_LT(distance(shapes.toNetwork(r, model, image), point), 1e-12);
    ASSERT_LT(
      distance(shapes.toNetwork(r, model, point), mapBetween(model, network, point)), 2e-13);
  }
}

TEST(SchwarzChristoffel, NetworksShareTheShapesOfAFineLattice)
{
  const auto sphere = conformal::makeGeodesicSphere(36);
  const NetworkShapes shapes(sphere.Positions, sphere.Triangles);
  EXPECT_LE(shapes.numberOfTables(), 2 * 156);
  EXPECT_GE(shapes.numberOfTables(), 156);
}

TEST(SchwarzChristoffel, NetworksMayHaveAnyTriangles)
{
  RandomTriangles random;
  Points positions(60, 3);
  Triangles triangles(20, 3);
  std::vector<FlatTriangle> flat;
  for (int r = 0; r < 20; ++r)
  {
    flat.push_back(random.triangle(Degree));
    for (int k = 0; k < 3; ++k)
    {
      const Complex z = flat.back().Corners[k];
      positions.row(3 * r + k) << z.real(), z.imag(), 0.0;
      triangles(r, k) = 3 * r + k;
    }
  }
  const NetworkShapes shapes(positions, triangles);
  EXPECT_EQ(shapes.numberOfTables(), 0);
  for (int i = 0; i < 2000; ++i)
  {
    const int r = i % 20;
    const TriangleShape model = random.triangle(Degree).shape();
    const Vector3 point = random.inside();
    EXPECT_LT(
      distance(shapes.toModel(r, model, point), mapBetween(flat[r].shape(), model, point)), 1e-13);
  }
}

// Their edges agree to 1e-12, their angles do not.
TEST(SchwarzChristoffel, NeedlesOfANetworkShareNothing)
{
  Points positions(30, 3);
  Triangles triangles(10, 3);
  for (int r = 0; r < 10; ++r)
  {
    positions.middleRows(3 * r, 3) << 0, 0, 0, 1, 0, 0, 0.4, 1e-6 * (1 + r), 0;
    triangles.row(r) << 3 * r, 3 * r + 1, 3 * r + 2;
  }
  const NetworkShapes shapes(positions, triangles);
  EXPECT_EQ(shapes.numberOfTables(), 0);
  const TriangleShape model = fromAngles(0.31, 0.35).shape();
  const Vector3 point(0.2, 0.3, 0.5);
  for (int r = 0; r < 10; ++r)
  {
    const TriangleShape needle(
      positions.row(3 * r), positions.row(3 * r + 1), positions.row(3 * r + 2));
    EXPECT_LT(distance(shapes.toModel(r, model, point), mapBetween(needle, model, point)), 1e-9);
  }
}

TEST(SchwarzChristoffel, NetworksMapAffinelyWhereATriangleIsDegenerate)
{
  Points positions(4, 3);
  positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 0, 0;
  Triangles triangles(2, 3);
  triangles << 0, 1, 2, 0, 3, 1;
  const NetworkShapes shapes(positions, triangles);
  EXPECT_FALSE(shapes.degenerate(0));
  EXPECT_TRUE(shapes.degenerate(1));
  const TriangleShape model = fromAngles(0.2, 0.3).shape();
  const Vector3 point(0.2, 0.3, 0.5);
  EXPECT_EQ(shapes.toModel(1, model, point), point);
  EXPECT_EQ(shapes.toNetwork(1, model, point), point);
  EXPECT_EQ(shapes.toModel(0, TriangleShape(), point), point);
  EXPECT_EQ(shapes.toNetwork(0, TriangleShape(), point), point);
  EXPECT_NE(shapes.toModel(0, model, point), point);
}
