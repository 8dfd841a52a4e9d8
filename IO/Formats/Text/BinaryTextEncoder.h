/// Convert bytes to base64 text, optionally compressed with zlib.

#ifndef ConformalBinaryTextEncoder_h
#define ConformalBinaryTextEncoder_h

#include "Base/Run.h"
#include "Bytes/ParseStatus.h"

#include <string>
#include <string_view>

namespace conformal
{
/// Convert bytes to base64 text.
/// @param[in] isCompressed  whether to compress the bytes with zlib first
/// @throws Aborted if the progress callback of `run` returns false
std::string encodeBinaryText(std::string_view bytes, bool isCompressed, const Run& run = {});
}

#endif
