/// Determine the byte order of this machine, and write numbers in a given byte order.

#ifndef ConformalByteOrder_h
#define ConformalByteOrder_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace conformal
{
inline bool isLittleEndianMachine()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

/// Read a number from little-endian bytes.
/// @tparam Byte  char or unsigned char
template <typename T, typename Byte>
T littleEndianAt(const Byte* bytes)
{
  static_assert(sizeof(Byte) == 1, "bytes have the size 1");
  Byte copy[sizeof(T)];
  std::memcpy(copy, bytes, sizeof(T));
  if (!isLittleEndianMachine())
  {
    std::reverse(copy, copy + sizeof(T));
  }
  T value;
  std::memcpy(&value, copy, sizeof(T));
  return value;
}

/// Append the `size` bytes of a number, which is in the byte order of this machine.
/// @param[in] isBig  whether the appended bytes are big-endian; otherwise they are little-endian
inline void appendBytes(std::string& bytes, const void* value, std::size_t size, bool isBig)
{
  const char* const begin = static_cast<const char*>(value);
  bytes.append(begin, size);
  if (isBig == isLittleEndianMachine())
  {
    std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(size), bytes.end());
  }
}

template <typename T>
void appendBytes(std::string& bytes, T value, bool isBig)
{
  static_assert(!std::is_floating_point<T>::value || std::numeric_limits<T>::is_iec559,
    "files hold IEEE 754 numbers");
  appendBytes(bytes, &value, sizeof(value), isBig);
}
}

#endif
