/// Progress of a parser, as the fraction of the input that has been read.

#ifndef ConformalProgressReport_h
#define ConformalProgressReport_h

#include "Bytes/ByteReader.h"

#include <cstdint>

namespace conformal
{
class ProgressReport
{
public:
  ProgressReport(const ByteReader& input, const ParseProgress& progress)
    : Input(input)
    , Progress(progress)
  {
  }

  /// Call often: reports at every hundredth of the input.
  /// @throws ParseError if the caller says stop
  void tick()
  {
    const std::uint64_t offset = this->Input.offset();
    if (offset < this->NextReport)
    {
      return;
    }
    const std::uint64_t size = this->Input.size();
    this->NextReport = offset + size / 100 + 1;
    if (this->Progress && !this->Progress(static_cast<double>(offset) / size))
    {
      this->Input.fail(ParseCode::Aborted, "aborted");
    }
  }

private:
  const ByteReader& Input;
  const ParseProgress& Progress;
  std::uint64_t NextReport = 0;
};
}

#endif
