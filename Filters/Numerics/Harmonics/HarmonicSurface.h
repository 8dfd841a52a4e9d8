/// Make triangle meshes of surfaces that are given by coefficients of spherical harmonics, as in
/// \cite Brechbuehler1995. Each coordinate of a surface is a sum of spherical harmonics, a function
/// of the direction on the sphere.

#ifndef ConformalHarmonicSurface_h
#define ConformalHarmonicSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Surface with a map to the sphere, and further values at its vertices.
struct HarmonicSurface : MappedMesh
{
  Columns Values; ///< #V rows; one column for each column of coefficients after the positions
};

/// Make a surface by evaluating its coefficients in the directions of the vertices of a geodesic
/// sphere. The triangles are counter-clockwise seen from outside.
/// @param[in] coefficients  (L + 1)^2 rows. The first three columns are coefficients of the
///   positions; further columns are coefficients of other values.
/// @param[in] frequency     frequency of the geodesic sphere, see makeGeodesicSphere()
HarmonicSurface makeHarmonicSurface(
  const Columns& coefficients, int frequency, const Run& run = {});

/// Return the rows of coefficients whose degree is at most `degree`. The result has all rows if no
/// degree is higher.
Columns upToDegree(const Columns& coefficients, int degree);
}

#endif
