#include "Register/ConsistentRemesh.h"

#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Runs.h"
#include "Shapes.h"
#include "Sphere/Resampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using conformal::ConsistentMeshes;
using conformal::ConsistentRemeshOptions;
using conformal::Index;
using conformal::MappedMesh;
using conformal::Points;
using conformal::remeshConsistently;
using conformal::RemeshMeshType;
using conformal::Vector3;

namespace
{
/// An ellipsoid with a limb along x, mapped by its directions.
MappedMesh withLimb(int frequency, double limb)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency);
  MappedMesh mesh;
  mesh.Triangles = sphere.Triangles;
  mesh.SpherePositions = sphere.Positions;
  mesh.Positions = shapes::over(sphere.Positions,
    [=](const Vector3& n) -> Vector3
    {
      const double radius = 1.0 + limb * std::exp(-(1.0 - n[0]) / 0.03);
      return radius * Vector3(n[0], 0.8 * n[1], 0.6 * n[2]);
    });
  return mesh;
}

ConsistentRemeshOptions geodesic(int frequency)
{
  ConsistentRemeshOptions options;
  options.MeshType = RemeshMeshType::Geodesic;
  options.Frequency = frequency;
  return options;
}

ConsistentRemeshOptions adaptive(Index size)
{
  ConsistentRemeshOptions options;
  options.NumberOfPoints = size;
  return options;
}

void expectRemeshRefused(const std::vector<MappedMesh>& surfaces, const std::string& why)
{
  for (const ConsistentRemeshOptions& options : { geodesic(5), adaptive(600) })
  {
    try
    {
      remeshConsistently(surfaces, options);
      ADD_FAILURE() << why;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  }
}
}

TEST(ConsistentRemesh, PointsAreThoseInTheDirections)
{
  const std::vector<MappedMesh> surfaces = { withLimb(12, 0.0), withLimb(17, 2.0),
    withLimb(9, 1.0) };
  for (const ConsistentRemeshOptions& options : { geodesic(10), adaptive(1000) })
  {
    const ConsistentMeshes meshes = remeshConsistently(surfaces, options);
    ASSERT_EQ(meshes.Positions.size(), 3u);
    EXPECT_TRUE(conformal::checkGenusZero(
      meshes.Sphere.Triangles, meshes.Sphere.Positions.rows(), meshes.Sphere.Positions)
                  .isGenusZero());
    for (std::size_t s = 0; s < surfaces.size(); ++s)
    {
      EXPECT_EQ(meshes.Positions[s],
        conformal::resample(surfaces[s].SpherePositions, surfaces[s].Positions,
          surfaces[s].Triangles, meshes.Sphere.Positions));
      // The weights say the same.
      const conformal::ResampleWeights& weights = meshes.Weights[s];
      ASSERT_EQ(weights.size(), meshes.Sphere.Positions.rows());
      for (Index i = 0; i < weights.size(); ++i)
      {
        Vector3 sum = Vector3::Zero();
        for (Index k = weights.Offsets[i]; k < weights.Offsets[i + 1]; ++k)
        {
          sum += weights.Weights[k] * surfaces[s].Positions.row(weights.Ids[k]).transpose();
        }
        ASSERT_LT((sum - meshes.Positions[s].row(i).transpose()).norm(), 1e-13);
      }
      EXPECT_GT(conformal::signedVolume(meshes.Positions[s], meshes.Sphere.Triangles), 0.0);
    }
  }
}

// Points on the limb, which only the second surface has, and which is small on the sphere.
TEST(ConsistentRemesh, TheAdaptiveMeshIsDenseWhereOneSurfaceAsksForIt)
{
  const auto onTheLimb = [](const ConsistentMeshes& meshes)
  { return (meshes.Sphere.Positions.col(0).array() > 0.95).count(); };
  const auto plain = remeshConsistently({ withLimb(20, 0.0), withLimb(20, 0.0) }, adaptive(2000)),
             limb = remeshConsistently({ withLimb(20, 0.0), withLimb(20, 6.0) }, adaptive(2000));
  EXPECT_GT(onTheLimb(limb), 4 * onTheLimb(plain));
  EXPECT_NEAR(static_cast<double>(limb.Sphere.Positions.rows()), 2000.0, 40.0);
}

TEST(ConsistentRemesh, MirroredMapsAndTrianglesTurnedOverAreTakenForWhatTheyAre)
{
  MappedMesh one = withLimb(9, 0.5), other = withLimb(12, 1.0);
  const Index before = remeshConsistently({ one, other }, geodesic(6)).Positions[0].rows();
  // Triangles clockwise from outside: the map mirrors nothing.
  one.Triangles.col(0).swap(one.Triangles.col(1));
  auto meshes = remeshConsistently({ one, other }, geodesic(6));
  EXPECT_EQ(meshes.Positions[0].rows(), before);
  EXPECT_GT(conformal::signedVolume(meshes.Positions[0], meshes.Sphere.Triangles), 0.0);
  // One mirrored map corresponds to nothing, two do.
  one.SpherePositions.col(1) *= -1.0;
  expectRemeshRefused({ one, other }, "the map to the sphere of surface 1 does not mirror it");
  expectRemeshRefused({ other, one }, "the map to the sphere of surface 1 mirrors it");
  other.SpherePositions.col(1) *= -1.0;
  meshes = remeshConsistently({ one, other }, geodesic(6));
  EXPECT_GT(conformal::signedVolume(meshes.Positions[0], meshes.Sphere.Triangles), 0.0);
  EXPECT_GT(conformal::signedVolume(meshes.Positions[1], meshes.Sphere.Triangles), 0.0);
}

TEST(ConsistentRemesh, MapsThatDoNotCoverTheSphereOnceAreRefused)
{
  const MappedMesh good = withLimb(8, 0.0);
  MappedMesh folded = good;
  const Vector3 corner = folded.SpherePositions.row(folded.Triangles(300, 0)),
                mirror = folded.SpherePositions.row(folded.Triangles(300, 1));
  folded.SpherePositions.row(folded.Triangles(300, 0)) = (2.0 * mirror - corner).normalized();
  expectRemeshRefused(
    { good, folded }, "the map to the sphere of surface 1 covers it 1 times with");
  MappedMesh bowl = good;
  bowl.SpherePositions.col(2) = bowl.SpherePositions.col(2).cwiseAbs();
  expectRemeshRefused({ bowl, good }, "the map to the sphere of surface 0 covers it 0 times");
  MappedMesh half = good;
  half.Triangles.conservativeResize(half.Triangles.rows() / 2, 3);
  expectRemeshRefused(
    { good, half }, "surface 1 is open, or its triangles are not oriented consistently, at");
  expectRemeshRefused({}, "there is no surface to remesh");
}

TEST(ConsistentRemesh, ThreadsChangeNoBitAndARunCanBeStopped)
{
  const std::vector<MappedMesh> surfaces = { withLimb(30, 0.0), withLimb(40, 2.0) };
  for (const ConsistentRemeshOptions& options : { geodesic(30), adaptive(3000) })
  {
    const ConsistentMeshes one = remeshConsistently(surfaces, options),
                           two = remeshConsistently(surfaces, options, runs::backwards());
    EXPECT_EQ(one.Sphere.Triangles, two.Sphere.Triangles);
    EXPECT_EQ(one.Positions, two.Positions);
    EXPECT_THROW(remeshConsistently(surfaces, options, runs::stoppingAt(0.5)), conformal::Aborted);
    runs::Watch watch;
    remeshConsistently(surfaces, options, watch.run());
    EXPECT_GT(watch.calls(), 10);
  }
}
