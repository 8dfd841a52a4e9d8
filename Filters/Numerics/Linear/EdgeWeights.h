/// Compute edge weights of a triangle mesh for harmonic maps. In a harmonic map, the position of
/// each inner vertex is the weighted mean of the positions of its neighbors. The weights are equal,
/// \cite Tutte1963, or cotangent weights, \cite Pinkall1993.

#ifndef ConformalEdgeWeights_h
#define ConformalEdgeWeights_h

#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Weights of the edges of a mesh, stored as a symmetric sparse matrix. Each edge has two entries,
/// one for each direction. The entries of vertex v have the indices i from Neighbors.Offsets[v] to
/// Neighbors.Offsets[v + 1] - 1. Weights[i] is the weight of the edge from v to its neighbor
/// Neighbors.Ids[i].
struct EdgeWeights
{
  Adjacency Neighbors;
  std::vector<double> Weights;

  double sumAt(Index v) const
  {
    double sum = 0.0;
    for (int i = this->Neighbors.Offsets[v]; i < this->Neighbors.Offsets[v + 1]; ++i)
    {
      sum += this->Weights[i];
    }
    return sum;
  }
};

/// Assign weight 1 to each edge. In a harmonic map, the position of each inner vertex is the
/// weighted mean of the positions of its neighbors. With equal weights, a harmonic map of a disk
/// into a convex planar polygon never folds, \cite Tutte1963.
EdgeWeights equalWeights(const Triangles& triangles, Index numberOfVertices);

/// Compute cotangent weights: half the sum of the cotangents of the two angles opposite each edge,
/// \cite Pinkall1993. These weights are called string constants in papers on harmonic maps.
/// @param[in] cotangents  #F by 3 cotangents of the angles at the corners
EdgeWeights cotangentWeights(
  const Triangles& triangles, Index numberOfVertices, const Points& cotangents);

/// Compute the right-hand sides of a Poisson equation with cotangent weights, for vectors that are
/// missing along the edges of triangles: the sum over all edges at a vertex of the edge's share of
/// the weight times the missing vector. The sum of all rows is 0.
/// @param[in] cotangents  #F by 3 cotangents of the angles at the corners
/// @param[in] missing     missing(r, k) is the vector for the edge opposite corner k of triangle r,
///   from corner next(k) to corner previous(k)
/// @return #V by 3
template <typename Missing>
Points edgeForces(const Triangles& triangles, Index numberOfVertices, const Points& cotangents,
  const Missing& missing)
{
  Points forces = Points::Zero(numberOfVertices, 3);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 force = 0.5 * cotangents(r, k) * missing(r, k);
      forces.row(triangles(r, previous(k))) += force;
      forces.row(triangles(r, next(k))) -= force;
    }
  }
  return forces;
}

/// Cotangent weights of a surface, called string constants in \cite GuYau2002. The numbers of edges
/// with negative and with infinite weight are also computed. Negative weights can cause folds of a
/// harmonic map. Infinite weights come from triangles of zero area, which are ignored.
struct StringConstants
{
  EdgeWeights Strings; ///< cotangent weights, without triangles of zero area
  /// Number of edges with negative weight: their opposite angles have a sum above pi
  Index NumberOfNegative = 0;
  Index NumberOfInfinite = 0; ///< number of edges of triangles with zero area
};
StringConstants harmonicStrings(const Points& points, const Triangles& triangles);

/// Compute weights of vertices for means over a surface. The weight of a vertex is twice the total
/// area of its triangles. To get the area of a vertex, a third of the total area of its triangles,
/// divide the weight by 6. If the surface has no area, all weights are 1.
Eigen::VectorXd vertexAreas(const Points& points, const Triangles& triangles);

/// Compute the string energy: half the sum over all edges of the edge's weight times its squared
/// length.
/// @param[in] places  #V by 3 positions of the vertices at which the energy is evaluated, for
///   example on the sphere
double stringEnergy(const EdgeWeights& strings, const Points& places);
}

#endif
