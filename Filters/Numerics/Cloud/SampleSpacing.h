/// Measure the spacing of samples along the surface that they cover. The measure is our own
/// construction. It also holds for scan lines, whose points are much closer along the lines than
/// across them.

#ifndef ConformalSampleSpacing_h
#define ConformalSampleSpacing_h

#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Search/PointTree.h"

#include <vector>

namespace conformal
{
/// Select samples, evenly spaced in the sequence of the cloud. All ranks return equal points.
/// @param[in] wanted  number of samples to select; all of them if there are fewer
Points selectedSamples(const TrainingSamples& samples, Index wanted);

/// Neighborhood of a point: the smallest ball around it that is known to contain points in all
/// directions along the surface.
struct Neighborhood
{
  double Radius = 0.0; ///< distance of the farthest of the neighbors
  int Count = 0;       ///< number of neighbors in the ball, without the point itself

  /// Return the spacing of points: the side of the square that one of them represents.
  double spacing() const;
};

/// Spacing of points around each of them, in any direction along the surface.
class SampleSpacing
{
public:
  /// @param[in] points  at least 1; must outlive this object
  explicit SampleSpacing(const Points& points)
    : Positions(points)
    , Tree(points)
  {
  }

  const PointTree& tree() const { return this->Tree; }

  /// Find the neighborhood of a point. It has 6 neighbors. If they are nearly collinear, as on a
  /// scan line, it has 24 or 96.
  /// @param[in] around  memory for the neighbors, reused by each call
  Neighborhood at(Index point, std::vector<Neighbor>& around) const;

  /// Return the median of the spacings of a seventh of the points.
  double median() const;

private:
  const Points& Positions;
  PointTree Tree;
};
}

#endif
