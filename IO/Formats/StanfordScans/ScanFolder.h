/// Open the files of a list of scans.

#ifndef ConformalScanFolder_h
#define ConformalScanFolder_h

#include "StanfordScans/AlignedScans.h"

#include <string>

namespace conformal
{
/// Return a function that opens scans by their paths relative to a folder. Symbolic links are
/// followed. Unless external files are allowed, a path that leads out of the folder is rejected
/// (Malformed).
OpenScan openScansIn(const std::string& folder, bool allowExternalFiles);
}

#endif
