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

  /// Order by distance, then by id.
  bool operator<(const Neighbor& other) const
  {
    return this->SquareDistance < other.SquareDistance ||
      (this->SquareDistance == other.SquareDistance && this->Id < other.Id);
  }
};

/// Exact nearest points of a fixed cloud.
///
/// The k-d tree is an order of the points: the middle of each range splits its other points into
/// two ranges. The tree stores a copy of the points, 32 bytes each with their ids. The split axes
/// need one byte for every four or more points. A query costs about log(#P) and only reads, so
/// several threads may query concurrently.
class PointTree
{
public:
  PointTree() = default;

  /// @param[in] points  #P by 3
  /// @throws std::invalid_argument if points are not finite
  explicit PointTree(const PointView& points, const Run& run = {});

  Index size() const { return static_cast<Index>(this->Places.size()); }

  /// Find the k points nearest to x, nearest first; of equal distances, the smallest id first.
  ///
  /// @param[in] k          at least 0; all points are returned if there are fewer
  /// @param[out] neighbors  replaced; reuse it to avoid allocations
  void nearest(const Vector3& x, int k, std::vector<Neighbor>& neighbors) const;

  /// Find the point nearest to x; the id is -1 for an empty cloud.
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

  std::vector<Place> Places;       ///< in the order of the tree
  std::vector<unsigned char> Axes; ///< split axis of inner node i with children 2 i + 1 and 2 i + 2
};
}

#endif
