#include "Border/BorderCurve.h"

#include "Border/OpenParts.h"
#include "Cloud/SampleSpacing.h"
#include "Mesh/VertexNormals.h"
#include "Search/PointTree.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace conformal
{
namespace
{
constexpr int Rounds = 5, CoarseRounds = 2;
constexpr Index MinimumNodes = 8;
constexpr int HalfWindow = 3; // nodes
constexpr double Nothing = -std::numeric_limits<double>::infinity();

using Ends = std::pair<int, int>;

Index wrapped(Index i, Index size)
{
  return (i % size + size) % size;
}

/// Points of the scan near the curves, with the area that each of them represents.
struct NearPoints
{
  const Points& Positions;
  std::vector<double> Areas;
  double Spacing = 0.0; ///< median
};

NearPoints measured(const Points& points, const Run& run)
{
  NearPoints near{ points, std::vector<double>(points.rows()) };
  const SampleSpacing spacing(points);
  forBlocks(run, points.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> around;
      for (Index i = begin; i < end; ++i)
      {
        const double side = spacing.at(i, around).spacing();
        near.Areas[i] = side * side;
      }
    });
  std::vector<double> sorted = near.Areas;
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  near.Spacing = std::sqrt(sorted[sorted.size() / 2]);
  return near;
}

double lengthOf(const Points& curve)
{
  double length = 0.0;
  for (Index i = 0; i < curve.rows(); ++i)
  {
    length += (curve.row((i + 1) % curve.rows()) - curve.row(i)).norm();
  }
  return length;
}

/// Return nodes at equal distances along a closed polygon.
Points resampled(const Points& curve, Index count)
{
  const double step = lengthOf(curve) / static_cast<double>(count);
  Points nodes(count, 3);
  double walked = 0.0; // to the begin of segment i
  Index made = 0;
  for (Index i = 0; i < curve.rows() && made < count; ++i)
  {
    const Vector3 a = curve.row(i), b = curve.row((i + 1) % curve.rows());
    const double length = (b - a).norm();
    for (; made < count && static_cast<double>(made) * step <= walked + length; ++made)
    {
      const double t = length > 0.0 ? (static_cast<double>(made) * step - walked) / length : 0.0;
      nodes.row(made) = a + t * (b - a);
    }
    walked += length;
  }
  for (; made < count; ++made) // rounding
  {
    nodes.row(made) = curve.row(0);
  }
  return nodes;
}

/// Move nodes to the surface, and compute normals and outward vectors.
BorderCurve onSurface(const Points& nodes, const BorderSurface& surface, const Run& run)
{
  const Index size = nodes.rows();
  BorderCurve curve{ Points(size, 3), Points(size, 3), Points(size, 3) };
  forBlocks(run, size, HeavyBlock,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        const FootPoint foot = surface.Tree.closestPoint(nodes.row(i), hint);
        hint = foot.Triangle;
        curve.Positions.row(i) = foot.Position;
        Vector3 normal = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
        {
          normal +=
            foot.Barycentric[k] * surface.VertexNormals.row(surface.Mesh.Triangles(hint, k));
        }
        curve.Normals.row(i) = normal.stableNormalized();
      }
    });
  for (Index i = 0; i < size; ++i)
  {
    const Vector3 along =
      curve.Positions.row((i + 1) % size) - curve.Positions.row((i + size - 1) % size);
    curve.Outward.row(i) = along.cross(Vector3(curve.Normals.row(i))).stableNormalized();
  }
  return curve;
}

/// The two largest of some heights.
struct Farthest
{
  double First = Nothing, Second = Nothing;
  void add(double height)
  {
    if (height > this->First)
    {
      this->Second = this->First;
      this->First = height;
    }
    else
    {
      this->Second = std::max(this->Second, height);
    }
  }
};

