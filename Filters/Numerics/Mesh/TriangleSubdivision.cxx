#include "Mesh/TriangleSubdivision.h"

#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
/// Ids of the points of a triangle cut into k x k. Point (i, j) is i steps towards corner 1 and j
/// steps towards corner 2 from corner 0.
class CutTriangle
{
public:
  /// @param[in] firstOnEdge  id of the first point on each edge (n, n + 1 mod 3)
  CutTriangle(int subdivisions, const int* corners, const int* firstOnEdge, int firstInside)
    : K(subdivisions)
    , Corners(corners)
    , FirstOnEdge(firstOnEdge)
    , FirstInside(firstInside)
  {
  }

  int id(int i, int j) const
  {
    const int k = this->K, rest = k - i - j;
    if (rest == k || i == k || j == k)
    {
      return this->Corners[rest == k ? 0 : i == k ? 1 : 2];
    }
    if (j == 0)
    {
      return this->onEdge(0, i);
    }
    if (rest == 0)
    {
      return this->onEdge(1, j);
    }
    if (i == 0)
    {
      return this->onEdge(2, rest);
    }
    // Row j holds k - 1 - j points.
    return this->FirstInside + (j - 1) * (k - 1) - j * (j - 1) / 2 + i - 1;
  }

private:
  /// Return the point at a number of steps from the start of an edge.
  int onEdge(int edge, int step) const
  {
    const bool ascends = this->Corners[edge] < this->Corners[next(edge)];
    return this->FirstOnEdge[edge] + (ascends ? step : this->K - step) - 1;
  }

  int K;
  const int *Corners, *FirstOnEdge;
  int FirstInside;
};

/// Compute the id of the first point on each edge of each triangle, equal from both sides. Ids
/// start at a given number. Also return the number of all points up to those on edges.
Triangles numberEdges(const Triangles& triangles, const Triangles& neighbors, int perEdge,
  Index numberOfVertices, Index& free)
{
  Triangles first(triangles.rows(), 3);
  free = numberOfVertices;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int other = neighbors(r, k);
      if (other < 0 || other > r)
      {
        first(r, k) = static_cast<int>(free);
        free += perEdge;
        continue;
      }
      for (int m = 0; m < 3; ++m)
      {
        if (triangles(other, m) == triangles(r, next(k)) &&
          triangles(other, next(m)) == triangles(r, k))
        {
          first(r, k) = first(other, m);
        }
      }
    }
  }
  return first;
}
}

//------------------------------------------------------------------------------
Mesh subdivide(const Mesh& mesh, int subdivisions, const Run& run)
{
  if (subdivisions < 1)
  {
    throw std::invalid_argument("the number of subdivisions must be at least 1");
  }
  const int k = subdivisions;
  const double size = static_cast<double>(mesh.Triangles.rows()) * k * k;
  if (size > std::numeric_limits<int>::max())
  {
    throw std::invalid_argument(
      "the mesh would have more triangles than fit into an int; use fewer subdivisions");
  }
  const Triangles neighbors = triangleNeighbors(mesh.Triangles, mesh.Positions.rows(), run);
  Index free = 0;
  const Triangles firstOnEdge =
    numberEdges(mesh.Triangles, neighbors, k - 1, mesh.Positions.rows(), free);
  const Index inside = Index(k - 1) * (k - 2) / 2;
  const Index firstInside = free;

  Mesh fine;
  fine.Positions.resize(firstInside + inside * mesh.Triangles.rows(), 3);
  fine.Positions.topRows(mesh.Positions.rows()) = mesh.Positions;
  fine.Triangles.resize(mesh.Triangles.rows() * k * k, 3);
  const auto cut = [&](Index r)
  {
    const int* corners = mesh.Triangles.data() + 3 * r;
    const int* edges = firstOnEdge.data() + 3 * r;
    const CutTriangle triangle(k, corners, edges, static_cast<int>(firstInside + inside * r));
    for (int edge = 0; edge < 3; ++edge) // owned by the triangle of lower id, from the vertex of
                                         // lower id
    {
      const int from = std::min(corners[edge], corners[next(edge)]),
                to = std::max(corners[edge], corners[next(edge)]);
      for (int step = 1; step < k && !(neighbors(r, edge) >= 0 && neighbors(r, edge) < r); ++step)
      {
        fine.Positions.row(edges[edge] + step - 1) =
          ((k - step) * mesh.Positions.row(from) + step * mesh.Positions.row(to)) / k;
      }
    }
    for (int j = 1; j < k; ++j)
    {
      for (int i = 1; i + j < k; ++i)
      {
        fine.Positions.row(triangle.id(i, j)) =
          ((k - i - j) * mesh.Positions.row(corners[0]) + i * mesh.Positions.row(corners[1]) +
            j * mesh.Positions.row(corners[2])) /
          k;
      }
    }
    Index face = r * k * k;
    for (int j = 0; j < k; ++j)
    {
      for (int i = 0; i + j < k; ++i)
      {
        fine.Triangles.row(face++) << triangle.id(i, j), triangle.id(i + 1, j),
          triangle.id(i, j + 1);
        if (i + j + 1 < k)
        {
          fine.Triangles.row(face++) << triangle.id(i + 1, j), triangle.id(i + 1, j + 1),
            triangle.id(i, j + 1);
        }
      }
    }
  };
  const Index blockSize = std::max<Index>(1, 1024 / (Index(k) * k));
  forBlocksReporting(run, mesh.Triangles.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        cut(r);
      }
    });
  return fine;
}

//------------------------------------------------------------------------------
int subdivisionsFor(Index numberOfVertices, double numberOfPoints)
{
  const double ratio =
    (numberOfPoints - 2.0) / static_cast<double>(std::max<Index>(1, numberOfVertices - 2));
  return static_cast<int>(std::max(1.0, std::ceil(std::sqrt(std::max(0.0, ratio)))));
}
}
