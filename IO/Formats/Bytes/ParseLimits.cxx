#include "Bytes/ParseLimits.h"

namespace conformal
{
namespace
{
constexpr std::uint64_t AbsurdFactor = 1000;
constexpr std::uint64_t AbsurdBytes = std::uint64_t(1) << 30;
}

//------------------------------------------------------------------------------
std::size_t ParseLimits::checkedCount(const ByteReader& input, const std::string& what,
  std::uint64_t count, std::uint64_t minimumRecordBytes, std::uint64_t memoryPerRecord) const
{
  const std::uint64_t left = input.left();
  if (minimumRecordBytes > 0 && count > left / minimumRecordBytes)
  {
    const bool absurd =
      count / AbsurdFactor > left / minimumRecordBytes && count > AbsurdBytes / minimumRecordBytes;
    input.fail(absurd ? ParseCode::Malformed : ParseCode::PrematureEnd,
      "found " + std::to_string(left) + " bytes, expected " + std::to_string(count) + " " + what +
        " of at least " + std::to_string(minimumRecordBytes) + " bytes each");
  }
  if (memoryPerRecord > 0 && count > this->MaximumMemory / memoryPerRecord)
  {
    input.fail(ParseCode::OutOfMemory,
      std::to_string(count) + " " + what + " need more memory than the limit");
  }
  return static_cast<std::size_t>(count);
}
}
