/// Remesh surfaces whose sphere maps correspond, on one common mesh.
/// Own construction: one mesh of the sphere carries all surfaces.

#ifndef ConformalConsistentRemesh_h
#define ConformalConsistentRemesh_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Register/ResampleWeights.h"

#include <vector>

namespace conformal
{
/// Distribution of the points of the common mesh.
enum class RemeshMeshType
{
  Geodesic, ///< evenly over the sphere
  Adaptive  ///< evenly over the surfaces, by the mean of their densities
};

struct ConsistentRemeshOptions
{
  RemeshMeshType MeshType = RemeshMeshType::Adaptive;
  int Frequency = 45;           ///< Geodesic: 10 f^2 + 2 points
  Index NumberOfPoints = 20000; ///< Adaptive: within 2 percent
};

struct ConsistentMeshes
{
  Mesh Sphere; ///< unit vectors; common triangles, counter-clockwise on the surfaces
  std::vector<Points> Positions; ///< #S, each #V by 3: surface points in the directions of Sphere
  std::vector<ResampleWeights> Weights; ///< #S, interpolation weights of the points of each surface
};

/// Sample all surfaces in the directions of one mesh of the sphere. Positions are interpolated
/// linearly in the triangle that contains the direction, as by resampleSurface().
/// @param[in] surfaces  #S, at least one; isolated points are ignored
/// @throws std::invalid_argument if a surface is open, a map does not cover the sphere exactly
///   once, only some maps are mirrored, or an option is out of range
/// @throws Aborted
ConsistentMeshes remeshConsistently(const std::vector<MappedMesh>& surfaces,
  const ConsistentRemeshOptions& options = {}, const Run& run = {});
}

#endif
