#include "Learn/Fit/SurfaceSupport.h"

#include "Cloud/SampleRotation.h"
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

/// Select the given number of patterns, evenly spaced; all ranks return equal ones.
Points selection(const TrainingSamples& samples, Index wanted)
{
  SampleRotation rotation(samples, 1);
  rotation.turn(wanted);
  std::vector<double> own;
  for (Index i = 0; i < rotation.count(); ++i)
  {
    const Vector3 x = samples[rotation.id(i)];
    own.insert(own.end(), x.data(), x.data() + 3);
  }
  const std::vector<double> all = gather(samples.reduce(), own);
  return Eigen::Map<const Points>(all.data(), static_cast<Index>(all.size()) / 3, 3);
}
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
        farFromPatterns(positions, bare, selection(samples, PatternsPerNeuron * positions.rows())));
}

namespace
{
/// Spacing of patterns around one of them, in any direction along the surface.
class PatternSpacing
{
public:
  explicit PatternSpacing(const Points& patterns)
    : Patterns(patterns)
    , Tree(patterns)
  {
  }

  Neighbor nearest(const Vector3& place) const { return this->Tree.nearest(place); }

  double at(Index pattern, std::vector<Neighbor>& around) const
  {
    // On a scan line, the nearest patterns are collinear: increase their number until some lie
    // beside the line.
    constexpr int minimum = 6, maximum = 6 * 4 * 4 * 2, growth = 4;
    constexpr double flattest = 0.03; // of the widths' squares
    const Vector3 place = this->Patterns.row(pattern);
    double spacing = 0.0;
    for (int count = minimum; count <= maximum; count *= growth)
    {
      this->Tree.nearest(place, count + 1, around);
      Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
      for (const Neighbor& neighbor : around)
      {
        const Vector3 way = Vector3(this->Patterns.row(neighbor.Id)) - place;
        spread += way * way.transpose();
      }
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
      axes.computeDirect(spread, Eigen::EigenvaluesOnly);
      spacing = std::sqrt(around.back().SquareDistance);
      if (axes.eigenvalues()[1] >= flattest * axes.eigenvalues()[2])
      {
        break;
      }
    }
    return spacing;
  }

private:
  const Points& Patterns;
  PointTree Tree;
};

/// Return a smooth step from 1 at 0 to 0 at 1 and beyond, with zero derivatives at both.
double fall(double x)
{
  const double t = std::clamp(x, 0.0, 1.0);
  return 1.0 - t * t * (3.0 - 2.0 * t);
}
}

std::vector<double> supportOfVertices(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const Run& run)
{
  constexpr double near = 2.0, far = 4.0; // spacings
  constexpr double widest = 4.0;          // maximum in typical spacings; larger ones are outliers
  constexpr int smoothings = 2;
  constexpr Index blockSize = 256;
  const Index size = positions.rows();
  const Points patterns = selection(samples, PatternsPerNeuron * size);
  const PatternSpacing spacing(patterns);
  std::vector<double> distances(size), spacings(size), support(size), smoother(size);
  forBlocksReporting(run, size, blockSize,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> around;
      for (Index i = begin; i < end; ++i)
      {
        const Neighbor nearest = spacing.nearest(positions.row(i));
        distances[i] = std::sqrt(nearest.SquareDistance);
        spacings[i] = spacing.at(nearest.Id, around);
      }
    });
  std::vector<double> sorted = spacings;
  std::nth_element(sorted.begin(), sorted.begin() + size / 2, sorted.end());
  const double limit = widest * sorted[size / 2];
  for (Index i = 0; i < size; ++i)
  {
    const double unit = std::min(spacings[i], limit);
    support[i] =
      unit > 0.0 ? fall((distances[i] / unit - near) / (far - near)) : double(distances[i] == 0.0);
  }
  const Adjacency neighbors = vertexNeighbors(triangles, size);
  for (int pass = 0; pass < smoothings; ++pass)
  {
    for (Index i = 0; i < size; ++i)
    {
      double sum = support[i];
      for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
      {
        sum += support[*j];
      }
      smoother[i] = sum / (1.0 + neighbors.size(i));
    }
    support.swap(smoother);
  }
  return support;
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
