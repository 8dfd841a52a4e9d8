/// Compute winding numbers of a cloud of oriented points by a hierarchical sum, \cite Barill2018.

#ifndef ConformalWindingNumbers_h
#define ConformalWindingNumbers_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Winding numbers of a cloud. The winding number of a closed surface is 1 inside and 0 outside.
/// Points y_j with area vectors a_j (area times outward unit normal) represent parts of the
/// surface. By the method of \cite Barill2018,
///
///     w(x) = sum_j a_j . K(y_j - x),   K(d) = d / (4 pi max(|d|, width)^3)
///
/// This w(x) is the winding number averaged over a ball of radius `width` around x, so it is smooth
/// near the points. It is linear in the area vectors: below, A a denotes the winding numbers at
/// given positions for area vectors a.
///
/// A distant cluster of points is added as one point. A cluster is distant if its center is farther
/// away than twice its longest side, and the cluster lies beyond `width`. This causes an error of a
/// few thousandths. The cost for one position is logarithmic in the number of points. The order of
/// addition is fixed, so results have the same bits for any number of threads.
class WindingNumbers
{
public:
  WindingNumbers() = default;

  /// Build the hierarchy of clusters.
  /// @param[in] points  #P by 3 coordinates, finite; copied
  explicit WindingNumbers(const Points& points, const Run& run = {});

  const Points& points() const { return this->Places; }
  Index size() const { return this->Places.rows(); }

  /// Compute A a, the winding numbers at the points of the cloud.
  Eigen::VectorXd atPoints(const Points& areas, double width, const Run& run = {}) const;

  /// Compute the negative gradient of the winding number at the points of the cloud. It points
  /// outward if the area vectors are approximately right.
  Points descentAtPoints(const Points& areas, double width, const Run& run = {}) const;

  /// Compute the product of the transpose of A and given values at the points of the cloud.
  Points transposed(const Eigen::VectorXd& values, double width, const Run& run = {}) const;

  /// Term of the sum: a point, or a distant cluster of points.
  struct Source
  {
    Eigen::Vector3f Position, Strength;
  };
  /// Terms of the sum for given area vectors.
  struct Sources
  {
    std::vector<Source> OfPoints, OfClusters;
  };
  Sources sources(const Points& areas) const;

  /// Compute winding numbers at any positions. Each block of 64 consecutive positions should be
  /// close together, since clusters are selected for the whole block.
  /// @param[in] sources  result of sources() for the area vectors
  Eigen::VectorXd at(
    const Points& places, const Sources& sources, double width, const Run& run = {}) const;

private:
  // Cluster of points. Clusters are in depth-first order: the first child of a cluster comes next
  // after it.
  struct Cluster
  {
    Vector3 Center;          ///< center of the bounding box
    double HalfSide = 0.0;   ///< half the longest side of the bounding box
    int First = 0, Last = 0; ///< range of positions in Order: the points of the cluster
    int Next = 0;            ///< index of the next cluster that is not inside this one
    bool Leaf = false;
  };
  template <typename Strengths>
  Sources sourcesOf(const Strengths& strengths) const;
  void gather(const Sources& sources, const Vector3& lower, const Vector3& upper, double width,
    std::vector<Source>& list) const;
  template <typename Sum>
  void sumAtPoints(const Sources& sources, double width, const Run& run, const Sum& sum) const;

  Points Places;
  std::vector<int> Order; ///< order of the points in the tree
  std::vector<Cluster> Clusters;
  /// Disjoint clusters that together contain all points. The points of one such cluster are
  /// evaluated together
  std::vector<int> Groups;
};
}

#endif
