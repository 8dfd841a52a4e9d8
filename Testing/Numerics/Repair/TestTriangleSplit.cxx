#include "Repair/TriangleSplit.h"

#include "Base/NumericalFailure.h"
#include "Base/Random.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

using conformal::splitTriangle;
using conformal::TriangleSplitInput;

namespace
{
using Ids = std::array<int, 3>;

TriangleSplitInput triangleWith(const std::vector<Eigen::Vector2d>& points)
{
  TriangleSplitInput input;
  input.Positions = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } };
  input.Positions.insert(input.Positions.end(), points.begin(), points.end());
  return input;
}

double area(const TriangleSplitInput& input, const Ids& ids)
{
  const Eigen::Vector2d u = input.Positions[ids[1]] - input.Positions[ids[0]],
                        v = input.Positions[ids[2]] - input.Positions[ids[0]];
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

// All triangles are counter-clockwise and fill the triangle; all segments are edges.
void expectSplit(const TriangleSplitInput& input, const std::vector<Ids>& parts)
{
  double sum = 0.0;
  std::map<std::array<int, 2>, int> edges;
  for (const Ids& ids : parts)
  {
    EXPECT_GT(area(input, ids), 0.0);
    sum += area(input, ids);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ((++edges[{ ids[k], ids[(k + 1) % 3] }]), 1);
    }
  }
  EXPECT_NEAR(sum, 0.5, 1e-14);
  for (const auto& [a, b] : input.Segments)
  {
    EXPECT_EQ((edges.count({ a, b }) + edges.count({ b, a })), 2U) << a << " " << b;
  }
}
}

TEST(TriangleSplit, SplitsAlongAPathFromEdgeToEdge)
{
  TriangleSplitInput input =
    triangleWith({ { 0.3, 0.0 }, { 0.35, 0.2 }, { 0.2, 0.3 }, { 0.0, 0.6 } });
  input.OnEdges = { { { 3 }, {}, { 6 } } };
  input.Segments = { { 3, 4 }, { 4, 5 }, { 5, 6 } };
  const std::vector<Ids> parts = splitTriangle(input);
  expectSplit(input, parts);
  EXPECT_EQ(parts.size(), 7U); // 2 n - 2 - b with n = 7 points, b = 5 of them on the edges
}

TEST(TriangleSplit, RecoversAClosedCurveAmongManyPoints)
{
  conformal::Random random(3);
  TriangleSplitInput input = triangleWith({});
  constexpr int size = 400;
  for (int i = 0; i < size; ++i) // a star, whose segments are long and whose corners are sharp
  {
    const double turn = 2.0 * conformal::Pi * i / size,
                 radius = (i % 2 == 0 ? 0.06 : 0.2) * (1.0 + 0.1 * random.uniform());
    input.Positions.emplace_back(0.3 + radius * std::cos(turn), 0.3 + radius * std::sin(turn));
    input.Segments.push_back({ 3 + i, 3 + (i + 1) % size });
  }
  runs::Watch watch;
  const std::vector<Ids> parts = splitTriangle(input, watch.run());
  expectSplit(input, parts);
  EXPECT_EQ(parts.size(), 2U * size + 1U);
  EXPECT_GE(watch.calls(), 2 * size);
}

TEST(TriangleSplit, ReportsPointsOnSegments)
{
  TriangleSplitInput input = triangleWith({ { 0.2, 0.2 }, { 0.3, 0.3 }, { 0.4, 0.4 } });
  input.Segments = { { 3, 5 } };
  EXPECT_THROW(splitTriangle(input), conformal::NumericalFailure);
}
