#include "Measure/TriangleStretch.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

using conformal::MovingTriangle;
using conformal::TriangleForm;
using conformal::TriangleMetric;
using conformal::triangleStretch;
using conformal::triangleStretchForm;

namespace
{
using Vector6 = Eigen::Matrix<double, 6, 1>;

double noise(int i)
{
  return std::sin(12.9898 * i + 1.0) * std::cos(4.1414 * i);
}

MovingTriangle someTriangle(int seed)
{
  MovingTriangle result;
  for (int i = 0; i < 6; ++i)
  {
    result.P[i] = noise(seed + i);
    result.Q[i] = noise(seed + 17 + 2 * i);
    for (int j = 0; j < 6; ++j)
    {
      result.PByUnknowns(i, j) = noise(seed + 100 + 6 * i + j);
      result.QByUnknowns(i, j) = noise(seed + 200 + 6 * i + j);
    }
  }
  return result;
}

TriangleMetric metricAt(const MovingTriangle& triangle, const Vector6& unknowns)
{
  const Vector6 p = triangle.P + triangle.PByUnknowns * unknowns,
                q = triangle.Q + triangle.QByUnknowns * unknowns;
  return { p.dot(p), p.dot(q), q.dot(q) };
}
}

// With the singular values of the map between two triangles.
TEST(TriangleStretch, IsTheSymmetricDirichletEnergy)
{
  constexpr double s = 2.0, t = 0.3;
  const TriangleMetric rest = { 1.0, 0.0, 1.0 }, now = { s * s, 0.0, t * t };
  const double areas = 0.5 + 0.5 * s * t;
  EXPECT_NEAR(triangleStretch(rest, now),
    0.5 * areas * (s * s + t * t + 1.0 / (s * s) + 1.0 / (t * t) - 4.0), 1e-13);
  EXPECT_NEAR(triangleStretch(rest, now), triangleStretch(now, rest), 1e-13);
  EXPECT_NEAR(triangleStretch(now, now), 0.0, 1e-15);
  EXPECT_TRUE(std::isinf(triangleStretch(rest, { 1.0, 1.0, 1.0 })));
}

TEST(TriangleStretch, SlopeIsThatOfDifferences)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    const MovingTriangle triangle = someTriangle(seed);
    const TriangleMetric rest = metricAt(someTriangle(seed + 50), Vector6::Zero());
    const TriangleForm form = triangleStretchForm(rest, triangle);
    for (int i = 0; i < 6; ++i)
    {
      constexpr double small = 1e-6;
      const Vector6 step = small * Vector6::Unit(i);
      const double slope = (triangleStretch(rest, metricAt(triangle, step)) -
                             triangleStretch(rest, metricAt(triangle, -step))) /
        (2.0 * small);
      EXPECT_NEAR(form.Slope[i], slope, 1e-5 * (1.0 + form.Slope.norm()));
    }
  }
}

// Where all second derivatives are at least 0, near a triangle at rest, none is taken away.
TEST(TriangleStretch, StiffnessIsThatOfDifferencesAtRest)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    const MovingTriangle triangle = someTriangle(seed);
    const TriangleMetric rest = metricAt(triangle, Vector6::Zero());
    const TriangleForm form = triangleStretchForm(rest, triangle);
    EXPECT_LT(form.Slope.norm(), 1e-9);
    constexpr double small = 1e-4;
    for (int i = 0; i < 6; ++i)
    {
      const Vector6 step = small * Vector6::Unit(i);
      const double curve = (triangleStretch(rest, metricAt(triangle, step)) +
                             triangleStretch(rest, metricAt(triangle, -step))) /
        (small * small);
      EXPECT_NEAR(form.Stiffness(i, i), curve, 1e-3 * form.Stiffness.norm());
    }
  }
}

TEST(TriangleStretch, StiffnessIsNeverNegative)
{
  for (int seed = 0; seed < 50; ++seed)
  {
    const TriangleForm form =
      triangleStretchForm(metricAt(someTriangle(seed + 50), Vector6::Zero()), someTriangle(seed));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(form.Stiffness);
    EXPECT_GT(solver.eigenvalues()[0], -1e-12 * solver.eigenvalues()[5]);
  }
}
