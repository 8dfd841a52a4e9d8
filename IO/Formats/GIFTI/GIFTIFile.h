/// Parser of the arrays of a GIFTI file, whatever their intent.

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
  NamedArray Values;  ///< its name is that of the metadata, may be empty
};

/// Whether bytes from the start of a file are those of a GIFTI file.
bool looksLikeGIFTI(std::string_view start);

/// Read all arrays: ASCII, Base64Binary and GZipBase64Binary, both orders of bytes and of indices.
/// Entities of the file's own and arrays in other files are refused.
/// @throws ParseError
std::vector<GIFTIArray> readGIFTIFile(ByteReader& input, const ParseLimits& limits, const Run& run);
}

#endif
