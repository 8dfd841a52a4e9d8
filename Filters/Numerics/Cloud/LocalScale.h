/// Compute the typical distance between samples and a mesh at each vertex, the local scale, to
/// reject outliers. Local scales are our own construction. One global scale would reject features
/// that the mesh has not learned yet.

#ifndef ConformalLocalScale_h
#define ConformalLocalScale_h

#include "Base/FixedPointSums.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"

#include <vector>

namespace conformal
{
/// Typical distance of samples from a mesh (local scale) at each vertex. The local scale is the
/// root mean square distance of the samples near the vertex. A sample is near the vertex if the
/// closest triangle of the sample has a corner at most two edges from the vertex. If the distance
/// of a sample is much larger than the local scale, the sample is an outlier. Near a feature that
/// is not learned yet, the distances of many samples are large. These samples increase the local
/// scale, and are therefore not rejected.
class LocalScale
{
public:
  /// @param[in] neurons  number of vertices of the mesh
  /// @param[in] outlierRatio  ratio of distance to local scale above which a sample is an outlier
  LocalScale(Index neurons, double outlierRatio);

  /// Test whether a sample is an outlier, by the local scale of the last update. Before the first
  /// update, no sample is an outlier.
  bool outlying(const FootPoint& foot, const conformal::Triangles& triangles) const;

  /// Add the distance of a sample to the mesh, for the next update.
  void add(const FootPoint& foot, const conformal::Triangles& triangles, double weight);

  /// Compute new local scales from the distances that all ranks (MPI processes) added since the
  /// last update.
  /// @param[in] neighbors  neighbors of each vertex
  void update(const Adjacency& neighbors, const Reduce& reduce);

private:
  double squareAt(const FootPoint& foot, const conformal::Triangles& triangles) const;

  double OutlierRatio;
  FixedPointSums Sums; ///< for each vertex, sum of weights and sum of weighted square distances
  std::vector<double> SquareScale;
};
}

#endif
