#include "Register/SphericalMorph.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Linear/MultifrontalCholesky.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"
#include "Register/TriangleRotations.h"
#include "Sphere/MoebiusTransform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace conformal
{
namespace
{
/// Shapes of weight above 0, and their centers.
struct Active
{
  const Points* Reference =
    nullptr; ///< shape to which rotations are relative; may be one of Shapes
  std::vector<const Points*> Shapes;
  std::vector<double> Weights;
  std::vector<Vector3> Centers;
  std::vector<Vector3> Turns; ///< rotation vector of each shape relative to the reference
};

Vector3 rotationVector(const Eigen::Matrix3d& rotation)
{
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

/// Compute the areas around the vertices, summed over all shapes.
Eigen::VectorXd commonAreas(const Mesh& sphere, const std::vector<const Points*>& shapes)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(sphere.Positions.rows());
  for (const Points* shape : shapes)
  {
    areas += vertexAreas(*shape, sphere.Triangles);
  }
  return areas;
}

/// @param[in] reference  shape to which rotations are relative; the first shape if null
Active activeShapes(const Mesh& sphere, const std::vector<Points>& shapes,
  const std::vector<double>& weights, const Points* reference = nullptr)
{
  Active active;
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    if (weights[s] > 0.0)
    {
      active.Shapes.push_back(&shapes[s]);
      active.Weights.push_back(weights[s]);
    }
  }
  const Eigen::VectorXd areas = commonAreas(sphere, active.Shapes);
  const double sum = areas.sum();
  for (const Points* shape : active.Shapes)
  {
    active.Centers.emplace_back(shape->transpose() * areas / sum);
  }
  active.Reference = reference != nullptr ? reference : active.Shapes[0];
  const Vector3 center = active.Reference->transpose() * areas / sum;
  const Points centered = active.Reference->rowwise() - center.transpose();
  for (std::size_t s = 0; s < active.Shapes.size(); ++s)
  {
    const Points other = active.Shapes[s]->rowwise() - active.Centers[s].transpose();
    active.Turns.emplace_back(active.Shapes[s] == active.Reference
        ? Vector3::Zero()
        : rotationVector(closestRotation(centered, other, areas)));
  }
  return active;
}

Vector3 weighted(const std::vector<double>& weights, const std::vector<Vector3>& vectors)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t s = 0; s < weights.size(); ++s)
  {
    sum += weights[s] * vectors[s];
  }
  return sum;
}

/// Corners of each blended triangle, relative to the first corner.
using Wanted = std::vector<Eigen::Matrix3d>;

Wanted wantedTriangles(const Active& active, const Mesh& sphere, const Run& run)
{
  const Triangles& triangles = sphere.Triangles;
  const Triangles neighbors = triangleNeighbors(triangles, sphere.Positions.rows());
  std::vector<double> shares(active.Shapes.size() + 1, 0.8); // rotations, triangles
  shares.back() = 0.2;
  Steps steps(run, shares);
  std::vector<std::vector<Vector3>> turns(active.Shapes.size());
  for (std::size_t s = 0; s < active.Shapes.size(); ++s)
  {
    if (active.Shapes[s] != active.Reference)
    {
      turns[s] = triangleRotations(
        triangles, neighbors, *active.Reference, *active.Shapes[s], active.Turns[s], steps.next());
    }
  }
  Wanted wanted(triangles.rows());
  const Eigen::Matrix3d whole = rotationOf(weighted(active.Weights, active.Turns));
  forBlocksReporting(steps.next(), triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        Vector3 turn = Vector3::Zero();
        Eigen::Matrix3d corners = Eigen::Matrix3d::Zero();
        for (std::size_t s = 0; s < active.Shapes.size(); ++s)
        {
          const Points& shape = *active.Shapes[s];
          Eigen::Matrix3d own; // corners of the triangle, rotated back to the reference
          for (int k = 0; k < 3; ++k)
          {
            own.col(k) = shape.row(triangles(r, k)) - shape.row(triangles(r, 0));
          }
          if (active.Shapes[s] != active.Reference)
          {
            own = (rotationOf(active.Turns[s]) * rotationOf(turns[s][r])).transpose() * own;
            turn += active.Weights[s] * turns[s][r];
          }
          corners += active.Weights[s] * own;
        }
        wanted[r] = whole * rotationOf(turn) * corners;
      }
    });
  return wanted;
}

/// Compute the cotangents of the angles of triangles, clamped to valid values.
Points cotangentsOf(const Wanted& wanted)
{
  Points cotangents(static_cast<Index>(wanted.size()), 3);
  for (Index r = 0; r < cotangents.rows(); ++r)
  {
    const Eigen::Matrix3d& corners = wanted[r];
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 u = corners.col(next(k)) - corners.col(k),
                    v = corners.col(previous(k)) - corners.col(k);
      const double area = u.cross(v).norm();
      const double cotangent = area > 0.0 ? u.dot(v) / area : MinimumCotangent;
      cotangents(r, k) = std::clamp(cotangent, MinimumCotangent, MaximumCotangent);
    }
  }
  return cotangents;
}

/// Rotate all shapes to a common orientation, the mean of their orientations, and average them. The
/// center of the result is the mean of the centers.
Points alignedBlend(const Active& active)
{
  const Eigen::Matrix3d whole = rotationOf(weighted(active.Weights, active.Turns));
  Points shape = Points::Zero(active.Shapes[0]->rows(), 3);
  for (std::size_t s = 0; s < active.Shapes.size(); ++s)
  {
    const Eigen::Matrix3d turn = whole * rotationOf(active.Turns[s]).transpose();
    shape += active.Weights[s] * (active.Shapes[s]->rowwise() - active.Centers[s].transpose()) *
      turn.transpose();
  }
  shape.rowwise() += weighted(active.Weights, active.Centers).transpose();
  return shape;
}

