/// Reconstruct surfaces from coefficients of spherical harmonics, the representation of
/// \cite Brechbuehler1995.

#ifndef ConformalHarmonicSurface_h
#define ConformalHarmonicSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct HarmonicSurface : MappedMesh
{
  Columns Values; ///< #V rows, with one column for each column of coefficients after the positions
};

/// Make a surface by evaluating its coefficients in the directions of a geodesic sphere. The
/// triangles of the surface are counter-clockwise seen from outside.
/// @param[in] coefficients  (L + 1)^2 by three or more columns: positions, then other values
/// @param[in] frequency     frequency of the geodesic sphere, see makeGeodesicSphere()
HarmonicSurface makeHarmonicSurface(
  const Columns& coefficients, int frequency, const Run& run = {});

/// Return the rows of coefficients up to a degree, or all rows if there are fewer degrees.
Columns upToDegree(const Columns& coefficients, int degree);
}

#endif
