/// A compact set of the indices that are kept, of many.

#ifndef ConformalKeptIds_h
#define ConformalKeptIds_h

#include "Base/Types.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// The ids that a test lets through, by their rank among these. Ten million points with a few that
/// are not finite would otherwise cost a list of all the others.
class KeptIds
{
public:
  KeptIds() = default;

  /// @param[in] size  how many ids there are, from 0
  /// @param[in] keep  called once for each, in order
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

  /// Id of the i-th that is kept, i in [0, size()). Costs about the logarithm of the ids' number.
  Index operator[](Index i) const;

private:
  static constexpr Index IdsPerBlock = 512;
  std::vector<std::uint64_t> Words; ///< a bit for each id
  std::vector<Index> Before;        ///< how many are kept before each block
  Index Size = 0;
};
}

#endif