/// Compute the factor by which a blended shape must grow so that its area is the mean of the areas.
/// Where the shapes are stretched in different directions, the mean triangle is too large.
double sizeFactor(const Points& shape, const Active& active, const Triangles& triangles)
{
  double wanted = 0.0;
  for (std::size_t s = 0; s < active.Shapes.size(); ++s)
  {
    wanted += active.Weights[s] * surfaceArea(*active.Shapes[s], triangles);
  }
  const double area = surfaceArea(shape, triangles);
  return area > 0.0 && wanted > 0.0 ? std::sqrt(wanted / area) : 1.0;
}

Points rigidBlend(const Active& active, const Mesh& sphere, const Run& run)
{
  // Progress: blend, triangles, forces, matrix factor, solution.
  Steps steps(run, { 0.01, 0.45, 0.05, 0.45, 0.04 });
  steps.next();
  const Triangles& triangles = sphere.Triangles;
  const Eigen::VectorXd areas = commonAreas(sphere, active.Shapes);
  const Vector3 center = weighted(active.Weights, active.Centers);
  Points shape = alignedBlend(active).rowwise() - center.transpose();
  const Wanted wanted = wantedTriangles(active, sphere, steps.next());

  steps.next();
  const Points cotangents = cotangentsOf(wanted);
  const EdgeWeights weights = cotangentWeights(triangles, sphere.Positions.rows(), cotangents);
  Columns correction = edgeForces(triangles, sphere.Positions.rows(), cotangents,
    [&](Index r, int k)
    {
      const int a = triangles(r, next(k)), b = triangles(r, previous(k));
      return Vector3(
        wanted[r].col(previous(k)) - wanted[r].col(next(k)) - Vector3(shape.row(b) - shape.row(a)));
    });
  std::vector<double> diagonal(sphere.Positions.rows());
  for (Index v = 0; v < sphere.Positions.rows(); ++v)
  {
    diagonal[v] = weights.sumAt(v);
  }
  diagonal[0] *= 2.0; // fixes vertex 0, since the sum of the forces is 0
  const MultifrontalCholesky solver(weights, diagonal, sphere.Positions, steps.next());
  steps.next();
  solver.solve(correction);
  shape += correction;
  shape *= sizeFactor(shape, active, triangles);
  const Vector3 off = center - Vector3(shape.transpose() * areas / areas.sum());
  shape.rowwise() += off.transpose();
  return shape;
}

void requireShares(const std::vector<double>& weights, std::size_t numberOfShapes)
{
  constexpr double rounding = 1e-9;
  double sum = 0.0;
  bool isGood = weights.size() == numberOfShapes && numberOfShapes > 0;
  for (const double weight : weights)
  {
    isGood = isGood && weight >= 0.0;
    sum += weight;
  }
  if (!isGood || !(std::abs(sum - 1.0) <= rounding))
  {
    throw std::invalid_argument(
      "a morph needs a weight for each shape, at least 0, that add up to 1");
  }
}
}

//------------------------------------------------------------------------------
std::vector<double> morphWeights(double factor, std::size_t numberOfShapes)
{
  if (!(factor >= 0.0 && factor <= 1.0))
  {
    throw std::invalid_argument("the morph factor must be from 0 to 1");
  }
  std::vector<double> weights(numberOfShapes, 0.0);
  const double place = factor * static_cast<double>(numberOfShapes - 1);
  const std::size_t before =
    std::min(static_cast<std::size_t>(place), numberOfShapes > 1 ? numberOfShapes - 2 : 0);
  const double share = place - static_cast<double>(before);
  weights[before] = 1.0 - share;
  if (share > 0.0)
  {
    weights[before + 1] = share;
  }
  return weights;
}

//------------------------------------------------------------------------------
Points morphShapes(const Mesh& sphere, const std::vector<Points>& shapes,
  const std::vector<double>& weights, const SphericalMorphOptions& options, const Run& run)
{
  requireShares(weights, shapes.size());
  const auto whole = std::find(weights.begin(), weights.end(), 1.0);
  if (whole != weights.end())
  {
    run.report(1.0);
    return shapes[whole - weights.begin()];
  }
  const Active active = activeShapes(sphere, shapes, weights);
  if (options.Path == MorphPath::Rigid)
  {
    return rigidBlend(active, sphere, run);
  }
  run.report(1.0);
  return alignedBlend(active);
}

//------------------------------------------------------------------------------
Points rigidMean(const Mesh& sphere, const std::vector<Points>& shapes, const Run& run)
{
  constexpr int maximum = 8;
  constexpr double tolerance = 1e-3;
  if (shapes.empty())
  {
    throw std::invalid_argument("there is no shape to average");
  }
  if (shapes.size() == 1)
  {
    run.report(1.0);
    return shapes.front();
  }
  Steps steps(run, std::vector<double>(maximum, 1.0));
  const std::vector<double> weights(shapes.size(), 1.0 / static_cast<double>(shapes.size()));
  Points mean = rigidBlend(activeShapes(sphere, shapes, weights), sphere, steps.next());
  for (int round = 1; round < maximum; ++round)
  {
    const Active active = activeShapes(sphere, shapes, weights, &mean);
    const Points next = rigidBlend(active, sphere, steps.next());
    const Eigen::RowVector3d center = next.colwise().mean();
    const double change = (next - mean).norm() / (next.rowwise() - center).norm();
    mean = next;
    if (!(change > tolerance))
    {
      break;
    }
  }
  run.report(1.0);
  return mean;
}
}
