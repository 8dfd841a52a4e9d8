/// Conversion of bytes to base64 text, optionally compressed with zlib.

#ifndef ConformalBinaryTextEncoder_h
#define ConformalBinaryTextEncoder_h

#include "Bytes/ParseStatus.h"

#include <string>
#include <string_view>

namespace conformal
{
/// Write bytes as text.
/// @param[in] isCompressed  whether to compress them first
/// @throws ParseError with Aborted if the progress callback says stop
std::string encodeBinaryText(
  std::string_view bytes, bool isCompressed, const ParseProgress& progress = {});
}

#endif
