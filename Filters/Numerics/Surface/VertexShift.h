/// How far the vertices of a learned mesh are to be moved under curved triangles.
/// Own construction: one share for all vertices, by least squares.

#ifndef ConformalVertexShift_h
#define ConformalVertexShift_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// What lowerVertices() takes where nothing is known of the samples: the volume is kept.
constexpr double UsualVertexShift = 1.0;
constexpr double MaximumVertexShift = 2.0;

/// The share for lowerVertices(), found from the samples that a mesh was fitted to.
///
/// It is the sum of two parts. The first brings the curved triangles as close to the samples as it
/// can, in the sense of least squares, but keeps the volume at most: it is 1 where these have their
/// feet anywhere on the triangles, and 0 where they are the vertices.
///
/// The second is for samples that a decimation has left. These crowd where the object bends, and
/// lie outside of it there, since their own flat triangles kept its shape. No sample tells, but the
/// crowding does: the second part is 3 times the relative excess of the mean size of a vertex's
/// move over the samples, compared with that over the area that has samples near. Samples that are
/// spread without regard to curvature have none. The factor was found on decimated scans.
///
/// @param[in] mesh  closed, in the samples' own unit
/// @return in [0, MaximumVertexShift], in steps of 1/16; UsualVertexShift where nothing bends
/// @throws Aborted
double vertexShift(const Mesh& mesh, const TrainingSamples& samples, const Run& run = {});
}

#endif
