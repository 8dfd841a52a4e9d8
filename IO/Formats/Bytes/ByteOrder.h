/// Which end of a number comes first.

#ifndef ConformalByteOrder_h
#define ConformalByteOrder_h

#include <cstdint>
#include <cstring>

namespace conformal
{
inline bool isLittleEndianMachine()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}
}

#endif
