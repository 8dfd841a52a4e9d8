/// Winding numbers of a cloud of oriented points, by a hierarchical sum over the cloud, \cite
/// Barill2018.

#ifndef ConformalWindingNumbers_h
#define ConformalWindingNumbers_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Winding number of a cloud. The winding number of a surface is 1 inside and 0 outside. Points y_j
/// with area vectors a_j (area times outward unit normal) represent elements of the surface:
///
///     w(x) = sum_j a_j . K(y_j - x),   K(d) = d / (4 pi max(|d|, width)^3)
///
/// \cite Barill2018. This is the winding number of the surface averaged over balls of radius
/// `width`, which is smooth near the points. It is linear in the area vectors; the linear map is
/// called A below.
///
/// A cluster of points contributes as a whole beyond four times half its longest side. The error is
/// a few thousandths. The cost of the sum at one position is logarithmic in the number of points.
/// The order of addition is fixed, so results have the same bits for any number of threads.
class WindingNumbers
{
public:
  WindingNumbers() = default;

  /// Build the hierarchy of clusters.
  /// @param[in] points  #P by 3, finite; copied
  explicit WindingNumbers(const Points& points, const Run& run = {});

  const Points& points() const { return this->Places; }
  Index size() const { return this->Places.rows(); }

  /// Compute A a at the points.
  Eigen::VectorXd atPoints(const Points& areas, double width, const Run& run = {}) const;

  /// Compute minus the gradient of A a at the points, which points outward if a is approximately
  /// right.
  Points descentAtPoints(const Points& areas, double width, const Run& run = {}) const;

  /// Compute the transpose of A times values, at the points.
  Points transposed(const Eigen::VectorXd& values, double width, const Run& run = {}) const;

  /// Summand: a point, or a distant cluster of points.
  struct Source
  {
    Eigen::Vector3f Position, Strength;
  };
  /// Summands for given area vectors.
  struct Sources
  {
    std::vector<Source> OfPoints, OfClusters;
  };
  Sources sources(const Points& areas) const;

  /// Compute A a at any positions. Each run of 64 consecutive positions should be close together,
  /// since clusters are selected for a whole run.
  /// @param[in] sources  sources() of the area vectors
  Eigen::VectorXd at(
    const Points& places, const Sources& sources, double width, const Run& run = {}) const;

private:
  // Clusters in depth-first order; the first child of a cluster follows it.
  struct Cluster
  {
    Vector3 Center;          ///< center of the bounding box
    double HalfSide = 0.0;   ///< half the longest side of the bounding box
    int First = 0, Last = 0; ///< points of the cluster: range of positions in Order
    int Next = 0;            ///< next cluster that is not inside this one
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
  /// Disjoint clusters that contain all points; the points of one are evaluated together
  std::vector<int> Groups;
};
}

#endif
