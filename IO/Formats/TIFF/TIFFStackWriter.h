/// Write stacks as TIFF files, \cite TIFF6, that the programs ImageJ and Fiji open with spacing,
/// channels, time steps and unit.

#ifndef ConformalTIFFStackWriter_h
#define ConformalTIFFStackWriter_h

#include "Base/Run.h"
#include "TIFF/TIFFStack.h"

#include <string>

namespace conformal
{
/// Write all time steps of a stack. The pages are not compressed and follow each other, since
/// ImageJ reads only such stacks. The range of all numbers is written for the display.
/// @param[in] firstRowUp  whether the last row of the stack becomes the first row of the file
/// @throws std::invalid_argument unless the type is UInt8, UInt16 or Float32, the size fits the
///   values and is not 0, and spacings and frame interval are positive. Also if the file would
///   exceed 4 GB, or a spacing in a slice is not in [2.33e-10, 4.29e9], whose inverse does not fit
///   quotients of TIFF
/// @throws Aborted if the progress callback of `run` returns false
std::string makeTIFFStack(const TIFFStack& stack, bool firstRowUp = false, const Run& run = {});
}

#endif
