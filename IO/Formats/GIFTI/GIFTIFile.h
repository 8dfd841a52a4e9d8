/// Parse all arrays of a GIFTI file, a neuroimaging format in XML. The intent of an array states
/// its meaning, such as POINTSET for coordinates of points.

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
  NamedArray Values;  ///< numbers of the array; the name is the metadata entry "Name", or empty
};

/// Test whether the first bytes of a file identify a GIFTI file.
bool looksLikeGIFTI(std::string_view start);

/// Read all arrays of a GIFTI file. The encodings ASCII, Base64Binary and GZipBase64Binary are
/// supported, with any byte order, and with row-major or column-major numbers. Files with custom
/// XML entities, and files with arrays in external files, are rejected.
/// @throws ParseError if the file is malformed, truncated or not supported
std::vector<GIFTIArray> readGIFTIFile(ByteReader& input, const ParseLimits& limits, const Run& run);
}

#endif
