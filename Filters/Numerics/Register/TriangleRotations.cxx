#include "Register/TriangleRotations.h"

#include "Base/Steps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>

namespace conformal
{
namespace
{
Eigen::Matrix3d cornersOf(const Points& points, const Triangles& triangles, Index r)
{
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k)
  {
    corners.col(k) = points.row(triangles(r, k));
  }
  return corners;
}

/// Local frame of a triangle. The columns of Frame are two orthonormal tangents and the normal. The
/// columns of Edges are the first two edges, expressed in the tangents.
struct Flat
{
  Eigen::Matrix3d Frame;
  Eigen::Matrix2d Edges;
};

/// Compute the local frame of a triangle.
/// @return false if the triangle has zero area
bool flatten(const Eigen::Matrix3d& corners, Flat& flat)
{
  constexpr double minimumArea = 1e-12; // minimum area, relative to the longest squared edge
  const Vector3 u = corners.col(1) - corners.col(0), v = corners.col(2) - corners.col(0);
  const Vector3 normal = u.cross(v);
  const double area = normal.norm(), length = u.norm();
  if (!(area > minimumArea * std::max(u.squaredNorm(), v.squaredNorm())))
  {
    return false;
  }
  flat.Frame.col(0) = u / length;
  flat.Frame.col(2) = normal / area;
  flat.Frame.col(1) = flat.Frame.col(2).cross(flat.Frame.col(0));
  flat.Edges << length, flat.Frame.col(0).dot(v), 0.0, flat.Frame.col(1).dot(v);
  return true;
}

/// Return the rotation vector closest to another vector. Candidates differ from the shortest
/// rotation vector by full rotations about its axis.
Vector3 closestVector(const Vector3& shortest, const Vector3& other)
{
  const double angle = shortest.norm(), turn = 2.0 * Pi;
  constexpr double noAxis = 1e-9;
  const double otherAngle = other.norm();
  if (angle < noAxis)
  {
    return otherAngle > 0.0 ? Vector3(std::round(otherAngle / turn) * turn / otherAngle * other)
                            : shortest;
  }
  const Vector3 axis = shortest / angle;
  return (angle + turn * std::round((axis.dot(other) - angle) / turn)) * axis;
}

/// Compute a measure that increases with the angle between two rotations.
double differenceOf(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
  return (a - b).squaredNorm();
}

/// Choose rotation vectors that are continuous between neighboring triangles. Triangles are
/// processed from neighbor to neighbor, those with the most similar rotations first.
void followNeighbors(const Triangles& neighbors, const std::vector<Eigen::Matrix3d>& rotations,
  std::vector<Vector3>& vectors, const Run& run)
{
  const auto size = static_cast<Index>(vectors.size());
  constexpr Index reportEvery = 16384;
  using Step = std::tuple<double, int, int>; // difference, triangle, processed neighbor
  std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
  std::vector<char> isDone(size, 0);
  std::vector<int> order(size);
  for (Index r = 0; r < size; ++r)
  {
    order[r] = static_cast<int>(r);
  }
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b) { return vectors[a].squaredNorm() < vectors[b].squaredNorm(); });
  Index done = 0;
  for (const int seed : order) // a connected mesh has a single seed
  {
    if (isDone[seed] == 0)
    {
      steps.emplace(0.0, seed, seed);
    }
    while (!steps.empty())
    {
      const auto [difference, triangle, from] = steps.top();
      steps.pop();
      if (isDone[triangle] != 0)
      {
        continue;
      }
      isDone[triangle] = 1;
      if (triangle != from)
      {
        vectors[triangle] = closestVector(vectors[triangle], vectors[from]);
      }
      for (int k = 0; k < 3; ++k)
      {
        const int neighbor = neighbors(triangle, k);
        if (neighbor >= 0 && isDone[neighbor] == 0)
        {
          steps.emplace(differenceOf(rotations[triangle], rotations[neighbor]), neighbor, triangle);
        }
      }
      if (++done % reportEvery == 0)
      {
        run.report(static_cast<double>(done) / static_cast<double>(size));
      }
    }
  }
}
}

//------------------------------------------------------------------------------
Eigen::Matrix3d rotationOf(const Vector3& rotationVector)
{
  const double angle = rotationVector.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, rotationVector / angle).toRotationMatrix()
                     : Eigen::Matrix3d::Identity();
}

//------------------------------------------------------------------------------
Eigen::Matrix3d triangleRotation(
  const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, const Eigen::Matrix3d& otherwise)
{
  Flat a, b;
  if (!flatten(from, a) || !flatten(to, b))
  {
    return otherwise;
  }
  // Compute the deformation gradient times the determinant of a.Edges, which is above 0.
  Eigen::Matrix2d adjugate;
  adjugate << a.Edges(1, 1), -a.Edges(0, 1), -a.Edges(1, 0), a.Edges(0, 0);
  const Eigen::Matrix2d gradient = b.Edges * adjugate;
  const double angle = std::atan2(gradient(1, 0) - gradient(0, 1), gradient(0, 0) + gradient(1, 1));
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return b.Frame * turn * a.Frame.transpose();
}

//------------------------------------------------------------------------------
std::vector<Vector3> triangleRotations(const Triangles& triangles, const Triangles& neighbors,
  const Points& from, const Points& to, const Vector3& whole, const Run& run)
{
  Steps steps(run, { 0.2, 0.8 });
  const Eigen::Matrix3d turn = rotationOf(whole);
  std::vector<Eigen::Matrix3d> rotations(triangles.rows());
  std::vector<Vector3> vectors(triangles.rows());
  forBlocksReporting(steps.next(), triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        rotations[r] = turn.transpose() *
          triangleRotation(cornersOf(from, triangles, r), cornersOf(to, triangles, r), turn);
        const Eigen::AngleAxisd rest(rotations[r]);
        vectors[r] = rest.angle() * rest.axis();
      }
    });
  followNeighbors(neighbors, rotations, vectors, steps.next());
  return vectors;
}
}
