/// Estimate how far vertices of a learned mesh must be shifted before curved triangles are built on
/// the mesh. On ridges, the vertices of a mesh that was fitted to points are outside of the points.
/// Curved triangles through these vertices would be too far outside. The method is an own
/// construction, not from a publication. One factor for all vertices, called share, is found by
/// least squares.

#ifndef ConformalVertexShift_h
#define ConformalVertexShift_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Factor for lowerVertices() (CurvedTriangles.h) if there are no samples for an estimate. With
/// this factor, the curved triangles enclose about the volume of the flat triangles.
constexpr double UsualVertexShift = 1.0;
/// Upper bound of the factor for lowerVertices().
constexpr double MaximumVertexShift = 2.0;

/// Estimate the factor (share) for lowerVertices() from the samples to which a mesh was fitted.
/// lowerVertices() moves vertices inward on ridges and outward in hollows. The share is the sum of
/// two parts.
///
/// The first part is the share that minimizes the sum of squared distances between the curved
/// triangles and the samples. The first part is in [0, 1]. If the foot points (closest points) of
/// the samples cover the flat triangles evenly, the first part is 1. If the samples are at the
/// vertices, the first part is 0.
///
/// The second part is a correction for decimated samples, the vertices of a dense mesh that was
/// reduced to fewer triangles. Decimation keeps more samples where the object is curved. There,
/// decimation also places samples outside of the object, so that the flat triangles between the
/// samples preserve the shape. Decimation can be detected only by the density of the samples.
///
/// To detect decimation, the distance by which lowerVertices() moves vertices at share 1 is
/// averaged in two ways. Mean A is over the samples. Mean B is over the area with samples nearby.
/// If A > B, the second part is 3 (A / B - 1). Otherwise, the second part is 0. If the density of
/// the samples does not depend on curvature, A and B are nearly equal. The factor 3 was measured on
/// decimated scans.
///
/// @param[in] mesh  closed mesh in the unit of the original points
/// @param[in] samples  points to which the mesh was fitted
/// @return the share, in [0, MaximumVertexShift], in steps of 1/16. If the surface is flat, return
///   UsualVertexShift.
/// @throws Aborted
double vertexShift(const Mesh& mesh, const TrainingSamples& samples, const Run& run = {});
}

#endif
