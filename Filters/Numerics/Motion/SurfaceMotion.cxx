#include "Motion/SurfaceMotion.h"

#include "Mesh/VertexNormals.h"
#include "Register/SphereSamples.h"
#include "Sphere/SphereOrientation.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
// Weights of values at three times for the derivative at the middle time. The error is of second
// order also if the times are not evenly spaced. If the middle time is the first or the last one,
// the difference is one-sided.
Eigen::Vector3d derivativeWeights(double before, double time, double after)
{
  const double h = time - before, k = after - time;
  if (!(h > 0.0))
  {
    return { 0.0, -1.0 / k, 1.0 / k };
  }
  if (!(k > 0.0))
  {
    return { -1.0 / h, 1.0 / h, 0.0 };
  }
  return { -k / (h * (h + k)), (k - h) / (h * k), h / (k * (h + k)) };
}

// Return differences of vectors at the corners of a triangle, along two of its edges.
Eigen::Matrix<double, 3, 2> alongEdges(const Points& vectors, const Triangles& triangles, Index f)
{
  const Vector3 a = vectors.row(triangles(f, 0));
  Eigen::Matrix<double, 3, 2> differences;
  differences.col(0) = Vector3(vectors.row(triangles(f, 1))) - a;
  differences.col(1) = Vector3(vectors.row(triangles(f, 2))) - a;
  return differences;
}
}

//------------------------------------------------------------------------------
SurfaceMotion computeMotion(const MovingSurface& before, const MovingSurface& surface,
  const MovingSurface& after, const Run& run)
{
  if (!(after.Time > before.Time) || surface.Time < before.Time || surface.Time > after.Time)
  {
    throw std::invalid_argument("times do not ascend");
  }
  const MappedMesh& mesh = surface.Surface;
  const auto at = [&](const MovingSurface& other)
  {
    return &other == &surface ? mesh.Positions
                              : positionsInDirections(other.Surface, mesh.SpherePositions, run);
  };
  const Points first = at(before), last = at(after);
  SurfaceMotion motion;
  const Eigen::Vector3d weights = derivativeWeights(before.Time, surface.Time, after.Time);
  motion.Velocities = weights[0] * first + weights[1] * mesh.Positions + weights[2] * last;
  const Points normals = vertexNormals(mesh.Positions, mesh.Triangles);
  const Index size = mesh.Positions.rows();
  motion.Tangential.resize(size, 3);
  motion.Normal.resize(size);
  for (Index v = 0; v < size; ++v)
  {
    motion.Normal[v] = motion.Velocities.row(v).dot(normals.row(v));
    motion.Tangential.row(v) = motion.Velocities.row(v) - motion.Normal[v] * normals.row(v);
  }
  motion.AreaRates.assign(size, 0.0);
  motion.ShearRates.assign(size, 0.0);
  std::vector<double> areas(size, 0.0);
  for (Index f = 0; f < mesh.Triangles.rows(); ++f)
  {
    const Eigen::Matrix<double, 3, 2> edges = alongEdges(mesh.Positions, mesh.Triangles, f),
                                      rates = alongEdges(motion.Velocities, mesh.Triangles, f);
    const Eigen::Matrix2d metric = edges.transpose() * edges;
    const double determinant = metric.determinant();
    // The metric of a needle is not invertible.
    if (!(determinant > 1e-12 * metric.trace() * metric.trace()))
    {
      continue;
    }
    const Eigen::Matrix2d strain =
      metric.inverse() * (edges.transpose() * rates + rates.transpose() * edges) / 2.0;
    const double trace = strain.trace(), area = 0.5 * std::sqrt(determinant);
    const double shear = std::sqrt(std::max(0.0, 0.25 * trace * trace - strain.determinant()));
    for (int k = 0; k < 3; ++k)
    {
      const int v = mesh.Triangles(f, k);
      areas[v] += area;
      motion.AreaRates[v] += area * trace;
      motion.ShearRates[v] += area * shear;
    }
  }
  for (Index v = 0; v < size; ++v)
  {
    const double factor = areas[v] > 0.0 ? 1.0 / areas[v] : 0.0;
    motion.AreaRates[v] *= factor;
    motion.ShearRates[v] *= factor;
  }
  return motion;
}

//------------------------------------------------------------------------------
Points positionsInDirections(const MappedMesh& surface, const Points& directions, const Run& run)
{
  const SphereGrid grid(
    Mesh{ surface.SpherePositions, turnedOutward(surface.Triangles, surface.SpherePositions) },
    run);
  return sampleAt(grid, surface.Positions, directions, run);
}

//------------------------------------------------------------------------------
Points positionsBetween(const MappedMesh& surface, const MappedMesh& later, double fraction)
{
  return (1.0 - fraction) * surface.Positions +
    fraction * positionsInDirections(later, surface.SpherePositions);
}
}
