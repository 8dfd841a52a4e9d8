/// Limits on the memory that a parser may allocate.

#ifndef ConformalParseLimits_h
#define ConformalParseLimits_h

#include "Bytes/ByteReader.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace conformal
{
/// Longest line of a text, and longest run of blanks, remark or tag, in bytes: room for a polygon
/// of a million corners. A text is buffered up to here and refused beyond, so that a file without
/// line ends does not end up in memory.
constexpr std::size_t LongestLine = std::size_t(16) << 20;

/// What is wrong with a longer one, for messages.
inline std::string tooLongMessage(const char* what)
{
  return std::string("found ") + what + " of more than " + std::to_string(LongestLine >> 20) +
    " MiB";
}

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
