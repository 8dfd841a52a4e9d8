/// Exact orientation of three directions on the sphere, \cite Shewchuk1997.

#ifndef ConformalSphereOrientation_h
#define ConformalSphereOrientation_h

#include "Base/Types.h"

namespace conformal
{
/// Compute the exact sign of the determinant of three vectors. Seen from outside the sphere, the
/// result is 1 for counter-clockwise order and -1 for clockwise order. It is 0 if the vectors lie
/// in a plane through the center. First a determinant of differences is computed. If its error
/// bound does not determine the sign, the products are summed exactly as non-overlapping doubles,
/// \cite Shewchuk1997.
/// @param[in] a, b, c  vectors of about unit length
int orientation(const Vector3& a, const Vector3& b, const Vector3& c);

/// Return the triangles of a sphere map, all reversed if the map is mirrored. A map is mirrored if
/// most of its area is clockwise seen from outside. SphereLocator requires counter-clockwise
/// triangles.
Triangles turnedOutward(const Triangles& triangles, const Points& spherePositions);

/// Count the flipped triangles of a sphere map. A triangle counts as flipped unless it is
/// counter-clockwise seen from outside: its orientation() is not 1.
Index countFlippedTriangles(const Points& spherePositions, const Triangles& triangles);
}

#endif
