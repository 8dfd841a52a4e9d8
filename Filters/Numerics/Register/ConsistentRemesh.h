/// Surfaces whose maps to the sphere correspond, on one mesh.
/// Own construction: one mesh of the sphere carries all surfaces.

#ifndef ConformalConsistentRemesh_h
#define ConformalConsistentRemesh_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Register/ResampleWeights.h"

#include <vector>

namespace conformal
{
/// Where the common mesh has its points.
enum class RemeshMeshType
{
  Geodesic, ///< evenly over the sphere
  Adaptive  ///< evenly over the surfaces, as dense as the mean of their densities
};

struct ConsistentRemeshOptions
{
  RemeshMeshType MeshType = RemeshMeshType::Adaptive;
  int Frequency = 45;           ///< Geodesic: 10 f^2 + 2 points
  Index NumberOfPoints = 20000; ///< Adaptive: within 2 percent
};

struct ConsistentMeshes
{
  Mesh Sphere; ///< unit vectors, and the triangles of all: counter-clockwise on the surfaces
  std::vector<Points> Positions;        ///< #S, each #V by 3: the surfaces in these directions
  std::vector<ResampleWeights> Weights; ///< #S, of the points of each surface
};

/// The points of all surfaces in the directions of one mesh of the sphere, by linear interpolation
/// in the triangle that holds the direction, as by resample().
/// @param[in] surfaces  #S, at least one; isolated points do not count
/// @throws std::invalid_argument if a surface is open, a map does not cover the sphere exactly
/// once,
///   some maps mirror their surfaces and others do not, or an option is out of range
/// @throws Aborted
ConsistentMeshes remeshConsistently(const std::vector<MappedMesh>& surfaces,
  const ConsistentRemeshOptions& options = {}, const Run& run = {});
}

#endif
