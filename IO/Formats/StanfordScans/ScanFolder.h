/// Open the files of a list of scans.

#ifndef ConformalScanFolder_h
#define ConformalScanFolder_h

#include "StanfordScans/AlignedScans.h"

#include <string>

namespace conformal
{
/// Open scans by their names relative to a folder. Links are followed; a link that leads out of the
/// folder is rejected (Malformed) unless external files are allowed.
OpenScan openScansIn(const std::string& folder, bool allowExternalFiles);
}

#endif
