/// Parse lists of range scans with their alignments (.conf), in the format of the Stanford 3D
/// Scanning Repository.

#ifndef ConformalAlignedScans_h
#define ConformalAlignedScans_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
struct AlignedScansOptions
{
  /// Whether each scan is rotated by its quaternion in the list. If false, each scan is rotated by
  /// the inverse of its quaternion, as the files of the repository require
  bool InvertRotation = false;
  bool AllowExternalFiles = false; ///< whether scans may be outside of the folder of the list
  bool RequireAllScans = false;    ///< whether a missing scan is an error
};

struct OpenedScan
{
  ParseStatus Status;
  ByteReader Input;     ///< reader at the first byte of the scan; only valid if Status.ok()
  std::string Identity; ///< text that identifies the file, equal for all paths to this file
};

/// Function that opens the file of a scan. The argument is the name of the scan in the list.
using OpenScan = std::function<OpenedScan(const std::string& name)>;

/// Read a list of range scans, and the PLY files of the scans. The result is a cloud (points
/// without polygons) of all scans, as Float64.
///
/// Each line of the list is "bmesh NAME TX TY TZ QI QJ QK QL" or "mesh NAME ...". NAME is a PLY
/// file. T = (TX, TY, TZ) is a translation, and (QI, QJ, QK, QL) is a quaternion with scalar part
/// QL. Let R be the rotation matrix of the quaternion. A point p of the scan becomes R^-1 p + T. If
/// InvertRotation is true, p becomes R p + T. Blank lines, comments after "#", and lines "camera"
/// are skipped.
///
/// The point array "ScanId" (Int32) contains the index of the scan of each point. The index counts
/// the scans of the list from 0, including missing scans. A point array is kept if every scan has
/// an array of the same name, type and number of components.
///
/// The point array "ScannerPosition" (Float32) contains a position of the scanner of each point.
/// The scanners of the repository scan along the z axis of a scan, from z = infinity. The position
/// is thus in this direction from the point, a thousand times the largest coordinate of the scan
/// away.
///
/// If the list contains the same file twice, the result is an error. Missing scans are omitted and
/// counted in SurfaceData::MissingScans. If RequireAllScans is true, a missing scan is an error. If
/// none of the scans exists, the result is also an error.
/// @param[in] open  function that opens the file of a scan
SurfaceResult parseAlignedScans(ByteReader& input, const OpenScan& open,
  const AlignedScansOptions& options = {}, const ParseLimits& limits = {}, const Run& run = {});

/// Return the names of the scans in a list, as written in the list. The function stops at the first
/// line with an unknown keyword. Scans are not opened, and numbers are not parsed.
std::vector<std::string> namesOfAlignedScans(ByteReader& input);

/// Test whether the first bytes of a file identify a list of aligned scans.
bool looksLikeAlignedScans(std::string_view start);
}

#endif
