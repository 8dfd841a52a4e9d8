#include "Motion/TriangleCorrespondence.h"

#include "Runs.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using conformal::correspondingTriangles;
using conformal::Index;
using conformal::MappedMesh;
using conformal::SurfaceCorrespondence;
using conformal::TriangleCorrespondenceOptions;
using conformal::Vector3;
using spheres::mapped;

namespace
{
// Turn a map, so that no vertices of two spheres coincide.
MappedMesh turned(MappedMesh mesh)
{
  const Eigen::AngleAxisd turn(0.3, Vector3(1.0, 2.0, 3.0).normalized());
  mesh.SpherePositions = mesh.SpherePositions * turn.toRotationMatrix().transpose();
  return mesh;
}
}

TEST(TriangleCorrespondence, OfASurfaceToItselfIsTheIdentity)
{
  const MappedMesh mesh = mapped(7);
  const SurfaceCorrespondence pairs = correspondingTriangles(mesh, mesh);
  ASSERT_EQ(pairs.TriangleWeights.size(), mesh.Triangles.rows());
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    ASSERT_EQ(pairs.TriangleWeights.Offsets[r], r);
    EXPECT_EQ(pairs.TriangleWeights.Ids[r], r);
    EXPECT_EQ(pairs.TriangleWeights.Weights[r], 1.0);
  }
  for (Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    Vector3 place = Vector3::Zero();
    for (Index k = pairs.VertexWeights.Offsets[v]; k < pairs.VertexWeights.Offsets[v + 1]; ++k)
    {
      place +=
        pairs.VertexWeights.Weights[k] * mesh.Positions.row(pairs.VertexWeights.Ids[k]).transpose();
    }
    EXPECT_LT((place - mesh.Positions.row(v).transpose()).norm(), 1e-14);
  }
}

// The centers of the parts of a target triangle are a quadrature: the weights of the source
// triangles are their fractions of the area, so that each source triangle gets about its own area.
TEST(TriangleCorrespondence, AllSourceTrianglesGetTheirAreas)
{
  const MappedMesh fine = mapped(20), coarse = turned(mapped(5));
  const SurfaceCorrespondence pairs = correspondingTriangles(fine, coarse);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(fine.Triangles.rows());
  for (Index r = 0; r < coarse.Triangles.rows(); ++r)
  {
    const double area = conformal::areaVector(coarse.SpherePositions, coarse.Triangles, r).norm();
    double sum = 0.0;
    for (Index k = pairs.TriangleWeights.Offsets[r]; k < pairs.TriangleWeights.Offsets[r + 1]; ++k)
    {
      areas[pairs.TriangleWeights.Ids[k]] += area * pairs.TriangleWeights.Weights[k];
      sum += pairs.TriangleWeights.Weights[k];
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
  }
  double error = 0.0;
  for (Index r = 0; r < fine.Triangles.rows(); ++r)
  {
    const double own = conformal::areaVector(fine.SpherePositions, fine.Triangles, r).norm();
    EXPECT_GT(areas[r], 0.0);
    error += std::abs(areas[r] - own);
  }
  EXPECT_LT(error / areas.sum(), 0.2);
}

TEST(TriangleCorrespondence, WithoutSubdivisionHasOneTriangle)
{
  const MappedMesh fine = mapped(20), coarse = turned(mapped(5));
  TriangleCorrespondenceOptions options;
  options.MaximumSubdivision = 1;
  const SurfaceCorrespondence pairs = correspondingTriangles(fine, coarse, options);
  EXPECT_EQ(static_cast<Index>(pairs.TriangleWeights.Ids.size()), coarse.Triangles.rows());
}

TEST(TriangleCorrespondence, CanBeAbortedAndHasTheSameBitsOnAllThreads)
{
  const MappedMesh fine = mapped(20), coarse = turned(mapped(12));
  const auto with = [&](const conformal::Run& run)
  { return correspondingTriangles(fine, coarse, {}, run); };
  const SurfaceCorrespondence once = with({}), twice = with(runs::backwards());
  EXPECT_EQ(once.TriangleWeights.Ids, twice.TriangleWeights.Ids);
  EXPECT_EQ(once.TriangleWeights.Weights, twice.TriangleWeights.Weights);
  EXPECT_EQ(once.VertexWeights.Weights, twice.VertexWeights.Weights);
  EXPECT_THROW(with(runs::stoppingAt(0.6)), conformal::Aborted);
  runs::Watch watch;
  with(watch.run());
  EXPECT_EQ(watch.last(), 1.0);
}
