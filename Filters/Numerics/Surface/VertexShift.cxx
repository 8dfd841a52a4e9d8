#include "Surface/VertexShift.h"

#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Cloud/SampleRotation.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"
#include "Surface/CurvedTriangles.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
constexpr Index SamplesPerVertex = 4, MaximumSamples = 0x800000;
constexpr double FactorOfCrowding = 3.0;
constexpr double MaximumOfMean = 16.0; // maximum length in units of the mean move; bounds the sums
constexpr int RingsAroundSamples = 2;

double areaOf(const Points& positions, const Triangles& triangles, Index r)
{
  const Vector3 a = positions.row(triangles(r, 0)), b = positions.row(triangles(r, 1)),
                c = positions.row(triangles(r, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

/// Average a vertex quantity over the area of marked triangles.
double meanOverArea(const Points& positions, const Triangles& triangles,
  const Eigen::VectorXd& values, const std::vector<bool>& marked)
{
  double sum = 0.0, whole = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    if (marked[r])
    {
      const double area = areaOf(positions, triangles, r);
      whole += area;
      sum +=
        area * (values[triangles(r, 0)] + values[triangles(r, 1)] + values[triangles(r, 2)]) / 3.0;
    }
  }
  return whole > 0.0 ? sum / whole : 0.0;
}

/// Extend the marked triangles by rings.
std::vector<bool> widened(
  const Triangles& triangles, Index numberOfVertices, std::vector<bool> marked)
{
  for (int ring = 0; ring < RingsAroundSamples; ++ring)
  {
    std::vector<bool> vertices(numberOfVertices, false);
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      for (int k = 0; marked[r] && k < 3; ++k)
      {
        vertices[triangles(r, k)] = true;
      }
    }
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      marked[r] =
        vertices[triangles(r, 0)] || vertices[triangles(r, 1)] || vertices[triangles(r, 2)];
    }
  }
  return marked;
}
}

double vertexShift(const Mesh& mesh, const TrainingSamples& samples, const Run& run)
{
  const Triangles& triangles = mesh.Triangles;
  Steps steps(run, { 0.3, 0.7 });
  const Run preparing = steps.next().unwatched();
  const Points positions = samples.normalizeAll(mesh.Positions);
  const Adjacency around = vertexTriangles(triangles, positions.rows());
  const Points normals =
    curvingNormals(positions, triangles, around, triangleNeighbors(triangles, around), preparing);
  const CurvedTriangles raised(positions, normals, triangles);
  const Points moved = lowerVertices(raised, around, 1.0, preparing);
  const CurvedTriangles lowered(moved, normals, triangles);
  Eigen::VectorXd moves = (moved - positions).rowwise().norm();
  const double unit =
    meanOverArea(positions, triangles, moves, std::vector<bool>(triangles.rows(), true));
  if (!(unit > 0.0))
  {
    return UsualVertexShift;
  }
  moves = (moves / unit).cwiseMin(MaximumOfMean);

  const TriangleTree tree(positions, triangles, preparing);
  SampleRotation rotation(samples, 1);
  rotation.turn(std::min(MaximumSamples, SamplesPerVertex * positions.rows()));
  enum
  {
    Product,
    Square,
    Moves,
    Feet
  };
  FixedPointSums sums(Feet + triangles.rows());
  const auto bounded = [&](double height)
  { return std::clamp(height / unit, -MaximumOfMean, MaximumOfMean) / MaximumOfMean; };
  forEachFoot(
    samples, tree, rotation.count(), [&](Index i) { return rotation.id(i); },
    [&](Index, const Vector3& x, const FootPoint& foot)
    {
      const Vector3& m = foot.Barycentric;
      const auto ids = triangles.row(foot.Triangle);
      const Vector3 a = positions.row(ids[0]), b = positions.row(ids[1]), c = positions.row(ids[2]);
      const Vector3 normal = (b - a).cross(c - a).stableNormalized();
      const Vector3 high = raised[foot.Triangle].position(m),
                    low = lowered[foot.Triangle].position(m);
      const double fall = bounded(normal.dot(low - high));
      sums.add(Product, bounded(normal.dot(x - high)) * fall);
      sums.add(Square, fall * fall);
      // Use the mean of the triangle, since foot points concentrate on protruding edges and
      // corners.
      sums.add(Moves, (moves[ids[0]] + moves[ids[1]] + moves[ids[2]]) / (3.0 * MaximumOfMean));
      sums.add(Feet + foot.Triangle, 1.0);
    },
    steps.next());
  sums.reduce(samples.reduce());
  std::vector<bool> met(triangles.rows());
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    met[r] = sums[Feet + r] > 0.0;
  }
  const double overSamples =
    MaximumOfMean * sums[Moves] / static_cast<double>(rotation.totalCount());
  const double overArea =
    meanOverArea(positions, triangles, moves, widened(triangles, positions.rows(), met));
  if (!(sums[Square] > 0.0 && overArea > 0.0))
  {
    return UsualVertexShift;
  }
  const double fit = std::clamp(sums[Product] / sums[Square], 0.0, UsualVertexShift);
  const double crowding = std::max(0.0, overSamples / overArea - 1.0);
  constexpr double digits = 16.0; // further digits are rounding errors
  const double shift = std::round(digits * (fit + FactorOfCrowding * crowding)) / digits;
  return std::min(shift, MaximumVertexShift);
}

}
