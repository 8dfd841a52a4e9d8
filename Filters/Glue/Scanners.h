// Find the positions of the scanners that measured the points of a cloud.
#ifndef GlueScanners_h
#define GlueScanners_h

#include "Base/CoordinateFrame.h" // for CoordinateFrame
#include "Base/Types.h"           // for Points

class vtkPointSet;

namespace conformal
{
class TrainingSamples;
}

namespace glue
{
/// Return the name of the point array with the positions of scanners, "ScannerPosition".
inline const char* ScannerPositionName()
{
  return "ScannerPosition";
}

/// Set the positions of the scanners of the samples, if every rank (process) with points has the
/// point array "ScannerPosition", or the field array "ScannerPosition" with one position. A
/// position that is not finite is unknown.
/// @param[out] copy  memory for the positions; must outlive the samples
/// @throws std::invalid_argument if the array does not have 3 components, or not 1 tuple for each
///   point, or if the field array does not have 1 tuple
void SetScanners(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  conformal::TrainingSamples& samples, conformal::Points& copy);
}

#endif
