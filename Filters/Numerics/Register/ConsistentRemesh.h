/// Replace the meshes of several surfaces by one common mesh, so that points with equal ids
/// correspond. Each surface has a map to the sphere. The maps are registered: equal directions show
/// corresponding points.
///
/// Own construction, not from a publication: every surface is sampled in the directions of one
/// common mesh of the sphere. This yields corresponding points without any further search.

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
  /// The points are spread evenly over the surfaces. Their density on the sphere is the mean over
  /// all surfaces.
  Adaptive
};

/// Options of remeshConsistently().
struct ConsistentRemeshOptions
{
  RemeshMeshType MeshType = RemeshMeshType::Adaptive;
  int Frequency = 45; ///< frequency f for Geodesic; the mesh has 10 f^2 + 2 points
  /// Requested number of points for Adaptive. The result differs from this number by at most 2
  /// percent.
  Index NumberOfPoints = 20000;
};

/// Surfaces sampled on a common mesh. #S is the number of surfaces and #V the number of points of
/// the common mesh.
struct ConsistentMeshes
{
  /// Common mesh: unit vectors and triangles. The triangles are counter-clockwise on the surfaces
  /// seen from outside.
  Mesh Sphere;
  std::vector<Points> Positions; ///< #S, each #V by 3: surface points in the directions of Sphere
  /// #S matrices, one for each surface: weights of the surface's vertices for each of the #V
  /// points.
  std::vector<ResampleWeights> Weights;
};

/// Sample all surfaces in the directions of one mesh of the sphere.
///
/// For each direction, the triangle of the surface's map that contains the direction is found. The
/// position is interpolated linearly in this triangle.
/// @param[in] surfaces  #S closed surfaces with maps to the sphere, at least one. Isolated points
///   are ignored.
/// @throws std::invalid_argument if a surface is open, or its map does not cover the sphere exactly
///   once
/// @throws std::invalid_argument if only some of the maps are mirrored, or an option is out of
///   range
/// @throws Aborted
ConsistentMeshes remeshConsistently(const std::vector<MappedMesh>& surfaces,
  const ConsistentRemeshOptions& options = {}, const Run& run = {});
}

#endif
