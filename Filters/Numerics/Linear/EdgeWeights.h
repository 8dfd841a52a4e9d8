/// Edge weights of a triangle mesh: equal weights, \cite Tutte1963, and cotangent weights,
/// \cite Pinkall1993.

#ifndef ConformalEdgeWeights_h
#define ConformalEdgeWeights_h

#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Weights of the edges of a mesh, as a symmetric sparse matrix. Each edge has two entries, one for
/// each direction. Weights[i] belongs to the edge from a vertex to its neighbor Neighbors.Ids[i].
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

/// Assign weight 1 to each edge. With these weights, a planar map into a convex boundary never
/// folds, \cite Tutte1963.
EdgeWeights equalWeights(const Triangles& triangles, Index numberOfVertices);

/// Compute cotangent weights: half the sum of the cotangents of the two angles opposite each edge,
/// \cite Pinkall1993. Papers on harmonic maps call them string constants.
/// @param[in] cotangents  #F by 3 cotangents of the angles at the corners
EdgeWeights cotangentWeights(
  const Triangles& triangles, Index numberOfVertices, const Points& cotangents);

/// String constants of \cite GuYau2002, and counts of edges that impair a harmonic map. A string
/// constant is the weight of an edge in the harmonic energy.
struct StringConstants
{
  EdgeWeights Strings;        ///< cotangent weights; triangles of zero area contribute nothing
  Index NumberOfNegative = 0; ///< number of edges whose opposite angles have a sum above pi
  Index NumberOfInfinite = 0; ///< number of edges of triangles with zero area
};
StringConstants harmonicStrings(const Points& points, const Triangles& triangles);

/// Compute twice the area of the triangles around each vertex. If each triangle is divided equally
/// among its vertices, this is six times the area of the vertex. All values are 1 if the surface
/// has no area.
Eigen::VectorXd vertexAreas(const Points& points, const Triangles& triangles);

/// Compute the string energy: half the sum over all edges of weight times squared length.
/// @param[in] places  #V by 3 positions of the vertices, on the sphere or elsewhere
double stringEnergy(const EdgeWeights& strings, const Points& places);
}

#endif
