/// Edge weights of a triangle mesh: uniform \cite Tutte1963, cotangent and harmonic \cite
/// Pinkall1993.

#ifndef ConformalEdgeWeights_h
#define ConformalEdgeWeights_h

#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Symmetric matrix with one entry for each directed edge: Weights[i] belongs to the edge to
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

/// Assign weight 1 to each edge. A planar map into a convex boundary with these weights never folds
/// \cite Tutte1963.
EdgeWeights equalWeights(const Triangles& triangles, Index numberOfVertices);

/// Compute cotangent weights, half the sum of the cotangents of the angles opposite to each edge.
/// They are the string constants of the harmonic energy \cite Pinkall1993.
/// @param[in] cotangents  #F by 3, of the corners
EdgeWeights cotangentWeights(
  const Triangles& triangles, Index numberOfVertices, const Points& cotangents);

/// String constants of \cite GuYau2002, and the number of edges that break a harmonic map.
struct StringConstants
{
  EdgeWeights Strings;        ///< cotangent weights without triangles of zero area
  Index NumberOfNegative = 0; ///< edges with opposite angles of sum above pi
  Index NumberOfInfinite = 0; ///< edges of triangles of zero area
};
StringConstants harmonicStrings(const Points& points, const Triangles& triangles);

/// Compute twice the area of the triangles around each vertex, six times the area share of the
/// vertex. All values are one if the surface has no area.
Eigen::VectorXd vertexAreas(const Points& points, const Triangles& triangles);

/// Compute the string energy: half the sum of weight times squared edge length.
/// @param[in] places  #V by 3 vertex positions, on the sphere or elsewhere
double stringEnergy(const EdgeWeights& strings, const Points& places);
}

#endif
