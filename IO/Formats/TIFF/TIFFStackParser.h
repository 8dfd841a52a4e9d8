/// Parse TIFF files of several pages, \cite TIFF6, with the description of the program ImageJ.

#ifndef ConformalTIFFStackParser_h
#define ConformalTIFFStackParser_h

#include "Base/Run.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/ParseStatus.h"
#include "TIFF/TIFFDirectory.h"
#include "TIFF/TIFFStack.h"

#include <cstddef>

namespace conformal
{
struct TIFFStackOptions
{
  std::size_t Frame = 0;   ///< time step to read
  bool FirstRowUp = false; ///< whether the first row of the file is the last row of the result
  bool HeaderOnly = false; ///< whether only the Info is read
};

struct TIFFStackResult
{
  TIFFStack Stack;
  ParseStatus Status;
};

/// Read a stack. All pages must have one size and type. Pages may have 8, 16, 32 or 64 bits per
/// number, in strips, without compression or compressed by deflate, and in files of either byte
/// order, also BigTIFF.
///
/// The description of ImageJ holds the numbers of channels, slices and frames, the unit, and the
/// distance of slices. The resolution holds the number of pixels in a unit. Without a description,
/// every page is a slice, and the spacing is 1. A stack of ImageJ of more than 4 GB has only one
/// page in its directory; its other pages follow the first one. Samples of one pixel, such as
/// colors, are channels.
TIFFStackResult parseTIFFStack(const OpenInput& open, const TIFFStackOptions& options = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif
