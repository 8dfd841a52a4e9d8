#include "Base/KeptIds.h"

#include <algorithm>
#include <bitset>

namespace conformal
{
Index KeptIds::operator[](Index i) const
{
  const Index block =
    std::upper_bound(this->Before.begin(), this->Before.end(), i) - this->Before.begin() - 1;
  Index rest = i - this->Before[block];
  Index word = block * (IdsPerBlock / 64);
  for (;; ++word)
  {
    const Index count = static_cast<Index>(std::bitset<64>(this->Words[word]).count());
    if (rest < count)
    {
      break;
    }
    rest -= count;
  }
  std::uint64_t bits = this->Words[word];
  for (; rest > 0; --rest)
  {
    bits &= bits - 1; // clear the lowest bit
  }
  return 64 * word + static_cast<Index>(std::bitset<64>((bits & (~bits + 1)) - 1).count());
}
}
