/// Parser of range scans and the motions that align them, in the Stanford repository's format.

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
  bool InvertRotation = false;     ///< whether quaternions turn the other way
  bool AllowExternalFiles = false; ///< whether scans may lie outside of the file's folder
  bool RequireAllScans = false;    ///< whether a scan that is not there is an error
};

struct OpenedScan
{
  ParseStatus Status;
  ByteReader Input;     ///< at its first byte, if the status is good
  std::string Identity; ///< the same for all names of one file
};

/// Opens a scan by its name in the file.
using OpenScan = std::function<OpenedScan(const std::string& name)>;

/// Read lines "bmesh NAME TX TY TZ QI QJ QK QL" or "mesh ..." and the PLY files that they name;
/// lines "camera" are skipped. All points become one cloud, Float64, each turned by the inverse of
/// the rotation that the quaternion (QI, QJ, QK, QL), QL its scalar, commonly stands for, and then
/// shifted by (TX, TY, TZ). "ScanId" (Int32) tells which scan of the file a point is from, counted
/// from 0, and point arrays that all scans have by name, type and number of components are kept. A
/// scan may be named once, and by one name only. Scans that are not there are counted and left out,
/// if others are there and options do not say otherwise.
SurfaceResult parseAlignedScans(ByteReader& input, const OpenScan& open,
  const AlignedScansOptions& options = {}, const ParseLimits& limits = {}, const Run& run = {});

/// Names of all scans in a list, as they stand there, up to the first line of another format. No
/// scan is opened, and no motion is read.
std::vector<std::string> namesOfAlignedScans(ByteReader& input);

/// Whether bytes from the start of a file are those of such a list.
bool looksLikeAlignedScans(std::string_view start);
}

#endif
