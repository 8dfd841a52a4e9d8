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
  bool InvertRotation = false;     ///< whether quaternions rotate in the opposite direction
  bool AllowExternalFiles = false; ///< whether scans may be outside of the folder of the file
  bool RequireAllScans = false;    ///< whether a missing scan is an error
};

struct OpenedScan
{
  ParseStatus Status;
  ByteReader Input;     ///< at its first byte, if the status is good
  std::string Identity; ///< equal for all names of one file
};

/// Open a scan by its name in the file.
using OpenScan = std::function<OpenedScan(const std::string& name)>;

/// Read lines "bmesh NAME TX TY TZ QI QJ QK QL" or "mesh ..." and their PLY files; lines "camera"
/// are skipped. All points become one cloud, Float64. Each point is rotated by the inverse of the
/// usual rotation of the quaternion (QI, QJ, QK, QL), with scalar QL. It is then shifted by (TX,
/// TY, TZ).
///
/// "ScanId" (Int32) is the index of the scan of each point, counted from 0. Point arrays that all
/// scans have by name, type and number of components are kept. A scan may occur once, and by one
/// name only. Missing scans are counted and omitted if other scans exist and options permit it.
SurfaceResult parseAlignedScans(ByteReader& input, const OpenScan& open,
  const AlignedScansOptions& options = {}, const ParseLimits& limits = {}, const Run& run = {});

/// Return the names of all scans in a list, verbatim, up to the first line of another format. No
/// scan is opened, and no motion is parsed.
std::vector<std::string> namesOfAlignedScans(ByteReader& input);

/// Test whether the first bytes of a file are those of such a list.
bool looksLikeAlignedScans(std::string_view start);
}

#endif
