#include "Learn/Fit/FlatBases.h"

#include "Base/NumericalFailure.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"
#include "Search/PointTree.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr double SmallestArea = 25.0; // squares of the spacing; chance leaves smaller gaps
constexpr double LargestArea = 0.22;  // of the surface; larger parts are sides that nobody saw
// Root mean square distance of the border from the plane: in spacings, and of its shorter width.
constexpr double OffPlane = 1.0, OffPlaneOfWidth = 0.05;
constexpr double BeyondPlane = 2.0, FewBeyond = 5e-4; // spacings, and fraction of the samples
constexpr double Steep = 0.1;                         // cosine of the angle with the plane
constexpr double LevelQuantile = 0.8;                 // of the heights of samples at the border
// Rings of vertices around the border: the sides begin where the surface is not rounded any more,
// at a distance in spacings.
constexpr int FirstOfSides = 2, RingsOfSides = 3, Rounded = 2;
constexpr double DistanceOfSides = 1.5;

// Part of the surface without samples, with the plane of its border.
struct Base
{
  std::vector<int> Vertices;
  std::vector<std::vector<int>> Rings; // of vertices around it; the first is the border
  Vector3 Normal, Center;
  double Level = 0.0;

  double height(const Vector3& x) const { return this->Normal.dot(x - this->Center); }
};

// Triangles of a mesh of equal sides have the area sqrt(3) / 4 of a side's square.
int firstRingOfSides(const Points& positions, const Triangles& triangles, double spacing)
{
  const double area = surfaceArea(positions, triangles) / static_cast<double>(triangles.rows());
  const double side = std::sqrt(4.0 / std::sqrt(3.0) * area);
  constexpr double most = 20.0; // rings, of a mesh with very many vertices
  return std::max(
    FirstOfSides, static_cast<int>(std::ceil(std::min(most, DistanceOfSides * spacing / side))));
}

class BaseSearch
{
public:
  BaseSearch(const Points& samples, double spacing, const Points& positions,
    const Triangles& triangles, const Run& run)
    : Samples(samples)
    , Tree(samples, run)
    , Spacing(spacing)
    , Positions(positions)
    , Triangulation(triangles)
    , Normals(vertexNormals(positions, triangles))
    , Neighbors(vertexNeighbors(triangles, positions.rows()))
    , SidesFrom(firstRingOfSides(positions, triangles, spacing))
    , Marks(positions.rows(), 0)
  {
  }

  const Adjacency& neighbors() const { return this->Neighbors; }

  std::vector<Base> find(const std::vector<int>& gap)
  {
    for (const int vertex : gap)
    {
      this->Marks[vertex] = Gap;
    }
    std::vector<Base> bases;
    for (const int vertex : gap)
    {
      if (this->Marks[vertex] == Gap)
      {
        Base base;
        base.Vertices = this->connected(vertex, Gap);
        this->addRings(base);
        if (this->isFlat(base))
        {
          this->addRoundedRim(base);
          bases.push_back(std::move(base));
        }
      }
    }
    return bases;
  }

private:
  enum Mark : char
  {
    Other,
    Gap,
    Seen
  };

  // Return the vertices with a mark that are connected to a vertex, and mark them as seen.
  std::vector<int> connected(int vertex, char mark)
  {
    std::vector<int> found = { vertex };
    this->Marks[vertex] = Seen;
    for (std::size_t k = 0; k < found.size(); ++k)
    {
      for (const int* j = this->Neighbors.begin(found[k]); j != this->Neighbors.end(found[k]); ++j)
      {
        if (this->Marks[*j] == mark)
        {
          this->Marks[*j] = Seen;
          found.push_back(*j);
        }
      }
    }
    return found;
  }

  void addRings(Base& base) const
  {
    std::vector<char> reached(this->Marks.size(), 0);
    for (const int vertex : base.Vertices)
    {
      reached[vertex] = 1;
    }
    std::vector<int> last = base.Vertices;
    for (int ring = 0; ring < this->SidesFrom + RingsOfSides; ++ring)
    {
      std::vector<int> next;
      for (const int vertex : last)
      {
        for (const int* j = this->Neighbors.begin(vertex); j != this->Neighbors.end(vertex); ++j)
        {
          if (!reached[*j])
          {
            reached[*j] = 1;
            next.push_back(*j);
          }
        }
      }
      base.Rings.push_back(next);
      last.swap(next);
    }
  }

  bool isOneLoop(const std::vector<int>& border) const
  {
    std::vector<char> unseen(this->Marks.size(), 0);
    for (const int vertex : border)
    {
      unseen[vertex] = 1;
    }
    std::vector<int> front = { border.front() };
    unseen[border.front()] = 0;
    std::size_t count = 0;
    while (!front.empty())
    {
      const int i = front.back();
      front.pop_back();
      ++count;
      for (const int* j = this->Neighbors.begin(i); j != this->Neighbors.end(i); ++j)
      {
        if (unseen[*j])
        {
          unseen[*j] = 0;
          front.push_back(*j);
        }
      }
    }
    return count == border.size();
  }

  double areaOf(const std::vector<int>& vertices, Vector3& direction) const
  {
    std::vector<char> marks(this->Marks.size(), 0);
    for (const int vertex : vertices)
    {
      marks[vertex] = 1;
    }
    double area = 0.0;
    direction.setZero();
    for (Index r = 0; r < this->Triangulation.rows(); ++r)
    {
      const Eigen::RowVector3i t = this->Triangulation.row(r);
      if (marks[t[0]] && marks[t[1]] && marks[t[2]])
      {
        const Vector3 vector = areaVector(this->Positions, this->Triangulation, r);
        direction += vector;
        area += vector.norm();
      }
    }
    return area;
  }

