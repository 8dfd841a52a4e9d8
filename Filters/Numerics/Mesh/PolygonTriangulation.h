/// Triangulation of polygons with many corners.

#ifndef ConformalPolygonTriangulation_h
#define ConformalPolygonTriangulation_h

#include "Base/Types.h"

namespace conformal
{
/// Cut a polygon without crossings into triangles of its corners that turn as it does. Corners
/// need not lie in a plane exactly; they are seen along the polygon's normal. Ears are cut off
/// around and around, and only the corners near an ear are looked at, so that polygons of a
/// hundred thousand corners take a fraction of a second.
/// @param[in] corners  #C by 3
/// @returns #C - 2 by 3, or none if the corners are flat, crossing or not finite
Triangles triangulatePolygon(const Points& corners);
}

#endif
