/// Parse LAS files, the exchange format of laser scanners on aircraft.

#ifndef ConformalLASParser_h
#define ConformalLASParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
struct LASOptions
{
  bool ShiftCoordinates = true; ///< subtract a vector from coordinates that are far from the origin
};

/// Test whether the first bytes of a file identify a LAS or LAZ file.
bool looksLikeLAS(std::string_view start);

/// Read the points of a LAS file of version 1.0 to 1.4, in point format 0 to 10. Source: LAS
/// Specification 1.4 - R15 of the ASPRS, and those of versions 1.0 to 1.3. LAZ files, which are
/// compressed, are refused.
///
/// - A coordinate is an integer of the file times the scale of the header, plus its offset.
///   storeCoordinates() decides whether points become Float32, and whether a vector is subtracted.
///   The resolution is the smallest scale.
/// - Red, green and blue become "RGB" (UInt8). If a number of any point is above 255, all numbers
/// are
///   divided by 256.
/// - Other arrays are "Intensity", "PointSourceId", "NearInfrared" (UInt16), "Classification",
///   "ReturnNumber", "NumberOfReturns" (UInt8), "GPSTime" (Float64), if the point format has them.
SurfaceResult parseLAS(ByteReader& input, const LASOptions& options = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif
