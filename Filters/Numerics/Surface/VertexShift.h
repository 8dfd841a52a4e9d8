/// Estimate how far vertices of a learned mesh must be shifted before curved triangles are built on
/// the mesh. Curved triangles through fitted vertices would be too far outside. The method is an
/// own construction, not from a publication. One factor (share) for all vertices is found by least
/// squares.

#ifndef ConformalVertexShift_h
#define ConformalVertexShift_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Factor for lowerVertices() if there are no samples for an estimate. This factor preserves the
/// volume.
constexpr double UsualVertexShift = 1.0;
constexpr double MaximumVertexShift = 2.0;

/// Estimate the factor (share) for lowerVertices() from the samples to which a mesh was fitted. The
/// share is the sum of two parts.
///
/// The first part minimizes the squared distance between the curved triangles and the samples. The
/// range of this part is [0, 1]. The share 1 preserves the volume. This part is 1 if the foot
/// points (closest points) of the samples cover the triangles evenly. This part is 0 if the samples
/// are at the vertices.
///
/// The second part corrects for decimated samples. Decimation keeps more samples where the object
/// is curved, and places them outside of the object there. Flat triangles between the samples then
/// preserve the shape. Only the density of the samples reveals decimation.
///
/// Two means are therefore computed of the distance by which lowerVertices() moves vertices. The
/// first is averaged over the samples, the second over the area with samples nearby. If the first
/// mean is larger, the second part is 3 times the relative excess. Otherwise, the second part is 0,
/// as for samples whose density is independent of curvature. The factor 3 was measured on decimated
/// scans.
///
/// @param[in] mesh  closed mesh in the unit of the original points
/// @param[in] samples  points to which the mesh was fitted
/// @return the share, in [0, MaximumVertexShift], in steps of 1/16. If the surface is flat, return
///   UsualVertexShift.
/// @throws Aborted
double vertexShift(const Mesh& mesh, const TrainingSamples& samples, const Run& run = {});
}

#endif
