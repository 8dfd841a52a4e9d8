/// Store coordinates as floats if this loses nothing, and subtract a vector if they are far from
/// the origin, as coordinates of maps are.

#ifndef ConformalCoordinateShift_h
#define ConformalCoordinateShift_h

#include "Bytes/NamedArray.h"

#include <vector>

namespace conformal
{
/// Shift and store the coordinates of a cloud. Own construction, since formats of scanners state
/// the resolution of their coordinates, such as 1 mm, beside coordinates of a map, such as 5,400
/// km.
///
/// - Floats suffice if rounding changes no coordinate by more than a quarter of the resolution. The
///   numbers of the file can then be computed from the floats, even after a rotation.
/// - If floats do not suffice, and the largest coordinate is at least 10 times the largest side of
///   the bounding box, which is not 0, a vector is subtracted. It is the center of the bounding
///   box, rounded to multiples of a power of 10 that is at most this side.
/// - The coordinates then become Float32 if floats suffice. Otherwise, they remain Float64.
///
/// @param[in,out] points  coordinates, #P by 3, Float64, finite
/// @param[in] resolution  smallest difference between different coordinates of the file, in the
/// unit
///   of the points; 0 if unknown. Then floats never suffice
/// @param[in] canShift  whether a vector may be subtracted
/// @return the subtracted vector, 3 numbers; empty if there is none
std::vector<double> storeCoordinates(NamedArray& points, double resolution, bool canShift);
}

#endif
