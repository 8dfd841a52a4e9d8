/// Continue a learned surface smoothly where there are no samples: in holes of the cloud, and
/// between scan lines. The energy is that of a thin plate, as in \cite Kobbelt1998; the rule for
/// the vertices is our own construction.

#ifndef ConformalSmoothFilling_h
#define ConformalSmoothFilling_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

namespace conformal
{
/// Move the vertices of a surface that have no samples nearby, so that the surface has the least
/// sum of squares of its Laplacian: at each vertex, the sum of the differences from the neighbors.
/// The surface continues with the slope and the curvature that it has at samples. The fit alone
/// makes the surface flat there.
///
/// A base on which the object stood is then made flat, see flattenBases() in FlatBases.h.
///
/// A spacing is the side of the square of the surface that a sample represents. Vertices farther
/// than 1.5 spacings and three standard deviations of the noise from all samples are moved. Nothing
/// is moved if fewer than 0.2 % of the vertices are farther than two spacings and four standard
/// deviations, since evenly distributed samples have no such gaps. At most 4 samples for each
/// vertex are used. All ranks return equal results.
/// @param[in] noise  standard deviation of the noise, in the samples' unit
/// @param[in,out] positions  #V by 3, in the samples' unit (maximum radius 1)
/// @return number of vertices that were moved
/// @throws Aborted
Index fillSmoothly(const TrainingSamples& samples, double noise, Points& positions,
  const Triangles& triangles, const Run& run = {});
}

#endif
