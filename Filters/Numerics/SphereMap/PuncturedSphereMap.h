/// Conformal map of a closed surface to the sphere by one linear solve.

#ifndef ConformalPuncturedSphereMap_h
#define ConformalPuncturedSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"

namespace conformal
{
/// Choose the triangle to remove (the puncture). It is nearly equilateral, as are the triangles
/// around it, and does not lie at a limb end. A puncture at a limb end would make the map of the
/// rest of the surface too small.
Index choosePuncture(const Points& points, const Triangles& triangles);

/// Choose another triangle to remove: nearly equilateral, and enlarged the most by a given sphere
/// map.
Index choosePuncture(
  const Points& points, const Triangles& triangles, const Points& spherePositions);

/// Map a closed surface to the sphere, as in \cite Haker2000 and \cite Choi2015. One triangle, the
/// puncture, is removed and laid into a plane. All other vertices are mapped into this triangle.
/// The plane is then projected to the sphere.
///
/// The removed triangle keeps its shape in the plane. The edges pull on the other vertices as
/// strings with the given weights, until every vertex is at equilibrium. The finite size of the
/// triangle distorts the map. This distortion is corrected, and the map is solved again around the
/// triangle.
///
/// Implementation note: \cite Choi2015 solves a second global system for this correction. Here the
/// error is expanded. Far from the triangle, the discrete solution equals the exact one plus
/// positive powers of z and of its conjugate. The smaller the triangle, the faster the coefficients
/// decrease with the power. Only the powers of the conjugate are not conformal. Their coefficients
/// are fitted to the Beltrami coefficients of the triangles by least squares, and these terms are
/// subtracted. Around the triangle the expansion is not valid. There 1/z is made harmonic again,
/// with fixed values at the border of this region.
///
/// @param[in] points   #V by 3 positions, of size about 1
/// @param[in] strings  weights of the edges: result of cotangentWeights() for the surface
/// @return #V by 3 unit vectors; they are not centered, and triangles may be flipped
/// @throws NumericalFailure if the equations have no usable solution
Points punctureToSphere(const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, Index puncture, const Run& run = {});
}

#endif
