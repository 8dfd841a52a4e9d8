/// Map a closed surface of genus zero conformally to the sphere by linear equations,
/// \cite Haker2000.

#ifndef ConformalPuncturedSphereMap_h
#define ConformalPuncturedSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Linear/EdgeWeights.h"

#include <vector>

namespace conformal
{
/// Choose the triangle to remove before the surface is mapped (the puncture). The triangle is
/// nearly equilateral, as are the triangles around it. The puncture is not at the end of a limb
/// (long, thin part of a shape). A puncture at the end of a limb would make all other triangles on
/// the sphere too small for double precision.
Index choosePuncture(const Points& points, const Triangles& triangles);

/// Choose another puncture, given a map of the surface to the sphere. The result is the triangle
/// that the map enlarges most: its area on the sphere, relative to its area on the surface, is
/// largest. Enlargements are weighted so that nearly equilateral triangles are preferred.
Index choosePuncture(
  const Points& points, const Triangles& triangles, const Points& spherePositions);

/// Map a closed surface to the sphere, as in \cite Haker2000 and \cite Choi2015. One triangle, the
/// puncture, is removed and mapped to a triangle of the same shape in a plane. All other vertices
/// are mapped to the inside of this triangle. Finally, the plane is mapped to the sphere by
/// stereographic projection.
///
/// The positions in the plane are a harmonic map: each vertex is the weighted mean of its
/// neighbors. With cotangent weights, harmonic maps to the plane are nearly conformal. However, the
/// finite size of the puncture distorts the map. This distortion is corrected far from the
/// puncture. Positions near the puncture are then computed again by linear equations.
///
/// Implementation note: for this correction, \cite Choi2015 solves a second global system of
/// equations. Here, the distortion is written as a power series instead. Let z be the complex
/// coordinate of the plane, with the puncture far from z = 0. Far from the puncture, the error of z
/// is a sum of positive powers of z and of its conjugate. The smaller the puncture, the faster the
/// coefficients decrease with the exponent. Powers of z are conformal, and need no correction. The
/// coefficients of the conjugate's powers are fitted by least squares to the Beltrami coefficients
/// (measures of non-conformality) of the triangles. The fitted terms are then subtracted from z.
/// The series is not valid near the puncture, where |z| is large. There, 1/z is computed again as a
/// harmonic function. At the border of the region near the puncture, the values of 1/z are fixed.
///
/// @param[in] points   #V by 3 positions with coordinates of magnitude about 1
/// @param[in] strings  weights of the edges: result of cotangentWeights() for the surface
/// @return #V by 3 unit vectors. The mean of these vectors is in general not 0, and triangles may
///   be flipped.
/// @throws NumericalFailure if the equations have no finite solution
Points punctureToSphere(const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, Index puncture, const Run& run = {});

/// Choose the puncture of a sheet (connected surface with one border and without handles): a
/// triangle with exactly one edge on the border, nearly equilateral like the triangles around it,
/// where the border is nearly straight.
/// @param[in] border  marks of the vertices on the border, see borderVertices()
/// @return id of the triangle, or -1 if there is no such triangle
Index chooseBorderPuncture(
  const Points& points, const Triangles& triangles, const std::vector<char>& border);

/// Map a sheet to the hemisphere z >= 0, with the border on the equator. This is the map of
/// punctureToSphere() for the sheet glued to its mirror image, with a puncture that is its own
/// mirror image. By symmetry, only the unknowns of the sheet are computed. In the plane, the border
/// is on the real axis: imaginary parts are 0 there, and real parts have no derivative across the
/// border.
/// @param[in] strings   weights of the edges: result of cotangentWeights() for the sheet
/// @param[in] border    marks of the vertices on the border
/// @param[in] puncture  triangle with exactly one edge on the border
/// @return #V by 3 unit vectors, with z = 0 exactly on the border
/// @throws NumericalFailure if the equations have no finite solution
Points punctureToHemisphere(const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, const std::vector<char>& border, Index puncture, const Run& run = {});
}

#endif
