#include "Border/BorderPolish.h"

#include "Mesh/MeshTopology.h"
#include "Search/PointTree.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr Index PointsPerBlock = 64;
constexpr int Rings = 1;
constexpr int PointsOfFit = 40;
constexpr int MinimumPoints = 12;

/// Vertices within some rings of the border.
std::vector<int> verticesNearBorder(const Mesh& sheet, const Adjacency& neighbors)
{
  std::vector<char> marks(sheet.Positions.rows(), 0);
  std::vector<int> found;
  for (const BorderLoop& loop : borderLoops(sheet))
  {
    for (const int v : loop)
    {
      marks[v] = 1;
      found.push_back(v);
    }
  }
  std::size_t begin = 0;
  for (int ring = 0; ring < Rings; ++ring)
  {
    const std::size_t end = found.size();
    for (; begin < end; ++begin)
    {
      const int v = found[begin];
      for (const int* j = neighbors.begin(v); j != neighbors.end(v); ++j)
      {
        if (!marks[*j])
        {
          marks[*j] = 1;
          found.push_back(*j);
        }
      }
    }
  }
  return found;
}

/// Project x to a quadratic surface through points, in the frame of their principal axes.
Vector3 onQuadric(const Vector3& x, const Points& points, const std::vector<Neighbor>& around)
{
  const double width = 0.5 * around.back().SquareDistance;
  Vector3 center = Vector3::Zero();
  double sum = 0.0;
  std::vector<double> weights;
  for (const Neighbor& neighbor : around)
  {
    weights.push_back(std::exp(-neighbor.SquareDistance / width));
    center += weights.back() * points.row(neighbor.Id).transpose();
    sum += weights.back();
  }
  center /= sum;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < around.size(); ++k)
  {
    const Vector3 d = points.row(around[k].Id).transpose() - center;
    spread += weights[k] * d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Eigen::Matrix3d& frame = axes.eigenvectors(); // columns: normal first
  const double unit = std::sqrt(around.back().SquareDistance);
  using Row = Eigen::Matrix<double, 6, 1>;
  const auto terms = [](double u, double v)
  {
    Row row;
    row << 1.0, u, v, u * u, u * v, v * v;
    return row;
  };
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Row right = Row::Zero();
  for (std::size_t k = 0; k < around.size(); ++k)
  {
    const Vector3 d = frame.transpose() * (points.row(around[k].Id).transpose() - center) / unit;
    const Row row = terms(d[1], d[2]);
    normal += weights[k] * row * row.transpose();
    right += weights[k] * d[0] * row;
  }
  constexpr double bending = 1e-3; // keeps quadratic terms small where points do not determine them
  normal.diagonal().tail<3>().array() += bending * sum;
  const Row solution = normal.ldlt().solve(right);
  Vector3 own = frame.transpose() * (x - center) / unit;
  own[0] = solution.dot(terms(own[1], own[2]));
  return center + unit * (frame * own);
}
}

void polishBorder(
  Points& positions, const Triangles& triangles, const Points& points, const Run& run)
{
  if (points.rows() < MinimumPoints)
  {
    return;
  }
  const Mesh sheet{ positions, triangles };
  const Adjacency neighbors = vertexNeighbors(triangles, positions.rows());
  const std::vector<int> near = verticesNearBorder(sheet, neighbors);
  const PointTree tree(points);
  // Moves in edges: smaller ones are details of the surface, larger ones are errors of the fit.
  constexpr double smallest = 0.15, largest = 1.5;
  forBlocks(run, static_cast<Index>(near.size()), PointsPerBlock,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> around;
      for (Index i = begin; i < end; ++i)
      {
        const int v = near[i];
        const Vector3 x = sheet.Positions.row(v);
        double edge = 0.0;
        for (const int* j = neighbors.begin(v); j != neighbors.end(v); ++j)
        {
          edge += (sheet.Positions.row(*j).transpose() - x).norm() / neighbors.size(v);
        }
        tree.nearest(x, PointsOfFit, around);
        const Vector3 place = onQuadric(x, points, around);
        const double move = (place - x).norm();
        if (move > smallest * edge && move < largest * edge)
        {
          positions.row(v) = place;
        }
      }
    });
}
}
