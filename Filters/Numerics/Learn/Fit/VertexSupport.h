/// Measure the support of each vertex of a learned surface: whether there are samples near it, on
/// its side of the surface. Support is our own construction, not from a publication.

#ifndef ConformalVertexSupport_h
#define ConformalVertexSupport_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"

#include <vector>

namespace conformal
{
/// Compute the support of each vertex by nearby samples. Let s be the distance from the nearest
/// sample to its sixth neighbor, about 1.4 spacings. If the nearest sample is closer than 1.6 s,
/// the support is 1. If the nearest sample is farther than 2.4 s, the support is 0. In between, the
/// support changes smoothly. Chance leaves no gaps of this size among evenly distributed samples.
/// The distance s is limited to the range from half to four times its median.
///
/// Only samples on the vertex' side of the surface are used: samples whose closest triangle faces
/// the same way as the vertex. The two sides of a thin sheet are thus told apart. If the samples
/// are on scan lines, s is the spacing of the lines. At most 4 samples for each vertex are used.
/// All ranks return the same values.
/// @param[in] positions  #V by 3, in the samples' unit (maximum radius 1)
/// @param[in] triangles  #F by 3
/// @return #V values in [0, 1]
/// @throws Aborted
std::vector<double> supportOfVertices(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const Run& run = {});
}

#endif
