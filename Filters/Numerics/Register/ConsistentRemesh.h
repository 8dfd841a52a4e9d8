/// Remesh surfaces whose sphere maps correspond, on one common mesh. Own construction: all surfaces
/// are sampled in the directions of one mesh of the sphere, because their points then correspond.

#ifndef ConformalConsistentRemesh_h
#define ConformalConsistentRemesh_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Register/ResampleWeights.h"

#include <vector>

namespace conformal
{
/// Distribution of the points of the common mesh on the sphere.
enum class RemeshMeshType
{
  Geodesic, ///< points are spread evenly over the sphere
  /// Points are spread evenly over the surfaces, by the mean of the surfaces' densities on the
  /// sphere.
  Adaptive
};

struct ConsistentRemeshOptions
{
  RemeshMeshType MeshType = RemeshMeshType::Adaptive;
  int Frequency = 45;           ///< frequency f for Geodesic; the mesh has 10 f^2 + 2 points
  Index NumberOfPoints = 20000; ///< number of points for Adaptive, met within 2 percent
};

struct ConsistentMeshes
{
  Mesh Sphere; ///< common mesh of unit vectors; triangles are counter-clockwise on the surfaces
  std::vector<Points> Positions; ///< #S, each #V by 3: surface points in the directions of Sphere
  std::vector<ResampleWeights> Weights; ///< #S, interpolation weights of the points of each surface
};

/// Sample all surfaces in the directions of one mesh of the sphere. A position is interpolated
/// linearly in the triangle of the surface's map that contains the direction, as by
/// resampleSurface().
/// @param[in] surfaces  #S surfaces with maps, at least one; isolated points are ignored
/// @throws std::invalid_argument if a surface is open, a map does not cover the sphere exactly
///   once, only some maps are mirrored, or an option is out of range
/// @throws Aborted
ConsistentMeshes remeshConsistently(const std::vector<MappedMesh>& surfaces,
  const ConsistentRemeshOptions& options = {}, const Run& run = {});
}

#endif
