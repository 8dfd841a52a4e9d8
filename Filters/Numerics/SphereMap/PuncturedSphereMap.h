/// Conformal map of a closed surface to the sphere by one linear solve.

#ifndef ConformalPuncturedSphereMap_h
#define ConformalPuncturedSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"

namespace conformal
{
/// The triangle to take out: regular among regular ones, and not at the end of a limb, where the
/// rest of the surface would become too small.
Index choosePuncture(const Points& points, const Triangles& triangles);

/// Likewise, given some map to the sphere: regular, and with much room there.
Index choosePuncture(
  const Points& points, const Triangles& triangles, const Points& spherePositions);

/// Take a triangle out, keep its shape, and let all other vertices find their rest in the plane
/// inside of it, as \cite Haker2000 and \cite Choi2015 do; correct what the triangle's finite size
/// has distorted; solve anew around the triangle; and carry the plane to the sphere.
///
/// Implementation note: far from the triangle the discrete solution is that of the plane plus
/// positive powers of z and of its conjugate, whose coefficients fall by the size of the triangle
/// with each power. The powers of the conjugate are all that is not conformal. They are found by
/// least squares on the Beltrami coefficients of the triangles and taken away, which replaces the
/// second global solve of \cite Choi2015. Around the triangle, where that does not hold, 1/z is
/// made harmonic again with its surroundings held.
///
/// @param[in] points   #V by 3, about of size one
/// @param[in] strings  cotangentWeights of the surface
/// @return #V by 3 unit vectors, not centered; triangles may be flipped
/// @throws NumericalFailure if the equations have no usable solution
Points punctureToSphere(const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, Index puncture, const Run& run = {});
}

#endif
