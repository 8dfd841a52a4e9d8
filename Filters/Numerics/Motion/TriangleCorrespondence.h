/// Find the triangles of a source surface that correspond to each triangle of a target surface.
/// Points of both surfaces correspond if they have the same position on the sphere.
///
/// Own construction: \cite Sumner2004 pairs triangles whose centroids are close after one surface
/// is deformed to the other. With maps to the sphere, correspondence is known at every point, so
/// that values of source triangles can be averaged over the area of a target triangle.

#ifndef ConformalTriangleCorrespondence_h
#define ConformalTriangleCorrespondence_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Register/ResampleWeights.h"

namespace conformal
{
/// Options of correspondingTriangles().
struct TriangleCorrespondenceOptions
{
  /// Maximum number n of parts of each edge of a target triangle, at least 1. The triangle is
  /// sampled at the centers of n^2 equal parts. With 1, only the source triangle at the center
  /// corresponds.
  int MaximumSubdivision = 12;
};

/// Correspondence of a target surface to a source surface.
struct SurfaceCorrespondence
{
  /// For each target triangle, the source triangles that cover it, and the fractions of its area.
  ResampleWeights TriangleWeights;
  /// For each target vertex, the corners of the source triangle at its sphere position, weighted by
  /// barycentric coordinates.
  ResampleWeights VertexWeights;
};

/// Find corresponding source triangles of each target triangle, and source positions of each target
/// vertex.
///
/// A target triangle is divided into n^2 equal parts. The number n is 2 sqrt(a / b), rounded up and
/// limited by the options. a is the area of the target triangle on the sphere, and b that of the
/// source triangle at its center. Each source triangle gets the fraction of the parts whose centers
/// it contains.
/// @param[in] source  surface whose map covers the sphere once without folds; triangles are
///   counter-clockwise on the sphere seen from outside
/// @param[in] target  surface with a map to the sphere
/// @throws Aborted
SurfaceCorrespondence correspondingTriangles(const MappedMesh& source, const MappedMesh& target,
  const TriangleCorrespondenceOptions& options = {}, const Run& run = {});
}

#endif
