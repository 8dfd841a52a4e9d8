/// Local scale of the distances between samples and surface, to reject outliers. Own construction:
/// one scale per vertex, because a global scale would reject features that are not learned yet.

#ifndef ConformalLocalScale_h
#define ConformalLocalScale_h

#include "Base/FixedPointSums.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"

#include <vector>

namespace conformal
{
/// Local scale at each vertex: the root mean square distance of the samples around the vertex and a
/// few rings of its neighbors. A sample much farther from the surface than this is an outlier.
/// Where a feature is not learned yet, many samples are far from the surface. They increase the
/// local scale, so that they are kept.
class LocalScale
{
public:
  /// @param[in] outlierRatio  ratio of distance to local scale above which a sample is an outlier
  LocalScale(Index neurons, double outlierRatio);

  /// Test whether a sample is an outlier by the scale of the last update. Before the first update,
  /// no sample is an outlier.
  bool outlying(const FootPoint& foot, const conformal::Triangles& triangles) const;

  /// Add the distance of a sample, to be used in the next update.
  void add(const FootPoint& foot, const conformal::Triangles& triangles, double weight);

  /// Update the scale from the distances that all ranks added since the last update.
  void update(const Adjacency& neighbors, const Reduce& reduce);

private:
  double squareAt(const FootPoint& foot, const conformal::Triangles& triangles) const;

  double OutlierRatio;
  FixedPointSums Sums; ///< sums of weights and of weighted square distances, at each vertex
  std::vector<double> SquareScale;
};
}

#endif
