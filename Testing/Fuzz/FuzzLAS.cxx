#include "LAS/LASParser.h"

#include "FuzzTarget.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  return fuzz::run(
    bytes, size, [](conformal::ByteReader& input) { return conformal::parseLAS(input); });
}
