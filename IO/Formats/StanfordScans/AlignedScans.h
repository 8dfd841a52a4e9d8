/// Parse range scans and their alignments in the format of the Stanford repository.

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
  bool InvertRotation = false;     ///< whether to invert the rotations of parseAlignedScans()
  bool AllowExternalFiles = false; ///< whether scans may be outside of the folder of the file
  bool RequireAllScans = false;    ///< whether a missing scan is an error
};

struct OpenedScan
{
  ParseStatus Status;
  ByteReader Input;     ///< input at the first byte of the scan, if Status.ok()
  std::string Identity; ///< text that is equal for all names of one file
};

/// Function that opens a scan by its name in the list.
using OpenScan = std::function<OpenedScan(const std::string& name)>;

/// Read lines "bmesh NAME TX TY TZ QI QJ QK QL" or "mesh ...", and the PLY files that they name.
/// Lines "camera" are skipped. All points become one cloud of Float64. Each point is rotated by the
/// inverse of the usual rotation of the quaternion (QI, QJ, QK, QL), with scalar QL. It is then
/// shifted by (TX, TY, TZ).
///
/// "ScanId" (Int32) is the index of the scan of each point, counted from 0. Point arrays that all
/// scans have by name, type and number of components are kept. Each scan may occur only once in the
/// list. Missing scans are counted and omitted, if other scans exist and RequireAllScans is false.
SurfaceResult parseAlignedScans(ByteReader& input, const OpenScan& open,
  const AlignedScansOptions& options = {}, const ParseLimits& limits = {}, const Run& run = {});

/// Return the names of all scans as written in a list, up to the first line of another format. No
/// scan is opened, and no numbers are parsed.
std::vector<std::string> namesOfAlignedScans(ByteReader& input);

/// Test whether the first bytes of a file are those of a list of scans.
bool looksLikeAlignedScans(std::string_view start);
}

#endif