  bool isFlat(Base& base) const
  {
    const std::vector<int>& border = base.Rings.front();
    Vector3 outward;
    const double area = this->areaOf(base.Vertices, outward);
    if (border.empty() || area < SmallestArea * this->Spacing * this->Spacing ||
      area > LargestArea * surfaceArea(this->Positions, this->Triangulation) ||
      !this->isOneLoop(border) || !this->isNearPlane(base))
    {
      return false;
    }
    if (base.Normal.dot(outward) < 0.0)
    {
      base.Normal = -base.Normal;
    }
    std::vector<double> heights;
    for (const int vertex : border)
    {
      heights.push_back(
        base.height(this->Samples.row(this->Tree.nearest(this->Positions.row(vertex)).Id)));
    }
    const auto quantile = heights.begin() +
      static_cast<std::ptrdiff_t>(LevelQuantile * static_cast<double>(heights.size()));
    std::nth_element(heights.begin(), quantile, heights.end());
    base.Level = *quantile;
    return this->hasSteepSides(base) && this->isOutermost(base);
  }

  bool isNearPlane(Base& base) const
  {
    const std::vector<int>& border = base.Rings.front();
    const auto size = static_cast<double>(border.size());
    base.Center.setZero();
    for (const int vertex : border)
    {
      base.Center += Vector3(this->Positions.row(vertex)) / size;
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const int vertex : border)
    {
      const Vector3 way = Vector3(this->Positions.row(vertex)) - base.Center;
      spread += way * way.transpose() / size;
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
    axes.computeDirect(spread);
    base.Normal = axes.eigenvectors().col(0);
    const Vector3 widths = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return widths[0] <= OffPlane * this->Spacing + OffPlaneOfWidth * widths[1];
  }

  bool hasSteepSides(const Base& base) const
  {
    double sum = 0.0, count = 0.0;
    for (int ring = this->SidesFrom; ring < this->SidesFrom + RingsOfSides; ++ring)
    {
      for (const int vertex : base.Rings[ring])
      {
        sum += base.Normal.dot(Vector3(this->Normals.row(vertex)));
        count += 1.0;
      }
    }
    return count > 0.0 && sum < Steep * count;
  }

  bool isOutermost(const Base& base) const
  {
    const double limit = base.Level + BeyondPlane * this->Spacing;
    Index beyond = 0;
    for (Index i = 0; i < this->Samples.rows(); ++i)
    {
      beyond += base.height(this->Samples.row(i)) > limit;
    }
    return static_cast<double>(beyond) <= FewBeyond * static_cast<double>(this->Samples.rows());
  }

  // The fitted surface is rounded at the rim: add the vertices beyond the plane.
  void addRoundedRim(Base& base) const
  {
    for (int ring = 0; ring < Rounded; ++ring)
    {
      for (const int vertex : base.Rings[ring])
      {
        if (base.height(this->Positions.row(vertex)) > base.Level)
        {
          base.Vertices.push_back(vertex);
        }
      }
    }
  }

  const Points& Samples;
  const PointTree Tree;
  const double Spacing;
  const Points& Positions;
  const Triangles& Triangulation;
  const Points Normals;
  const Adjacency Neighbors;
  const int SidesFrom; // ring
  std::vector<char> Marks;
};

// Return positions with the vertices of a base on its plane, each at the mean of its neighbors.
Points flattened(
  const Base& base, const Adjacency& neighbors, const Points& positions, const Run& run)
{
  const auto size = static_cast<Index>(base.Vertices.size());
  std::vector<int> unknowns(positions.rows(), -1);
  Points places(size, 3);
  for (int k = 0; k < static_cast<int>(size); ++k)
  {
    unknowns[base.Vertices[k]] = k;
    places.row(k) = positions.row(base.Vertices[k]);
  }
  std::vector<Eigen::Triplet<double>> entries;
  Columns solution = Columns::Zero(size, 3);
  for (int k = 0; k < static_cast<int>(size); ++k)
  {
    const int i = base.Vertices[k];
    entries.emplace_back(k, k, static_cast<double>(neighbors.size(i)));
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      if (unknowns[*j] >= 0)
      {
        entries.emplace_back(k, unknowns[*j], -1.0);
      }
      else
      {
        solution.row(k) += positions.row(*j);
      }
    }
  }
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factorize(matrix, places, 1, run).solve(solution);
  Points moved = positions;
  for (Index k = 0; k < size; ++k)
  {
    const Vector3 x = solution.row(k);
    moved.row(base.Vertices[k]) = x + (base.Level - base.height(x)) * base.Normal;
  }
  return moved;
}

bool isTurnedOver(const Base& base, const Points& positions, const Triangles& triangles)
{
  std::vector<char> marks(positions.rows(), 0);
  for (const int vertex : base.Vertices)
  {
    marks[vertex] = 1;
  }
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    if (marks[triangles(r, 0)] && marks[triangles(r, 1)] && marks[triangles(r, 2)] &&
      !(areaVector(positions, triangles, r).dot(base.Normal) > 0.0))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
Index flattenBases(const Points& samples, const std::vector<int>& gap, double spacing,
  double beyond, Points& positions, const Triangles& triangles, const Run& run)
{
  if (gap.empty() || samples.rows() == 0)
  {
    return 0;
  }
  BaseSearch search(samples, spacing, positions, triangles, run.unwatched());
  Index count = 0;
  for (Base& base : search.find(gap))
  {
    base.Level += beyond;
    try
    {
      Points moved = flattened(base, search.neighbors(), positions, run.unwatched());
      if (!isTurnedOver(base, moved, triangles))
      {
        positions.swap(moved);
        ++count;
      }
    }
    catch (const NumericalFailure&)
    {
      // The base stays as it is.
    }
  }
  run.report(1.0);
  return count;
}
}
