#include "PlateModel/PlateModelLabel.h"
#include "PlateModel/PlateModelParser.h"
#include "TextCloud/TextCloudParser.h"

#include "FuzzTarget.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  // Plate models are tables of numbers too: what covers one parser serves the other.
  fuzz::run(
    bytes, size, [](conformal::ByteReader& input) { return conformal::parsePlateModel(input); });
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  conformal::looksLikePlateModel(text);
  conformal::parsePlateModelLabel(text);
  conformal::TextCloudOptions options;
  options.DecimalComma = size % 3 == 0; // the last byte is often of no other use
  options.SkipMalformedLines = size % 2 == 0;
  return fuzz::run(bytes, size,
    [&](conformal::ByteReader& input) { return conformal::parseTextCloud(input, options); });
}
