/// Remove self-intersections of a learned surface. At narrow gaps, such as lips and the roots of
/// legs, a fitted surface can have pins that cross its other side. The smoothing is our own
/// construction, not from a publication.

#ifndef ConformalUntangling_h
#define ConformalUntangling_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Smooth a mesh where triangles cross each other, in rounds, until none do. In each round, the
/// vertices of the triangles and of the ring around them move to the mean of their neighbors. A
/// mesh without self-intersections does not change. If the rounds end before all are removed, the
/// round with the fewest is the result.
/// @param[in,out] positions  #V by 3
/// @return number of pairs of triangles that still cross, see selfIntersections()
/// @throws Aborted
Index untangle(Points& positions, const Triangles& triangles, const Run& run = {});
}

#endif
