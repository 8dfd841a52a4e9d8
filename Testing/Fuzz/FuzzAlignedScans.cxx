#include "StanfordScans/AlignedScans.h"

#include "FuzzTarget.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  const auto open = [](const std::string& name)
  {
    conformal::OpenedScan scan;
    scan.Identity = name;
    scan.Input = conformal::ByteReader(std::string_view("ply\nformat ascii 1.0\nelement vertex 1\n"
                                                        "property float x\nproperty float y\n"
                                                        "property float z\nend_header\n1 2 3\n"));
    return scan;
  };
  return fuzz::run(bytes, size,
    [&](conformal::ByteReader& input) { return conformal::parseAlignedScans(input, open); });
}