/// What the points near each node say about the place of the border.
struct Evidence
{
  std::vector<Farthest> Heights; ///< heights of points beyond the curve, negative inside
  std::vector<double> Area;      ///< sum over the points behind the border
  std::vector<int> Count;        ///< number of these points
};

Evidence gatherEvidence(
  const BorderCurve& curve, const NearPoints& points, double reach, const Run& run)
{
  const Index nodes = curve.Positions.rows(), size = points.Positions.rows();
  const PointTree tree(curve.Positions);
  std::vector<std::pair<int, double>> found(size, { -1, 0.0 });
  forBlocks(run, size, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 x = points.Positions.row(i);
        const Neighbor node = tree.nearest(x);
        const Vector3 apart = x - Vector3(curve.Positions.row(node.Id));
        const double height = apart.dot(curve.Outward.row(node.Id));
        const double above = apart.dot(curve.Normals.row(node.Id));
        if (node.SquareDistance <= reach * reach && std::abs(above) <= 0.6 * reach)
        {
          found[i] = { node.Id, height };
        }
      }
    });
  Evidence evidence{ std::vector<Farthest>(nodes), std::vector<double>(nodes, 0.0),
    std::vector<int>(nodes, 0) };
  for (Index i = 0; i < size; ++i)
  {
    const auto [node, height] = found[i];
    if (node >= 0)
    {
      evidence.Heights[node].add(height);
      if (height < -2.0 * points.Spacing)
      {
        evidence.Area[node] += points.Areas[i];
        ++evidence.Count[node];
      }
    }
  }
  return evidence;
}

/// Return by how much each node is moved outward.
std::vector<double> movesOf(
  const Evidence& evidence, const NearPoints& points, double step, double reach)
{
  const auto size = static_cast<Index>(evidence.Heights.size());
  const double window = (2 * HalfWindow + 1) * step;
  std::vector<double> moves(size);
  for (Index i = 0; i < size; ++i)
  {
    Farthest farthest;
    double area = points.Spacing * points.Spacing;
    int count = 1;
    for (int k = -HalfWindow; k <= HalfWindow; ++k)
    {
      const Index j = wrapped(i + k, size);
      farthest.add(evidence.Heights[j].First);
      farthest.add(evidence.Heights[j].Second);
      area += evidence.Area[j];
      count += evidence.Count[j];
    }
    moves[i] = std::clamp(farthest.Second + 2.0 * area / count / window, -0.5 * reach, 0.5 * reach);
  }
  return moves;
}

/// Fit a smoothing spline to the nodes of a closed curve: minimize the square distances from the
/// nodes plus `stiffness` times the square second differences.
Points smoothed(const Points& nodes, double stiffness)
{
  const Index size = nodes.rows();
  const std::array<double, 5> row{ stiffness, -4.0 * stiffness, 1.0 + 6.0 * stiffness,
    -4.0 * stiffness, stiffness };
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < size; ++i)
  {
    for (int k = 0; k < 5; ++k)
    {
      entries.emplace_back(i, wrapped(i + k - 2, size), row[k]);
    }
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  return Points(factors.solve(Columns(nodes)));
}

BorderCurve fitBorder(
  const BorderCurve& border, const BorderSurface& surface, const NearPoints& points, const Run& run)
{
  constexpr double waves = 16.0, pi2 = 2.0 * Pi;
  constexpr Index maximumNodes = 200000;
  const double coarse = reachOfFit(surface, points.Spacing), fine = 6.0 * points.Spacing;
  BorderCurve curve = onSurface(border.Positions, surface, run);
  for (int round = 0; round < Rounds; ++round)
  {
    const double length = lengthOf(curve.Positions);
    const double nodes = std::min(length / points.Spacing, static_cast<double>(maximumNodes));
    if (!(nodes >= static_cast<double>(MinimumNodes)))
    {
      break;
    }
    const auto count = static_cast<Index>(nodes);
    const double step = length / static_cast<double>(count);
    const double reach = round < CoarseRounds ? coarse : std::min(fine, coarse);
    curve = onSurface(resampled(curve.Positions, count), surface, run);
    const std::vector<double> moves =
      movesOf(gatherEvidence(curve, points, reach, run), points, step, reach);
    Points moved = curve.Positions;
    for (Index i = 0; i < count; ++i)
    {
      moved.row(i) += moves[i] * curve.Outward.row(i);
    }
    const double cutoff = waves * points.Spacing / (pi2 * step);
    curve = onSurface(smoothed(moved, std::pow(cutoff, 4)), surface, run);
  }
  return curve;
}
}

