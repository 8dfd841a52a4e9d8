#include "E57/E57Parser.h"

#include "../Formats/E57/E57Samples.h"
#include "FuzzTarget.h"

// The bytes are the contents of a file without checksums, which a fuzzer cannot guess. The length
// of the file, which the header states, is also corrected.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  std::string contents(reinterpret_cast<const char*>(bytes), size);
  constexpr std::size_t lengthOffset = 16;
  if (size >= lengthOffset + sizeof(std::uint64_t))
  {
    const std::uint64_t pages = (size + samples::E57PageContents - 1) / samples::E57PageContents;
    const std::string length = samples::Bytes(false).add(1024 * pages).bytes();
    contents.replace(lengthOffset, length.size(), length);
  }
  const std::string file = samples::E57PagesOf(contents);
  return fuzz::run(reinterpret_cast<const std::uint8_t*>(file.data()), file.size(),
    [](conformal::ByteReader& input) { return conformal::parseE57(input); });
}
