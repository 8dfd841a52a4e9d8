/// Report the progress of a parser, as the fraction of the input that has been read.

#ifndef ConformalProgressReport_h
#define ConformalProgressReport_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"

#include <cstdint>

namespace conformal
{
class ProgressReport
{
public:
  ProgressReport(const ByteReader& input, const conformal::Run& run)
    : Input(input)
    , Run(run)
  {
  }

  /// Report progress if a hundredth of the input was read since the last report. Parsers call this
  /// function for every record, such as a point.
  /// @throws Aborted if the caller's progress callback returns false
  void tick()
  {
    const std::uint64_t offset = this->Input.offset();
    if (offset < this->NextReport)
    {
      return;
    }
    const std::uint64_t size = this->Input.size();
    this->NextReport = offset + size / 100 + 1;
    this->Run.report(static_cast<double>(offset) / static_cast<double>(size));
  }

private:
  const ByteReader& Input;
  const conformal::Run& Run;
  std::uint64_t NextReport = 0;
};
}

#endif
