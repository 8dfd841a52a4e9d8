/// Merge disjoint sets of ids, and find the set that contains an id. The method is union-find with
/// path halving, \cite Tarjan1984.
#ifndef ConformalDisjointSets_h
#define ConformalDisjointSets_h

#include "Base/Types.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace conformal
{
/// Partition of the ids 0 to size - 1 into sets. Initially each set has one id. Each set is named
/// by one of its ids.
class DisjointSets
{
public:
  explicit DisjointSets(Index size)
    : Parents(static_cast<std::size_t>(size))
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  /// Return the name of the set that contains an id.
  int find(int id)
  {
    while (this->Parents[id] != id)
    {
      id = this->Parents[id] = this->Parents[this->Parents[id]];
    }
    return id;
  }

  /// Merge the two sets that contain ids a and b. The merged set keeps the smaller of the two
  /// names.
  /// @return whether a and b were in different sets
  bool unite(int a, int b)
  {
    a = this->find(a);
    b = this->find(b);
    this->rename(std::max(a, b), std::min(a, b));
    return a != b;
  }

  /// Merge the set named `name` into the set named `newName`.
  void rename(int name, int newName) { this->Parents[name] = newName; }

private:
  std::vector<int> Parents;
};
}

#endif
