/// The one place where a number that a file promises becomes memory.

#ifndef ConformalParseLimits_h
#define ConformalParseLimits_h

#include "ByteReader.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace conformal
{
struct ParseLimits
{
  /// Largest piece of memory, in bytes, that one count of a file may ask for.
  std::uint64_t MaximumMemory = std::numeric_limits<std::ptrdiff_t>::max();

  /// A count read from a file, checked before anything is allocated for it: that many records of
  /// at least minimumRecordBytes must fit into what is left of the input, and into
  /// MaximumMemory at memoryPerRecord each. A file that was cut short ends early (PrematureEnd);
  /// one that promises a gigabyte and a thousand times what it has never held it (Malformed).
  /// @param[in] what  name of the records, for the message
  /// @throws ParseError
  std::size_t checkedCount(const ByteReader& input, const std::string& what, std::uint64_t count,
    std::uint64_t minimumRecordBytes, std::uint64_t memoryPerRecord) const;
};
}

#endif