//------------------------------------------------------------------------------
std::vector<BorderCurve> firstBorders(
  const Mesh& mesh, const std::vector<char>& open, const std::vector<double>& support)
{
  constexpr double middle = 0.5;
  std::map<Ends, Ends> following; // crossed edges, in the sequence of the curve
  for (Index f = 0; f < mesh.Triangles.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = mesh.Triangles(f, k), b = mesh.Triangles(f, next(k)),
                c = mesh.Triangles(f, previous(k));
      if (open[a] != open[b] && open[a] != open[c])
      {
        const Ends first = std::minmax(a, b), last = std::minmax(a, c);
        following[open[a] ? last : first] = open[a] ? first : last;
      }
    }
  }
  std::vector<BorderCurve> borders;
  while (!following.empty())
  {
    std::vector<Vector3> nodes;
    for (auto at = following.begin(); at != following.end();)
    {
      const auto [ends, after] = *at;
      const double a = support[ends.first] - HalfSupport, b = support[ends.second] - HalfSupport;
      const double t = a * b < 0.0 ? std::clamp(a / (a - b), 0.1, 0.9) : middle;
      nodes.push_back(
        (1.0 - t) * mesh.Positions.row(ends.first) + t * mesh.Positions.row(ends.second));
      following.erase(at);
      at = following.find(after);
    }
    BorderCurve curve;
    curve.Positions.resize(static_cast<Index>(nodes.size()), 3);
    for (Index i = 0; i < curve.Positions.rows(); ++i)
    {
      curve.Positions.row(i) = nodes[i];
    }
    borders.push_back(std::move(curve));
  }
  return borders;
}

//------------------------------------------------------------------------------
BorderSurface::BorderSurface(const conformal::Mesh& mesh, const Run& run)
  : Mesh(mesh)
  , Tree(mesh.Positions, mesh.Triangles, run.unwatched())
  , VertexNormals(vertexNormals(mesh.Positions, mesh.Triangles))
{
  double sum = 0.0;
  for (Index f = 0; f < mesh.Triangles.rows(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum +=
        (mesh.Positions.row(mesh.Triangles(f, next(k))) - mesh.Positions.row(mesh.Triangles(f, k)))
          .norm();
    }
  }
  this->EdgeLength = sum / static_cast<double>(std::max<Index>(3 * mesh.Triangles.rows(), 1));
}

//------------------------------------------------------------------------------
double reachOfFit(const BorderSurface& surface, double spacing)
{
  return 3.0 * surface.EdgeLength + 4.0 * spacing;
}

//------------------------------------------------------------------------------
std::vector<BorderCurve> fitBorders(const std::vector<BorderCurve>& borders,
  const BorderSurface& surface, const Points& points, const Run& run)
{
  std::vector<BorderCurve> fitted;
  if (points.rows() == 0)
  {
    for (const BorderCurve& border : borders)
    {
      fitted.push_back(onSurface(border.Positions, surface, run));
    }
    return fitted;
  }
  const NearPoints near = measured(points, run);
  for (const BorderCurve& border : borders)
  {
    run.report(static_cast<double>(fitted.size()) / static_cast<double>(borders.size()));
    fitted.push_back(fitBorder(border, surface, near, run.unwatched()));
  }
  run.report(1.0);
  return fitted;
}
}
