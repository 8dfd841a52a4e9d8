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

// Return 1 for each of these vertices, and 0 for others.
std::vector<char> marksOf(const std::vector<int>& vertices, Index size)
{
  std::vector<char> marks(size, 0);
  for (const int vertex : vertices)
  {
    marks[vertex] = 1;
  }
  return marks;
}

// Return the marked vertices that are connected to a marked vertex, and remove their marks.
std::vector<int> connectedTo(int vertex, std::vector<char>& marks, const Adjacency& neighbors)
{
  std::vector<int> found = { vertex };
  marks[vertex] = 0;
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    for (const int* j = neighbors.begin(found[k]); j != neighbors.end(found[k]); ++j)
    {
      if (marks[*j])
      {
        marks[*j] = 0;
        found.push_back(*j);
      }
    }
  }
  return found;
}

// Return the area vectors of the triangles between these vertices.
std::vector<Vector3> areaVectorsBetween(
  const std::vector<int>& vertices, const Points& positions, const Triangles& triangles)
{
  const std::vector<char> marks = marksOf(vertices, positions.rows());
  std::vector<Vector3> vectors;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const Eigen::RowVector3i t = triangles.row(r);
    if (marks[t[0]] && marks[t[1]] && marks[t[2]])
    {
      vectors.push_back(areaVector(positions, triangles, r));
    }
  }
  return vectors;
}

// Return the first ring of the sides. Triangles of a mesh of equal sides have the area sqrt(3) / 4
// of a side's square.
int firstRingOfSides(double area, Index triangles, double spacing)
{
  const double side = std::sqrt(4.0 / std::sqrt(3.0) * area / static_cast<double>(triangles));
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
    , Area(surfaceArea(positions, triangles))
    , SidesFrom(firstRingOfSides(this->Area, triangles.rows(), spacing))
  {
  }

  const Adjacency& neighbors() const { return this->Neighbors; }

  std::vector<Base> find(const std::vector<int>& gap, const Run& run) const
  {
    std::vector<Base> bases;
    std::vector<std::vector<int>> parts = this->partsOfBaseSize(gap);
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      Base base;
      base.Vertices = std::move(parts[i]);
      this->addRings(base);
      if (this->isFlat(base))
      {
        this->addRoundedRim(base);
        bases.push_back(std::move(base));
      }
      run.report(static_cast<double>(i + 1) / static_cast<double>(parts.size()));
    }
    return bases;
  }

private:
  // Return the connected parts of a gap whose areas can be that of a base. Uneven points leave many
  // small gaps.
  std::vector<std::vector<int>> partsOfBaseSize(const std::vector<int>& gap) const
  {
    std::vector<char> marks = marksOf(gap, this->Positions.rows());
    std::vector<std::vector<int>> parts;
    std::vector<int> partOf(this->Positions.rows(), -1);
    for (const int vertex : gap)
    {
      if (marks[vertex])
      {
        parts.push_back(connectedTo(vertex, marks, this->Neighbors));
        for (const int member : parts.back())
        {
          partOf[member] = static_cast<int>(parts.size()) - 1;
        }
      }
    }
    std::vector<double> areas(parts.size(), 0.0);
    for (Index r = 0; r < this->Triangulation.rows(); ++r)
    {
      const Eigen::RowVector3i t = this->Triangulation.row(r);
      const int part = partOf[t[0]];
      if (part >= 0 && part == partOf[t[1]] && part == partOf[t[2]])
      {
        areas[part] += areaVector(this->Positions, this->Triangulation, r).norm();
      }
    }
    std::vector<std::vector<int>> result;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (areas[i] >= SmallestArea * this->Spacing * this->Spacing &&
        areas[i] <= LargestArea * this->Area)
      {
        result.push_back(std::move(parts[i]));
      }
    }
    return result;
  }

  void addRings(Base& base) const
  {
    std::vector<char> reached = marksOf(base.Vertices, this->Positions.rows());
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
    std::vector<char> marks = marksOf(border, this->Positions.rows());
    return connectedTo(border.front(), marks, this->Neighbors).size() == border.size();
  }

  bool isFlat(Base& base) const
  {
    const std::vector<int>& border = base.Rings.front();
    if (border.empty() || !this->isOneLoop(border) || !this->isNearPlane(base))
    {
      return false;
    }
    Vector3 outward = Vector3::Zero();
    for (const Vector3& vector :
      areaVectorsBetween(base.Vertices, this->Positions, this->Triangulation))
    {
      outward += vector;
    }
    if (base.Normal.dot(outward) < 0.0)
    {
      base.Normal = -base.Normal;
    }
    std::vector<double> heights;
    heights.reserve(border.size());
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
  const double Area;
  const int SidesFrom; // ring
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
  const std::vector<Vector3> vectors = areaVectorsBetween(base.Vertices, positions, triangles);
  return std::any_of(vectors.begin(), vectors.end(),
    [&](const Vector3& vector) { return !(vector.dot(base.Normal) > 0.0); });
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
  const BaseSearch search(samples, spacing, positions, triangles, run.unwatched());
  Index count = 0;
  for (Base& base : search.find(gap, run.part(0.0, 0.9)))
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
