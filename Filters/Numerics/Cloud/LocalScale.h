/// Local scale of distances between samples and surface, for outlier rejection. Own construction: a
/// scale at each vertex, so that a feature not learned yet is not rejected.

#ifndef ConformalLocalScale_h
#define ConformalLocalScale_h

#include "Base/FixedPointSums.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"

#include <vector>

namespace conformal
{
/// Root mean square distance of the samples around each vertex, over a few rings of neighbors. A
/// sample much farther than this is an outlier. Samples of a feature still to be learned are far
/// together, so they raise the local scale and are kept.
class LocalScale
{
public:
  /// @param[in] outlierRatio  ratio of distance to local scale above which a sample is an outlier
  LocalScale(Index neurons, double outlierRatio);

  /// Test whether a sample is an outlier by the scale of the last update; false before the first
  /// update.
  bool outlying(const FootPoint& foot, const conformal::Triangles& triangles) const;

  /// Add the distance of a sample for the next update.
  void add(const FootPoint& foot, const conformal::Triangles& triangles, double weight);

  /// Update the scale from the distances added since the last update, on all ranks.
  void update(const Adjacency& neighbors, const Reduce& reduce);

private:
  double squareAt(const FootPoint& foot, const conformal::Triangles& triangles) const;

  double OutlierRatio;
  FixedPointSums Sums; ///< weight and weighted square distance of each vertex
  std::vector<double> SquareScale;
};
}

#endif
