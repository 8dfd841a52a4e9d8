/// Triangulate polygons with many corners by ear clipping, \cite Meisters1975.

#ifndef ConformalPolygonTriangulation_h
#define ConformalPolygonTriangulation_h

#include "Base/Types.h"

namespace conformal
{
/// Triangulate a polygon without self-intersections. The triangles use only the corners of the
/// polygon and have its orientation.
///
/// The polygon need not be flat: its corners are first projected to a plane, along its normal. An
/// ear is a triangle of three consecutive corners that contains no other corner. Ears are cut off
/// one by one. A triangle is tested only against corners near it. The computing time for a polygon
/// of 100,000 corners is thus below a second.
/// @param[in] corners  #C by 3 positions along the border of the polygon
/// @return #C - 2 by 3 ids of corners; no triangles if the polygon is collinear, self-intersecting
///   or not finite
Triangles triangulatePolygon(const Points& corners);
}

#endif
