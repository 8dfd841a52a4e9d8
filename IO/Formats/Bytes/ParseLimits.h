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
/// Maximum length of a line, a sequence of blanks, a comment or a tag [bytes]. It is sufficient for
/// a polygon of a million corners. A longer text is rejected. A file without line ends is thus
/// never in memory as a whole.
constexpr std::size_t LongestLine = std::size_t(16) << 20;

/// Return the error message for text that is longer than LongestLine.
inline std::string tooLongMessage(const char* what)
{
  return std::string("found ") + what + " of more than " + std::to_string(LongestLine >> 20) +
    " MiB";
}

struct ParseLimits
{
  /// Maximum memory [bytes] that one count in a file may request.
  std::uint64_t MaximumMemory = std::numeric_limits<std::ptrdiff_t>::max();

  /// Check a count of records read from a file, before memory is allocated for the records. The
  /// records must fit into the rest of the input if each has minimumRecordBytes there. They must
  /// fit into MaximumMemory if each needs memoryPerRecord.
  ///
  /// If the count exceeds the rest of the input, the error is usually PrematureEnd, as for a
  /// truncated file. The error is Malformed if the records would need more than a gigabyte and more
  /// than a thousand times the rest of the input.
  /// @param[in] what  name of the records, for the message
  /// @throws ParseError
  std::size_t checkedCount(const ByteReader& input, const std::string& what, std::uint64_t count,
    std::uint64_t minimumRecordBytes, std::uint64_t memoryPerRecord) const;
};
}

#endif
