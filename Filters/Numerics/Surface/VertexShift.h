/// Estimate the shift of the vertices of a learned mesh under curved triangles.
/// Own construction: one share for all vertices, by least squares.

#ifndef ConformalVertexShift_h
#define ConformalVertexShift_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Share for lowerVertices() without samples to estimate it; preserves the volume.
constexpr double UsualVertexShift = 1.0;
constexpr double MaximumVertexShift = 2.0;

/// Estimate the share for lowerVertices() from the samples to which a mesh was fitted. It is the
/// sum of two parts.
///
/// The first part minimizes the squared distance of the curved triangles from the samples, up to
/// the share that preserves the volume. It is 1 for samples with foot points all over the
/// triangles, and 0 for samples at the vertices.
///
/// The second part corrects for decimated samples. These are dense where the object is curved and
/// lie outside of it there, since their flat triangles preserved its shape. Only their density
/// reveals this. The mean move of a vertex is computed twice, over the samples and over the area
/// with samples nearby. The second part is 3 times the relative excess of the first mean. It is
/// zero for samples whose density is independent of curvature. The factor 3 was measured on
/// decimated scans.
///
/// @param[in] mesh  closed, in the samples' own unit
/// @return in [0, MaximumVertexShift], in steps of 1/16; UsualVertexShift for flat surfaces
/// @throws Aborted
double vertexShift(const Mesh& mesh, const TrainingSamples& samples, const Run& run = {});
}

#endif
