/// Parse all arrays of a GIFTI file, of any intent.

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
  std::string Intent; ///< intent of the array, without the prefix NIFTI_INTENT_
  NamedArray Values;  ///< numbers of the array; the name is from the metadata and may be empty
};

/// Test whether the first bytes of a file are those of a GIFTI file.
bool looksLikeGIFTI(std::string_view start);

/// Read all arrays of a file. Supported encodings are ASCII, Base64Binary and GZipBase64Binary,
/// with any order of bytes and indices. Custom entities and arrays in external files are rejected.
/// @throws ParseError
std::vector<GIFTIArray> readGIFTIFile(ByteReader& input, const ParseLimits& limits, const Run& run);
}

#endif
