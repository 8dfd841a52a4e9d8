/// Exact orientation predicate for three directions, \cite Shewchuk1997.

#ifndef ConformalSphereOrientation_h
#define ConformalSphereOrientation_h

#include "Base/Types.h"

namespace conformal
{
/// Compute the exact sign of the determinant of three vectors. It is 1 for counter-clockwise order
/// seen from outside the sphere, -1 for clockwise order, 0 for vectors in a plane through the
/// center. A determinant of differences is used when its error bound fixes the sign. Otherwise the
/// products are summed exactly as non-overlapping doubles \cite Shewchuk1997.
/// @param[in] a, b, c  of about unit length
int orientation(const Vector3& a, const Vector3& b, const Vector3& c);

/// Reverse all triangles of a sphere map if most of its area is clockwise seen from outside, as for
/// a mirrored map. SphereLocator requires counter-clockwise triangles.
Triangles turnedOutward(const Triangles& triangles, const Points& spherePositions);

/// Count the triangles of a sphere map that are clockwise seen from outside, or flat.
Index countFlippedTriangles(const Points& spherePositions, const Triangles& triangles);
}

#endif
