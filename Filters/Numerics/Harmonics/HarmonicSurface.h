/// Surfaces reconstructed from spherical harmonics.
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
  Columns Values; ///< #V by the number of further columns of coefficients
};

/// Evaluate harmonics on a geodesic sphere. Triangles are counter-clockwise seen from outside of
/// the resulting surface.
/// @param[in] coefficients  (L + 1)^2 by three or more: of positions, then of other values
/// @param[in] frequency     see makeGeodesicSphere()
HarmonicSurface makeHarmonicSurface(
  const Columns& coefficients, int frequency, const Run& run = {});

/// Return the coefficients up to a degree, or all if there are fewer degrees.
Columns upToDegree(const Columns& coefficients, int degree);
}

#endif
