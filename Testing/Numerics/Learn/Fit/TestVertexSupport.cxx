#include "Learn/Fit/VertexSupport.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using conformal::Index;

// Where the samples end, support falls to 0 within a few of their spacings, and nowhere else.
TEST(VertexSupport, FallsOverWhatNobodySaw)
{
  const conformal::Mesh mesh = conformal::makeGeodesicSphere(30);
  const auto supportAround = [&](const conformal::Points& cloud, double rim)
  {
    const conformal::TrainingSamples samples{ conformal::PointView(cloud) };
    conformal::Points positions(mesh.Positions.rows(), 3);
    for (Index i = 0; i < positions.rows(); ++i)
    {
      positions.row(i) = samples.normalize(mesh.Positions.row(i));
    }
    const std::vector<double> support =
      conformal::supportOfVertices(samples, positions, mesh.Triangles);
    for (Index i = 0; i < positions.rows(); ++i)
    {
      const double z = mesh.Positions(i, 2);
      EXPECT_GE(support[i], 0.0);
      EXPECT_LE(support[i], 1.0);
      if (z < rim - 0.05)
      {
        EXPECT_GT(support[i], 0.9) << z; // samples at random leave gaps
      }
      if (z > rim + 0.3)
      {
        EXPECT_EQ(support[i], 0.0) << z;
      }
    }
  };
  conformal::Random random(5);
  conformal::Points cloud(20000, 3);
  for (Index i = 0; i < cloud.rows();)
  {
    const double z = 2.0 * random.uniform() - 1.0, angle = 8.0 * std::atan(1.0) * random.uniform();
    const double r = std::sqrt(1.0 - z * z);
    if (z < 0.5)
    {
      cloud.row(i++) << r * std::cos(angle), r * std::sin(angle), z;
    }
  }
  supportAround(cloud, 0.5);

  // Lines 20 times as far apart as the points on them are data everywhere.
  const int lines = 40, perLine = 800;
  conformal::Points scan(lines * perLine, 3);
  for (int line = 0; line < lines; ++line)
  {
    const double polar = 4.0 * std::atan(1.0) * (line + 0.5) / lines;
    for (int k = 0; k < perLine; ++k)
    {
      const double angle = 8.0 * std::atan(1.0) * k / perLine;
      scan.row(line * perLine + k) << std::sin(polar) * std::cos(angle),
        std::sin(polar) * std::sin(angle), std::cos(polar);
    }
  }
  supportAround(scan, 2.0);
}
