/// Estimate how far vertices of a learned mesh must be shifted before curved triangles are built on
/// it. Own construction: one factor (share) for all vertices is found by least squares, because
/// curved triangles through fitted vertices would be too far outside.

#ifndef ConformalVertexShift_h
#define ConformalVertexShift_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Share for lowerVertices() if there are no samples for an estimate. It preserves the volume.
constexpr double UsualVertexShift = 1.0;
constexpr double MaximumVertexShift = 2.0;

/// Estimate the share for lowerVertices() from the samples to which a mesh was fitted. The share is
/// the sum of two parts.
///
/// The first part minimizes the squared distance of the curved triangles from the samples, and is
/// at most 1, the share that preserves the volume. It is 1 if the samples' foot points cover the
/// triangles evenly, and 0 if the samples are at the vertices.
///
/// The second part corrects for decimated samples. Decimated samples are dense where the object is
/// curved, and lie outside of the object there, since decimation preserved the shape with flat
/// triangles. Only the density of the samples reveals this. The mean move of vertices is computed
/// twice: averaged over the samples, and over the area with samples nearby. The second part is 3
/// times the relative excess of the first mean. The second part is zero for samples whose density
/// is independent of curvature. The factor 3 was measured on decimated scans.
///
/// @param[in] mesh  closed mesh in the samples' own unit
/// @return the share, in [0, MaximumVertexShift], in steps of 1/16; UsualVertexShift for flat
///   surfaces
/// @throws Aborted
double vertexShift(const Mesh& mesh, const TrainingSamples& samples, const Run& run = {});
}

#endif
