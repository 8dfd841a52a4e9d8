#include "Border/BorderCurve.h"

#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using conformal::BorderCurve;
using conformal::BorderSurface;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;

namespace
{
constexpr double Height = 0.3; // the points end here

// Borders of a sphere whose vertices are marked below a height, which is not that of the border.
std::vector<BorderCurve> firstAt(const Mesh& mesh, double height)
{
  std::vector<char> open;
  std::vector<double> support;
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    open.push_back(mesh.Positions(v, 2) < height);
    support.push_back(open.back() ? 0.0 : 1.0);
  }
  return conformal::firstBorders(mesh, open, support);
}

struct Error
{
  double Mean = 0.0, Largest = 0.0;
};

// Distance of a curve from the circle at the height where points end, in their spacing.
Error errorOf(const BorderCurve& curve, double spacing)
{
  Error error;
  for (Index i = 0; i < curve.Positions.rows(); ++i)
  {
    const double away = std::abs(std::asin(curve.Positions(i, 2) / curve.Positions.row(i).norm()) -
                          std::asin(Height)) /
      spacing;
    error.Mean += away / static_cast<double>(curve.Positions.rows());
    error.Largest = std::max(error.Largest, away);
  }
  return error;
}
}

TEST(BorderCurve, RunsBetweenMarkedAndUnmarkedVertices)
{
  const Mesh mesh = conformal::makeGeodesicSphere(20);
  const std::vector<BorderCurve> borders = firstAt(mesh, 0.2);
  ASSERT_EQ(borders.size(), 1u);
  Vector3 enclosed = Vector3::Zero();
  const Points& nodes = borders[0].Positions;
  for (Index i = 0; i < nodes.rows(); ++i)
  {
    EXPECT_NEAR(nodes(i, 2), 0.2, 0.06);
    enclosed += Vector3(nodes.row(i)).cross(Vector3(nodes.row((i + 1) % nodes.rows())));
  }
  EXPECT_GT(enclosed[2], 5.0); // counter-clockwise, with the unmarked part on the left
  EXPECT_EQ(firstAt(mesh, 2.0).size(), 0u);
  EXPECT_EQ(firstAt(mesh, -2.0).size(), 0u);
}

// The mesh has triangles of twice to eight times the spacing of the points.
TEST(BorderCurve, EndsWherePointsEnd)
{
  const Mesh mesh = conformal::makeGeodesicSphere(36);
  const BorderSurface surface(mesh);
  for (const Index count : { 10000, 40000, 160000 })
  {
    const Points points = sheets::pointsAbove(Height, count, 3);
    const double spacing = std::sqrt(2.0 * conformal::Pi * (1.0 - Height) / count);
    for (const double height : { Height - 0.04, Height, Height + 0.04 })
    {
      const auto fitted = conformal::fitBorders(firstAt(mesh, height), surface, points);
      ASSERT_EQ(fitted.size(), 1u);
      const Error error = errorOf(fitted[0], spacing);
      EXPECT_LT(error.Mean, 0.3) << count << " " << height;
      EXPECT_LT(error.Largest, 1.2) << count << " " << height;
      const BorderCurve& curve = fitted[0];
      for (Index i = 0; i < curve.Positions.rows(); ++i)
      {
        EXPECT_LT(curve.Outward(i, 2), -0.8);
        EXPECT_GT(curve.Normals.row(i).dot(curve.Positions.row(i)), 0.9);
      }
    }
  }
}

// A few stray points beyond the border do not move it to them.
TEST(BorderCurve, OnePointBeyondDoesNotMatter)
{
  const Mesh mesh = conformal::makeGeodesicSphere(36);
  Points points = sheets::pointsAbove(Height, 40000, 3);
  for (Index i = 0; i < 8; ++i)
  {
    const double angle = 0.25 * conformal::Pi * static_cast<double>(i);
    points.row(i) << 0.97 * std::cos(angle), 0.97 * std::sin(angle), 0.24;
  }
  const auto fitted = conformal::fitBorders(firstAt(mesh, Height), BorderSurface(mesh), points);
  const double spacing = std::sqrt(2.0 * conformal::Pi * (1.0 - Height) / 40000.0);
  EXPECT_LT(errorOf(fitted.at(0), spacing).Mean, 0.35);
  EXPECT_LT(errorOf(fitted.at(0), spacing).Largest, 1.5);
}

TEST(BorderCurve, SameBitsInAnyOrderOfBlocks)
{
  const Mesh mesh = conformal::makeGeodesicSphere(24);
  const Points points = sheets::pointsAbove(Height, 20000, 3);
  const auto first = firstAt(mesh, Height);
  const auto one = conformal::fitBorders(first, BorderSurface(mesh), points);
  const auto other =
    conformal::fitBorders(first, BorderSurface(mesh, runs::backwards()), points, runs::backwards());
  EXPECT_EQ(one.at(0).Positions, other.at(0).Positions);
}

TEST(BorderCurve, WithoutPointsNothingMoves)
{
  const Mesh mesh = conformal::makeGeodesicSphere(8);
  const auto first = firstAt(mesh, Height);
  const auto fitted = conformal::fitBorders(first, BorderSurface(mesh), Points(0, 3));
  EXPECT_TRUE(fitted.at(0).Positions.isApprox(first.at(0).Positions, 1e-12));
}
