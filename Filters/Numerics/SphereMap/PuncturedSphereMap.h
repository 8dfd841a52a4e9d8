/// Conformal map of a closed surface to the sphere by one linear solve.

#ifndef ConformalPuncturedSphereMap_h
#define ConformalPuncturedSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"

namespace conformal
{
/// Choose the triangle to remove. It is regular, has regular neighbors and does not lie at a limb
/// end, where the rest of the surface would become too small.
Index choosePuncture(const Points& points, const Triangles& triangles);

/// Choose a regular triangle to remove that has a large area under a given sphere map.
Index choosePuncture(
  const Points& points, const Triangles& triangles, const Points& spherePositions);

/// Map all vertices but those of one triangle into the plane inside of that triangle, as in \cite
/// Haker2000 and \cite Choi2015, and project the plane to the sphere.
///
/// The removed triangle keeps its shape. The other vertices are at equilibrium. The distortion by
/// the triangle's finite size is corrected, and the map is solved again around the triangle.
///
/// Implementation note: \cite Choi2015 solves a second global system for this correction. Far from
/// the triangle, the discrete solution is that of the plane plus positive powers of z and of its
/// conjugate. Each power reduces its coefficient by the size of the triangle. Only powers of the
/// conjugate are not conformal. Their coefficients are fitted to the Beltrami coefficients of the
/// triangles by least squares, and subtracted. Around the triangle, where the expansion fails, 1/z
/// is made harmonic again with its surroundings fixed.
///
/// @param[in] points   #V by 3, about of size one
/// @param[in] strings  cotangentWeights() of the surface
/// @return #V by 3 unit vectors, not centered; triangles may be flipped
/// @throws NumericalFailure if the equations have no usable solution
Points punctureToSphere(const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, Index puncture, const Run& run = {});
}

#endif
