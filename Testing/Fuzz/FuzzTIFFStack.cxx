#include "TIFF/TIFFStackParser.h"

#include "FuzzTarget.h"

// A time step is read whole, with positive spacing, or refused with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  const std::string_view file(reinterpret_cast<const char*>(bytes), size);
  const auto open = [&](conformal::ByteReader& input)
  {
    input = conformal::ByteReader(file);
    return conformal::ParseStatus{};
  };
  const conformal::TIFFStackResult result = conformal::parseTIFFStack(open);
  if (!result.Status.ok())
  {
    fuzz::require(!result.Status.Message.empty() && result.Stack.Values.size() == 0);
    return 0;
  }
  const conformal::TIFFStackInfo& info = result.Stack.Info;
  fuzz::require(result.Stack.Values.size() ==
    info.pixelsPerPage() * info.Slices * info.Channels * conformal::sizeOf(info.Type));
  for (const double spacing : info.Spacing)
  {
    fuzz::require(std::isfinite(spacing) && spacing > 0.0);
  }
  fuzz::require(std::isfinite(info.FrameInterval) && info.FrameInterval > 0.0);
  return 0;
}
