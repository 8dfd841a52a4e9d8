/// Replace the meshes of several surfaces by one common mesh, so that points with equal ids
/// correspond. Each surface has a map to the unit sphere. The position of a surface point on the
/// sphere is called its direction. The maps are registered: points of different surfaces with the
/// same direction correspond.
///
/// Own construction, not from a publication: the vertices of one mesh of the sphere are directions
/// for all surfaces. The surface points with these directions correspond, without any further
/// search.

#ifndef ConformalConsistentRemesh_h
#define ConformalConsistentRemesh_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Register/ResampleWeights.h"

#include <vector>

namespace conformal
{
/// Density of the points of the common mesh on the sphere.
enum class RemeshMeshType
{
  Geodesic, ///< geodesic sphere (a subdivided icosahedron), with equal density everywhere
  /// Triangles whose sides have about equal lengths on the surfaces, in the root mean square over
  /// all surfaces, see remeshByMeanMetric()
  Adaptive
};

/// Options of remeshConsistently().
struct ConsistentRemeshOptions
{
  RemeshMeshType MeshType = RemeshMeshType::Adaptive;
  /// If MeshType is Geodesic: frequency f of the mesh, which has 10 f^2 + 2 points.
  int Frequency = 45;
  /// If MeshType is Adaptive: requested number of points. The number of points of the result
  /// differs from this number by at most 2 percent.
  Index NumberOfPoints = 20000;
};

/// Points of all surfaces with the directions of a common mesh. There are #S surfaces. The common
/// mesh has #V points.
struct ConsistentMeshes
{
  /// Common mesh: unit vectors (directions) and triangles. Seen from outside, the triangles are
  /// counter-clockwise on the surfaces. If the maps are mirrored (reverse the orientation), the
  /// triangles are clockwise on the sphere.
  Mesh Sphere;
  std::vector<Points> Positions; ///< #S, each #V by 3: surface points with the directions of Sphere
  /// #S matrices, one for each surface. Row i contains the interpolation weights of the surface's
  /// vertices at point i of the common mesh.
  std::vector<ResampleWeights> Weights;
};

/// Find the points of all surfaces whose directions are the vertices of one common mesh of the
/// sphere.
///
/// For each direction and each surface, find the triangle that contains the direction on the
/// sphere. The position of the surface point is interpolated linearly in this triangle.
/// @param[in] surfaces  #S closed surfaces with maps to the sphere, at least one. Points without
///   triangles are ignored.
/// @throws std::invalid_argument if a surface is open, or its map does not cover the sphere exactly
///   once
/// @throws std::invalid_argument if only some of the maps are mirrored, or an option is out of
///   range
/// @throws Aborted
ConsistentMeshes remeshConsistently(const std::vector<MappedMesh>& surfaces,
  const ConsistentRemeshOptions& options = {}, const Run& run = {});
}

#endif
