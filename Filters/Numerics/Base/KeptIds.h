/// List the ids that pass a test. The list needs only one bit for each tested id.

#ifndef ConformalKeptIds_h
#define ConformalKeptIds_h

#include "Base/Types.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Ascending list of the ids in [0, size) that pass a test. Storage is one bit per tested id. An
/// array of ids would need 64 bits per listed id, too much memory for ten million points.
class KeptIds
{
public:
  KeptIds() = default;

  /// @param[in] size  number of ids to test, starting with id 0
  /// @param[in] keep  test, called once for each id in ascending order
  template <typename Keep>
  KeptIds(Index size, const Keep& keep)
    : Words((size + 63) / 64, 0)
  {
    for (Index id = 0; id < size; ++id)
    {
      if (id % IdsPerBlock == 0)
      {
        this->Before.push_back(this->Size);
      }
      if (keep(id))
      {
        this->Words[id / 64] |= std::uint64_t(1) << (id % 64);
        ++this->Size;
      }
    }
  }

  Index size() const { return this->Size; }

  /// Return the i-th kept id, for i in [0, size()). The cost is logarithmic in the number of ids.
  Index operator[](Index i) const;

private:
  static constexpr Index IdsPerBlock = 512;
  std::vector<std::uint64_t> Words; ///< one bit per tested id, 1 for kept ids
  std::vector<Index> Before;        ///< number of kept ids before each block of IdsPerBlock ids
  Index Size = 0;
};
}

#endif
