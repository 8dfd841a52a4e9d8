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

  /// Report progress if another hundredth of the input has been read. Parsers call this function
  /// often.
  /// @throws Aborted if the progress callback of the run returns false
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
