/// Opens the files that a list of scans names.

#ifndef ConformalScanFolder_h
#define ConformalScanFolder_h

#include "StanfordScans/AlignedScans.h"

#include <string>

namespace conformal
{
/// Opens scans by their names relative to a folder. Links are followed; one that leads out of the
/// folder is refused (Malformed) unless external files are allowed.
OpenScan openScansIn(const std::string& folder, bool allowExternalFiles);
}

#endif
