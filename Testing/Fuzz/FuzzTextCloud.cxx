#include "TextCloud/TextCloudParser.h"

#include "FuzzTarget.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  conformal::TextCloudOptions options;
  options.DecimalComma = size % 3 == 0; // the last byte is often of no other use
  options.SkipMalformedLines = size % 2 == 0;
  return fuzz::run(bytes, size,
    [&](conformal::ByteReader& input) { return conformal::parseTextCloud(input, options); });
}
