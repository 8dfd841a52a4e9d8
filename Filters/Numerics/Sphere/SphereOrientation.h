/// Exact orientation predicate for three directions.

#ifndef ConformalSphereOrientation_h
#define ConformalSphereOrientation_h

#include "Base/Types.h"

namespace conformal
{
/// Sign of the determinant of three vectors, exactly: 1 where they are counter-clockwise seen from
/// outside the sphere, -1 where they are clockwise, 0 where they lie in a plane through its center.
/// A determinant from differences decides where its rounding cannot matter; otherwise the products
/// are added up as sums of doubles that do not overlap \cite Shewchuk1997.
/// @param[in] a, b, c  of about unit length
int orientation(const Vector3& a, const Vector3& b, const Vector3& c);

/// The triangles of a map to the sphere, all turned over if most of the sphere sees them clockwise,
/// as where the map is mirrored: SphereLocator wants them counter-clockwise.
Triangles turnedOutward(const Triangles& triangles, const Points& spherePositions);

/// How many triangles of a map to the sphere are clockwise seen from outside, or flat.
Index countFlippedTriangles(const Points& spherePositions, const Triangles& triangles);
}

#endif
