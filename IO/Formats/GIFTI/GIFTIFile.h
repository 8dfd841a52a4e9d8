/// Parse the arrays of a GIFTI file of any intent.

#ifndef ConformalGIFTIFile_h
#define ConformalGIFTIFile_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/NamedArray.h"
#include "Bytes/ParseLimits.h"

#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
struct GIFTIArray
{
  std::string Intent; ///< without NIFTI_INTENT_
  NamedArray Values;  ///< name from the metadata, may be empty
};

/// Test whether the first bytes of a file are those of a GIFTI file.
bool looksLikeGIFTI(std::string_view start);

/// Read all arrays: ASCII, Base64Binary and GZipBase64Binary, in any order of bytes and of indices.
/// Custom entities and arrays in external files are rejected.
/// @throws ParseError
std::vector<GIFTIArray> readGIFTIFile(ByteReader& input, const ParseLimits& limits, const Run& run);
}

#endif
