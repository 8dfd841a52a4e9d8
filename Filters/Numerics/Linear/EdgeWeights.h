/// Edge weights of a triangle mesh: uniform, cotangent and harmonic.

#ifndef ConformalEdgeWeights_h
#define ConformalEdgeWeights_h

#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// A symmetric matrix of the edges; entry i belongs to the edge to Neighbors.Ids[i].
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

/// One for each edge: with them a planar map into a convex boundary never folds \cite Tutte1963.
EdgeWeights equalWeights(const Triangles& triangles, Index numberOfVertices);

/// Half the sum of the cotangents of the angles opposite to each edge: the string constants of the
/// harmonic energy \cite Pinkall1993.
/// @param[in] cotangents  #F by 3, of the corners
EdgeWeights cotangentWeights(
  const Triangles& triangles, Index numberOfVertices, const Points& cotangents);

/// What Gu and Yau call string constants, and how many of them break a harmonic map.
struct StringConstants
{
  EdgeWeights Strings;        ///< cotangentWeights, triangles without area left out
  Index NumberOfNegative = 0; ///< edges between angles that add up to more than pi
  Index NumberOfInfinite = 0; ///< edges of triangles without area
};
StringConstants harmonicStrings(const Points& points, const Triangles& triangles);

/// Twice the area of the triangles around each vertex, six times its share; all one if the surface
/// has none.
Eigen::VectorXd vertexAreas(const Points& points, const Triangles& triangles);

/// The energy of places on the sphere, or anywhere: half the sum of weight times squared length.
double stringEnergy(const EdgeWeights& strings, const Points& places);
}

#endif
