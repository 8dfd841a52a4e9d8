/// Move the vertices near the border of a sheet to the surface that the points define. A closed
/// surface bends away from the points where a part without points begins, and a sheet that is cut
/// out of it keeps this bend.

#ifndef ConformalBorderPolish_h
#define ConformalBorderPolish_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Move the vertices near the border to quadratic surfaces that are fitted to the nearest points,
/// as in moving least squares, \cite Levin2004. The moves are limited to one edge length.
/// @param[in,out] positions  #V by 3 vertices of the sheet
/// @param[in] points  all points near the border
void polishBorder(
  Points& positions, const Triangles& triangles, const Points& points, const Run& run = {});
}

#endif
