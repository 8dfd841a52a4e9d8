/// Progress of a parser, as the fraction of the input that has been read.

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

  /// Report progress after every hundredth of the input. Call this function often.
  /// @throws Aborted
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
