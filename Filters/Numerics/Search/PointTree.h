/// Find the nearest points of a point cloud by a k-d tree, \cite Friedman1977.

#ifndef ConformalPointTree_h
#define ConformalPointTree_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Point found by a query, and its square distance from the query point.
struct Neighbor
{
  int Id = -1;
  double SquareDistance = 0.0;

  /// Compare by distance. If distances are equal, compare by id.
  bool operator<(const Neighbor& other) const
  {
    return this->SquareDistance < other.SquareDistance ||
      (this->SquareDistance == other.SquareDistance && this->Id < other.Id);
  }
};

/// K-d tree that finds the exact nearest points of a fixed point cloud.
///
/// The tree is stored as a permutation of the points. Each node is a range of the permuted points.
/// The middle point of a range splits the other points of the range into two smaller ranges. The
/// points need 32 bytes each. The axes of the splits need at most one byte per four points. The
/// cost of a query is about logarithmic in the number of points. Several threads can query
/// concurrently.
class PointTree
{
public:
  PointTree() = default;

  /// @param[in] points  #P by 3 coordinates, which are copied
  /// @throws std::invalid_argument if points are not finite
  explicit PointTree(const PointView& points, const Run& run = {});

  Index size() const { return static_cast<Index>(this->Places.size()); }

  /// Find the k points nearest to x, in ascending order of distance. Points at equal distance are
  /// in ascending order of id.
  ///
  /// @param[in] k          number of points to find, at least 0. If the cloud has fewer points, all
  ///   of them are found.
  /// @param[out] neighbors  points found; previous elements are discarded. Pass the vector of an
  ///   earlier call to avoid allocations.
  void nearest(const Vector3& x, int k, std::vector<Neighbor>& neighbors) const;

  /// Find the point nearest to x. If the cloud is empty, the id is -1.
  Neighbor nearest(const Vector3& x) const;

private:
  struct Place
  {
    Vector3 Position;
    int Id;
  };
  void split(Index node, Index first, Index last, const Run& run);
  template <typename Found>
  void search(const Vector3& x, const Vector3& apart, Index node, Index first, Index last,
    Found& found) const;

  std::vector<Place> Places; ///< points in the sequence of the tree
  /// Axis (0, 1 or 2) of the split at each inner node i. The children of i are 2 i + 1 and 2 i + 2.
  std::vector<unsigned char> Axes;
};
}

#endif
