/// Compute winding numbers of a cloud of points with normals by a hierarchical sum,
/// \cite Barill2018.

#ifndef ConformalWindingNumbers_h
#define ConformalWindingNumbers_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Winding numbers of a point cloud. At a position, the winding number of a closed surface is 1 if
/// the position is inside, and 0 if it is outside. Each point y_j of the cloud represents a part of
/// the surface. The area vector a_j is the area of this part times the outward unit normal.
/// Following \cite Barill2018, the winding number w at a position x is
///
///     w(x) = sum_j a_j . K(y_j - x),   K(d) = d / (4 pi max(|d|, width)^3)
///
/// The result w(x) is the winding number averaged over a ball of radius `width` around x. The
/// average is smooth near the points. The winding numbers at given positions are a linear function
/// of the area vectors a. Below, A is the matrix of this function, so that A a are the winding
/// numbers.
///
/// Points are grouped into clusters of neighboring points. A distant cluster is added as one point.
/// A cluster is distant from x if two conditions hold:
/// - The distance from x to the center of the cluster's bounding box exceeds twice the longest side
///   of this box.
/// - All points of the cluster are farther from x than `width`.
///
/// The resulting error of w is a few thousandths. The cost for one position is logarithmic in the
/// number of points. Results have the same bits for any number of threads.
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

  /// Compute the negative gradient of the winding number at the points of the cloud. If the area
  /// vectors are approximately correct, the negative gradient points outward.
  Points descentAtPoints(const Points& areas, double width, const Run& run = {}) const;

  /// Multiply the transpose of A by given values, one for each point. Here A is the matrix for
  /// winding numbers at the points of the cloud.
  Points transposed(const Eigen::VectorXd& values, double width, const Run& run = {}) const;

  /// Term of the sum for w(x): a point, or a cluster of points.
  struct Source
  {
    Eigen::Vector3f Position, Strength;
  };
  /// Terms of the sum for w(x): all points and all clusters, for given area vectors.
  struct Sources
  {
    std::vector<Source> OfPoints, OfClusters;
  };
  Sources sources(const Points& areas) const;

  /// Compute winding numbers at any positions. The positions of each block of 64 consecutive ones
  /// should be close together, since distant clusters are selected once per block.
  /// @param[in] sources  result of sources() for the area vectors
  Eigen::VectorXd at(
    const Points& places, const Sources& sources, double width, const Run& run = {}) const;

private:
  // Cluster of points. Clusters are stored in depth-first order: the first child of a cluster
  // follows the cluster.
  struct Cluster
  {
    Vector3 Center;        ///< center of the bounding box
    double HalfSide = 0.0; ///< half of the longest side of the bounding box
    /// Range [First, Last) of indices into Order: these entries are the ids of the points of the
    /// cluster
    int First = 0, Last = 0;
    int Next = 0; ///< index of the next cluster that is not part of this cluster
    bool Leaf = false;
  };
  template <typename Strengths>
  Sources sourcesOf(const Strengths& strengths) const;
  void gather(const Sources& sources, const Vector3& lower, const Vector3& upper, double width,
    std::vector<Source>& list) const;
  template <typename Sum>
  void sumAtPoints(const Sources& sources, double width, const Run& run, const Sum& sum) const;

  Points Places;
  std::vector<int> Order; ///< ids of the points; the points of each cluster are consecutive
  std::vector<Cluster> Clusters;
  /// Indices of disjoint clusters that together contain all points. Sums at the points of each of
  /// these clusters are evaluated together.
  std::vector<int> Groups;
};
}

#endif
