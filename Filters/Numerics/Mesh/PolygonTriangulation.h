/// Triangulate polygons with many corners by ear clipping, \cite Meisters1975.

#ifndef ConformalPolygonTriangulation_h
#define ConformalPolygonTriangulation_h

#include "Base/Types.h"

namespace conformal
{
/// Cut a polygon without self-intersections into triangles of its corners with its orientation.
///
/// Corners may deviate from a plane; they are projected along the normal of the polygon. Only the
/// corners near an ear are tested. A polygon of 100,000 corners therefore needs a fraction of a
/// second.
/// @param[in] corners  #C by 3
/// @return #C - 2 by 3 ids; none if the corners are collinear, self-intersecting or not finite
Triangles triangulatePolygon(const Points& corners);
}

#endif
