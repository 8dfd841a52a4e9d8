/// Nearest points of a cloud by a k-d tree, \cite Friedman1977.

#ifndef ConformalPointTree_h
#define ConformalPointTree_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Point of a cloud and its square distance from the query point.
struct Neighbor
{
  int Id = -1;
  double SquareDistance = 0.0;

  /// Compare by distance, then by id.
  bool operator<(const Neighbor& other) const
  {
    return this->SquareDistance < other.SquareDistance ||
      (this->SquareDistance == other.SquareDistance && this->Id < other.Id);
  }
};

/// K-d tree that finds exact nearest points of a fixed cloud.
///
/// The tree is a permutation of the points. The middle point of each range splits the other points
/// of this range into two smaller ranges. Each point is stored with its id in 32 bytes. The split
/// axes need one byte for every four or more points. The cost of a query is about logarithmic in
/// #P. Several threads may query concurrently.
class PointTree
{
public:
  PointTree() = default;

  /// @param[in] points  #P by 3 coordinates, copied
  /// @throws std::invalid_argument if points are not finite
  explicit PointTree(const PointView& points, const Run& run = {});

  Index size() const { return static_cast<Index>(this->Places.size()); }

  /// Find the k points nearest to x. The nearest point comes first; of points at equal distance,
  /// the smallest id comes first.
  ///
  /// @param[in] k          number of points to find, at least 0; all points are returned if there
  ///   are fewer
  /// @param[out] neighbors  points found; replaced. Pass the same vector again to avoid
  ///   allocations.
  void nearest(const Vector3& x, int k, std::vector<Neighbor>& neighbors) const;

  /// Find the point nearest to x. Its id is -1 if the cloud is empty.
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

  std::vector<Place> Places; ///< points in the order of the tree
  /// Split axis of each inner node i, whose children are 2 i + 1 and 2 i + 2
  std::vector<unsigned char> Axes;
};
}

#endif
