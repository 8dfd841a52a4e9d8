/// Nearest points of a cloud.

#ifndef ConformalPointTree_h
#define ConformalPointTree_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// A point of a cloud, and how far it is.
struct Neighbor
{
  int Id = -1;
  double SquareDistance = 0.0;

  /// Nearer first; of equals, the lowest id.
  bool operator<(const Neighbor& other) const
  {
    return this->SquareDistance < other.SquareDistance ||
      (this->SquareDistance == other.SquareDistance && this->Id < other.Id);
  }
};

/// Exact nearest points of a cloud that rests.
///
/// A k-d tree that is nothing but an order of the points: the middle of each range splits the
/// rest of it in two. It copies the points, 32 bytes each with their ids, and needs a byte for
/// every four or more of them besides. A query costs about log(#P) and only reads, so many threads
/// may ask at once.
class PointTree
{
public:
  PointTree() = default;

  /// @param[in] points  #P by 3
  /// @throws std::invalid_argument if points are not finite
  explicit PointTree(const PointView& points, const Run& run = {});

  Index size() const { return static_cast<Index>(this->Places.size()); }

  /// The k nearest points of x, nearest first; of points equally near, the lowest ids.
  ///
  /// @param[in] k          at least 0; all points where there are fewer
  /// @param[out] neighbors  replaced; given again, it saves allocating
  void nearest(const Vector3& x, int k, std::vector<Neighbor>& neighbors) const;

  /// The nearest point of x; Id -1 for an empty cloud.
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

  std::vector<Place> Places;       ///< in the tree's order
  std::vector<unsigned char> Axes; ///< split inner node i, whose children are 2 i + 1 and 2 i + 2
};
}

#endif
