#include "Learn/Fit/SurfaceSupport.h"

#include "Cloud/SampleSpacing.h"
#include "Search/PointTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr Index PatternsPerNeuron = 4; ///< patterns tested for visibility of a part of the surface

/// Test for surface points between rows of patterns.
class Rows
{
public:
  Rows(const Points& patterns, const PointTree& tree)
    : Patterns(patterns)
    , Tree(tree)
  {
  }

  /// Return whether a point lies between rows of patterns at their usual spacing. The gap behind
  /// the nearest pattern is then as wide as that before it, and the surface is flat around both.
  /// This holds between scan lines, and in the middle of faces with vertices concentrated at their
  /// edges.
  bool areAround(const Vector3& place)
  {
    const Vector3 x = this->Patterns.row(this->Tree.nearest(place).Id);
    if (this->goOn(place, x))
    {
      return true;
    }
    const Vector3 across = this->Patterns.row(this->Tree.nearest(2.0 * place - x).Id);
    return across != x && this->goOn(place, across);
  }

private:
  bool goOn(const Vector3& place, const Vector3& x)
  {
    constexpr int maximum = 256;  // maximum number of patterns within reach of a row
    constexpr double reach = 2.5; // distances
    constexpr double cone = 0.7, tangential = 0.5, thickness = 0.3, asNear = 1.5;
    const Vector3 apart = place - x;
    const double distance = apart.norm();
    this->Tree.nearest(x, maximum, this->Around);
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Neighbor& neighbor : this->Around)
    {
      if (neighbor.SquareDistance > reach * reach * distance * distance)
      {
        break;
      }
      const Vector3 d = Vector3(this->Patterns.row(neighbor.Id)) - x;
      spread += d * d.transpose();
      const double length = d.norm();
      if (length < asNear * distance && -d.dot(apart) > cone * distance * length)
      {
        return false; // dense behind the pattern
      }
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
    axes.computeDirect(spread);
    const double flatness = thickness * thickness * axes.eigenvalues()[2];
    const bool oneRow = axes.eigenvalues()[1] < flatness; // does not determine a plane
    return oneRow ||
      (axes.eigenvalues()[0] < flatness &&
        std::abs(axes.eigenvectors().col(0).dot(apart)) < tangential * distance);
  }

  const Points& Patterns;
  const PointTree& Tree;
  std::vector<Neighbor> Around;
};
}

std::vector<bool> unsupportedVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses)
{
  constexpr double Enough = 100.0; // patterns expected; far more than random variation needs
  constexpr double Share = 0.25;
  const Index size = positions.rows();

  // Column 0: patterns, column 1: area, a third of each triangle's for each corner.
  Eigen::Matrix<double, Eigen::Dynamic, 2> own =
    Eigen::Matrix<double, Eigen::Dynamic, 2>::Zero(size, 2);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = positions.row(triangles(r, 0)), b = positions.row(triangles(r, 1)),
                  c = positions.row(triangles(r, 2));
    const double area = 0.5 * (b - a).cross(c - a).norm();
    for (int k = 0; k < 3; ++k)
    {
      own.row(triangles(r, k)) += Eigen::RowVector2d(masses[r] / 3.0, area / 3.0);
    }
  }
  const double patterns = own.col(0).sum(), area = own.col(1).sum();
  std::vector<bool> unsupported(size, false);
  if (!(patterns > 0.0 && area > 0.0))
  {
    return unsupported;
  }
  const double density = patterns / area;
  auto gathered = own;
  for (int vertices = 1, ring = 1; vertices * patterns / size < Enough && vertices < size; ++ring)
  {
    auto wider = gathered;
    for (Index i = 0; i < size; ++i)
    {
      for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
      {
        wider.row(i) += gathered.row(*j);
      }
    }
    gathered.swap(wider);
    vertices += 6 * ring;
  }
  for (Index i = 0; i < size; ++i)
  {
    unsupported[i] = gathered(i, 0) < Share * density * gathered(i, 1);
  }
  return unsupported;
}

std::vector<bool> idleVertices(
  const Triangles& triangles, const std::vector<double>& masses, Index numberOfVertices)
{
  constexpr double Share = 0.05;
  std::vector<double> around(numberOfVertices, 0.0);
  double sum = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      around[triangles(r, k)] += masses[r];
      sum += masses[r];
    }
  }
  std::vector<bool> idle(numberOfVertices);
  for (Index i = 0; i < numberOfVertices; ++i)
  {
    idle[i] = around[i] < Share * sum / static_cast<double>(numberOfVertices);
  }
  return idle;
}

std::vector<bool> bareVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses)
{
  std::vector<bool> bare = unsupportedVertices(positions, triangles, neighbors, masses);
  const std::vector<bool> idle = idleVertices(triangles, masses, positions.rows());
  std::vector<int> front;
  for (Index i = 0; i < positions.rows(); ++i)
  {
    if (bare[i])
    {
      front.push_back(static_cast<int>(i));
    }
  }
  while (!front.empty())
  {
    const int i = front.back();
    front.pop_back();
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      if (idle[*j] && !bare[*j])
      {
        bare[*j] = true;
        front.push_back(*j);
      }
    }
  }
  return bare;
}

std::vector<bool> farFromPatterns(
  const Points& positions, const std::vector<bool>& marked, const Points& patterns)
{
  constexpr int NeighborsOfPattern = 6;
  constexpr double Far = 2.0;
  const PointTree tree(patterns);
  Rows rows(patterns, tree);
  std::vector<bool> far(marked.size(), false);
  std::vector<Neighbor> around;
  for (std::size_t i = 0; i < marked.size(); ++i)
  {
    if (marked[i])
    {
      const Vector3 place = positions.row(static_cast<Index>(i));
      const Neighbor nearest = tree.nearest(place);
      tree.nearest(patterns.row(nearest.Id), NeighborsOfPattern + 1, around);
      far[i] =
        nearest.SquareDistance > Far * Far * around.back().SquareDistance && !rows.areAround(place);
    }
  }
  return far;
}

double areaFraction(
  const Points& positions, const Triangles& triangles, const std::vector<bool>& vertices)
{
  double part = 0.0, whole = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = positions.row(triangles(r, 0)), b = positions.row(triangles(r, 1)),
                  c = positions.row(triangles(r, 2));
    const double third = (b - a).cross(c - a).norm() / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      whole += third;
      part += vertices[triangles(r, k)] ? third : 0.0;
    }
  }
  return whole > 0.0 ? part / whole : 0.0;
}

double unsupportedFraction(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const std::vector<double>& masses)
{
  const Adjacency neighbors = vertexNeighbors(triangles, positions.rows());
  const std::vector<bool> bare = bareVertices(positions, triangles, neighbors, masses);
  return std::find(bare.begin(), bare.end(), true) == bare.end()
    ? 0.0
    : areaFraction(positions, triangles,
        farFromPatterns(
          positions, bare, selectedSamples(samples, PatternsPerNeuron * positions.rows())));
}

double obtuseFraction(const Points& positions, const Triangles& triangles)
{
  Index obtuse = 0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Vector3 a = positions.row(triangles(r, 0)), b = positions.row(triangles(r, 1)),
                  c = positions.row(triangles(r, 2));
    obtuse += (b - a).dot(c - a) < 0.0 || (c - b).dot(a - b) < 0.0 || (a - c).dot(b - c) < 0.0;
  }
  return triangles.rows() > 0 ? static_cast<double>(obtuse) / static_cast<double>(triangles.rows())
                              : 0.0;
}
}
