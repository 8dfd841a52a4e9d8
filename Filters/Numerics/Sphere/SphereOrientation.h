/// Compute the exact orientation of three directions on the sphere, \cite Shewchuk1997.

#ifndef ConformalSphereOrientation_h
#define ConformalSphereOrientation_h

#include "Base/Types.h"

namespace conformal
{
/// Compute the exact sign of the determinant of three vectors. The result is 1 if they are
/// counter-clockwise seen from outside the sphere, and -1 if they are clockwise. If the three
/// vectors are in a plane through the center, the result is 0. First, the determinant of a, b - a
/// and c - a is computed in double precision. If rounding errors could change its sign, the
/// determinant is computed exactly, \cite Shewchuk1997. The exact value is stored as a sum of
/// doubles whose bits do not overlap.
/// @param[in] a, b, c  vectors of about unit length
int orientation(const Vector3& a, const Vector3& b, const Vector3& c);

/// Return the triangles of a sphere map (mesh on the unit sphere), as SphereLocator requires them:
/// counter-clockwise seen from outside. All triangles are reversed if most of the area on the
/// sphere is clockwise. Otherwise, the triangles do not change.
Triangles turnedOutward(const Triangles& triangles, const Points& spherePositions);

/// Count the flipped triangles of a sphere map. A triangle is flipped if the orientation() of its
/// vertices is 0 or -1.
Index countFlippedTriangles(const Points& spherePositions, const Triangles& triangles);
}

#endif
