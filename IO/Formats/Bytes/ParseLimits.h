/// Limit the memory that a parser may allocate.

#ifndef ConformalParseLimits_h
#define ConformalParseLimits_h

#include "Bytes/ByteReader.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace conformal
{
/// Maximum length of a line, a sequence of blanks, a comment or a tag [bytes]. A longer text is an
/// error. The limit is sufficient for a line with a polygon of a million corners. Because of this
/// limit, a large file without line ends is not read into memory as a whole.
constexpr std::size_t LongestLine = std::size_t(16) << 20;

/// Return the error message for text that is longer than LongestLine.
inline std::string tooLongMessage(const char* what)
{
  return std::string("found ") + what + " of more than " + std::to_string(LongestLine >> 20) +
    " MiB";
}

struct ParseLimits
{
  /// Maximum memory for all records of one kind, such as all points of a file [bytes].
  std::uint64_t MaximumMemory = std::numeric_limits<std::ptrdiff_t>::max();

  /// Check the number of records, such as points, that a file states. Call this function before
  /// memory is allocated for the records. The rest of the input must contain at least
  /// minimumRecordBytes for each record. The memory for all records must not exceed MaximumMemory.
  ///
  /// The error has one of these codes:
  /// - Malformed: the records would need more than 1 GiB in the file, and more than 1000 times the
  ///   rest of the input.
  /// - PrematureEnd: the rest of the input is too short, but one limit of Malformed is not
  ///   exceeded. The file is probably truncated.
  /// - OutOfMemory: the memory would exceed MaximumMemory.
  ///
  /// @param[in] what                name of the records, for the error message
  /// @param[in] count               number of records
  /// @param[in] minimumRecordBytes  minimum size of a record in the file [bytes]; 0 if unknown
  /// @param[in] memoryPerRecord     memory for each record [bytes]; 0 if none is allocated
  /// @return the count
  /// @throws ParseError if the rest of the input is too short, or the memory would exceed
  ///   MaximumMemory
  std::size_t checkedCount(const ByteReader& input, const std::string& what, std::uint64_t count,
    std::uint64_t minimumRecordBytes, std::uint64_t memoryPerRecord) const;
};
}

#endif
