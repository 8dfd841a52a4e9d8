/// Surfaces made of spherical harmonics.
/// Representation of \cite Brechbuehler1995.

#ifndef ConformalHarmonicSurface_h
#define ConformalHarmonicSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct HarmonicSurface : MappedMesh
{
  Columns Values; ///< #V by the columns of coefficients behind the first three
};

/// A geodesic sphere put to where harmonics have it, with its triangles counter-clockwise seen from
/// outside of what it encloses.
/// @param[in] coefficients  (L + 1)^2 by three or more: of positions, then of other values
/// @param[in] frequency     see makeGeodesicSphere
HarmonicSurface makeHarmonicSurface(
  const Columns& coefficients, int frequency, const Run& run = {});

/// The coefficients up to a degree, or all if there are no more.
Columns upToDegree(const Columns& coefficients, int degree);
}

#endif
