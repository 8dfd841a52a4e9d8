/// Winding numbers around a cloud of oriented points, summed over all of them at once.

#ifndef ConformalWindingNumbers_h
#define ConformalWindingNumbers_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// The winding number of a surface is 1 inside and 0 outside of it. That of a cloud whose points
/// y_j stand for elements of the surface with area vectors a_j (area times outward unit normal) is
///
///     w(x) = sum_j a_j . K(y_j - x),   K(d) = d / (4 pi max(|d|, width)^3)
///
/// \cite Barill2018, that of the surface averaged over balls with the width for a radius, which is
/// smooth next to the points too. It is linear in the area vectors. Called A below.
///
/// Sums over points far away are taken cluster by cluster, farther than four times half the
/// cluster's largest side: errors are a few thousandths. The cost of a sum at one place grows with
/// the logarithm of the number of points. Sums are added up in one order, so that results have the
/// same bits on any number of threads.
class WindingNumbers
{
public:
  WindingNumbers() = default;

  /// @param[in] points  #P by 3, finite; copied
  explicit WindingNumbers(const Points& points, const Run& run = {});

  const Points& points() const { return this->Places; }
  Index size() const { return this->Places.rows(); }

  /// A a at the points.
  Eigen::VectorXd atPoints(const Points& areas, double width, const Run& run = {}) const;

  /// Minus the gradient of A a at the points: outward, where a is about right.
  Points descentAtPoints(const Points& areas, double width, const Run& run = {}) const;

  /// The transpose of A at the points times values at the points.
  Points transposed(const Eigen::VectorXd& values, double width, const Run& run = {}) const;

  /// What adds to a sum: a point, or a cluster of points seen from afar.
  struct Source
  {
    Eigen::Vector3f Position, Strength;
  };
  /// Those of given area vectors.
  struct Sources
  {
    std::vector<Source> OfPoints, OfClusters;
  };
  Sources sources(const Points& areas) const;

  /// A a at any places. Runs of 64 of them, from the first, should lie close together: what is far
  /// is decided for a run.
  /// @param[in] sources  of the area vectors
  Eigen::VectorXd at(
    const Points& places, const Sources& sources, double width, const Run& run = {}) const;

private:
  // Clusters in depth-first order; the first child of a cluster follows it.
  struct Cluster
  {
    Vector3 Center;          ///< of its box
    double HalfSide = 0.0;   ///< of the largest side
    int First = 0, Last = 0; ///< its points, places in Order
    int Next = 0;            ///< the cluster after it and all that is in it
    bool Leaf = false;
  };
  template <typename Strengths>
  Sources sourcesOf(const Strengths& strengths) const;
  void gather(const Sources& sources, const Vector3& lower, const Vector3& upper, double width,
    std::vector<Source>& list) const;
  template <typename Sum>
  void sumAtPoints(const Sources& sources, double width, const Run& run, const Sum& sum) const;

  Points Places;
  std::vector<int> Order; ///< of the points in the tree
  std::vector<Cluster> Clusters;
  std::vector<int> Groups; ///< clusters of points that ask together; they hold all of them
};
}

#endif
