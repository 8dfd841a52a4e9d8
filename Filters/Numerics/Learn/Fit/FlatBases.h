/// Close the base of an object by a plane, where the scanner saw nothing because the object stood
/// on it. Own construction, not from a publication: a smooth continuation of steep sides would
/// bulge.

#ifndef ConformalFlatBases_h
#define ConformalFlatBases_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Move the vertices of flat bases onto planes. A base is a connected part of the surface without
/// samples. It is flat if the following conditions hold:
/// - Its border is one loop, and near a plane.
/// - No samples are beyond this plane, as if the object stood on it.
/// - The surface around it forms an angle of at least 84 degrees with the plane. The bottom of a
///   ball or the missing end of an ellipsoid, for example, is not flat.
/// - It is at most 22 % of the surface. A larger part is a side that no scanner saw.
///
/// The plane is moved to the outermost samples near the border, or beyond them. Vertices are
/// distributed evenly on the plane. A base stays as it is if this would turn triangles over.
/// @param[in] samples  all samples, or an even selection, equal on all ranks
/// @param[in] gap      ids of the vertices without samples nearby, ascending
/// @param[in] spacing  distance of neighboring samples, or of scan lines
/// @param[in] beyond   expected distance of the base from the outermost samples
/// @param[in,out] positions  #V by 3
/// @return number of flat bases
/// @throws Aborted
Index flattenBases(const Points& samples, const std::vector<int>& gap, double spacing,
  double beyond, Points& positions, const Triangles& triangles, const Run& run = {});
}

#endif
