/// Reject outliers by a local scale: the typical distance between samples and a mesh at each
/// vertex. Local scales are our own construction. A single scale for all vertices would reject
/// samples at features that the mesh has not learned yet.

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
/// triangle closest to the sample has a corner at most two edges from the vertex. If the distance
/// of a sample from the mesh is much larger than the local scale, the sample is an outlier. Near a
/// feature of the cloud that the mesh has not learned yet, the distances of many samples are large.
/// These distances increase the local scale, so that the samples are not rejected.
class LocalScale
{
public:
  /// @param[in] neurons  number of vertices of the mesh
  /// @param[in] outlierRatio  minimum ratio of distance to local scale for which a sample is an
  ///   outlier
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
