/// Open the scan files that a list of range scans (.conf) names.

#ifndef ConformalScanFolder_h
#define ConformalScanFolder_h

#include "StanfordScans/AlignedScans.h"

#include <string>

namespace conformal
{
/// Return a function that opens a scan by its path relative to a folder. Symbolic links are
/// followed. If allowExternalFiles is false, a path that leads out of the folder is rejected with
/// the status Malformed.
OpenScan openScansIn(const std::string& folder, bool allowExternalFiles);
}

#endif
