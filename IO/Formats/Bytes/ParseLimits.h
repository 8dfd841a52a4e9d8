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
/// Maximum length of a line, run of blanks, comment or tag [bytes], enough for a polygon of a
/// million corners. A text is buffered up to this length and rejected beyond. A file without line
/// ends is thus never in memory as a whole.
constexpr std::size_t LongestLine = std::size_t(16) << 20;

/// Message for a longer line.
inline std::string tooLongMessage(const char* what)
{
  return std::string("found ") + what + " of more than " + std::to_string(LongestLine >> 20) +
    " MiB";
}

struct ParseLimits
{
  /// Maximum memory [bytes] that one count in a file may request.
  std::uint64_t MaximumMemory = std::numeric_limits<std::ptrdiff_t>::max();

  /// Check a count read from a file before memory is allocated for it. That many records of at
  /// least minimumRecordBytes must fit into the rest of the input. At memoryPerRecord each, they
  /// must fit into MaximumMemory.
  ///
  /// A truncated file ends early (PrematureEnd). A count of more than a gigabyte and of a thousand
  /// times the rest of the input is invalid (Malformed).
  /// @param[in] what  name of the records, for the message
  /// @throws ParseError
  std::size_t checkedCount(const ByteReader& input, const std::string& what, std::uint64_t count,
    std::uint64_t minimumRecordBytes, std::uint64_t memoryPerRecord) const;
};
}

#endif
