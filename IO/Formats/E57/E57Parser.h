/// Parse E57 files, the exchange format of laser scanners (ASTM E2807).

#ifndef ConformalE57Parser_h
#define ConformalE57Parser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
struct E57Options
{
  static constexpr int AllScans = -1;
  int ScanId = AllScans;        ///< index of the scan to read, from 0, or AllScans
  bool ShiftCoordinates = true; ///< subtract a vector from coordinates that are far from the origin
};

/// Test whether the first bytes of a file identify an E57 file.
bool looksLikeE57(std::string_view start);

/// Read the points of the scans of an E57 file. The checksums of all pages that are read are
/// checked.
///
/// - Coordinates, cartesian or spherical, are rotated and translated by the pose of the scan. A
/// point
///   without measurement (cartesianInvalidState or sphericalInvalidState is not 0) is omitted, and
///   not counted in SurfaceData::DroppedPoints. storeCoordinates() decides whether points become
///   Float32, and whether a vector is subtracted. The resolution is the scale of scaled integers,
///   or 2^-21 times the largest coordinate of a scan with coordinates of single precision. The
///   resolution of coordinates of double precision is unknown.
/// - colorRed, colorGreen, colorBlue become "RGB" (UInt8), intensity becomes "Intensity", and
///   nor:normalX, nor:normalY, nor:normalZ become "Normals", rotated. Colors are mapped from their
///   limits to 0 to 255, unless they are integers from 0 to 255.
/// - Every other number of the points becomes an array with the name in the file. If several scans
///   are read, only numbers that all scans have become arrays, and "ScanId" (Int32) is the index of
///   the scan. Texts are omitted.
/// - Integers become arrays of the smallest type for their range, scaled integers become Float64.
/// - SurfaceData::ScannerPosition is the translation of the pose, if one scan is read whose points
///   have spherical coordinates, or a row and a column. Other clouds may contain points of several
///   positions of the scanner. If several such scans are read, the position becomes the array
///   "ScannerPosition" (Float32).
///
/// @throws std::invalid_argument if the file does not have the scan of the options
SurfaceResult parseE57(ByteReader& input, const E57Options& options = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif
