/// Local distance scale of the samples around each neuron, for outlier rejection.

#ifndef ConformalLocalScale_h
#define ConformalLocalScale_h

#include "Base/FixedPointSums.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"

#include <vector>

namespace conformal
{
/// The root mean square distance of the patterns around each neuron, over a few rings. A pattern
/// so much farther than its like around it does not belong to the surface: an outlier. Those of a
/// feature still to be learned lie together and are far together.
class LocalScale
{
public:
  /// @param[in] outlierRatio  how many times as far
  LocalScale(Index neurons, double outlierRatio);

  /// By the distances of the last update; false before the first one.
  bool outlying(const FootPoint& foot, const conformal::Triangles& triangles) const;

  /// Count a pattern for the next update.
  void add(const FootPoint& foot, const conformal::Triangles& triangles, double weight);

  /// Take over the distances that were added since the last time, on all processes.
  void update(const Adjacency& neighbors, const Reduce& reduce);

private:
  double squareAt(const FootPoint& foot, const conformal::Triangles& triangles) const;

  double OutlierRatio;
  FixedPointSums Sums; ///< for each neuron the weight and the weighted square distance
  std::vector<double> SquareScale;
};
}

#endif
