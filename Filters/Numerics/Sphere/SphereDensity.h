/// Density of points on the sphere. Own construction: densities are functions sampled at
/// directions, because images and surfaces then share one interface.

#ifndef ConformalSphereDensity_h
#define ConformalSphereDensity_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Density of points on the sphere, up to a constant factor.
struct SphereDensity
{
  /// Function that returns the density at a direction, a unit vector. Densities are finite and at
  /// least 0. Several threads may call the function concurrently.
  std::function<double(const Vector3&)> At;

  /// Directions at which the density is sampled. They must be so dense that no detail between the
  /// points of a coarse mesh is missed.
  Points Directions; ///< #D by 3 unit vectors, at least one
  /// #D areas: the part of the sphere that each direction represents, in any unit; finite, at least
  /// 0
  std::vector<double> Areas;
};

/// Evaluate a density at all its Directions.
/// @throws std::invalid_argument if a density is negative or not finite, or if there are no
///   directions
std::vector<double> densitiesOf(const SphereDensity& density, const Run& run = {});

/// Integrate a density over the sphere: the sum of densities times areas.
/// @param[in] densities  result of densitiesOf() for this density
/// @throws std::invalid_argument if all densities are 0, or if the sum overflows
double integralOf(const SphereDensity& density, const std::vector<double>& densities);

/// Convert a density on a surface to a density on the sphere. Where the map shrinks areas by a
/// factor, the density on the sphere is larger by this factor.
///
/// @param[in] surface  surface whose map covers the sphere exactly once, mirrored or not
/// @param[in] weights  #V densities at the vertices of the surface, finite and at least 0; linear
///   between vertices
/// @throws std::invalid_argument if the map does not cover the sphere exactly once
/// @throws Aborted
SphereDensity densityOnSurface(
  const MappedMesh& surface, const std::vector<double>& weights, const Run& run = {});

/// Estimate the bending at each vertex: the sum of the absolute values of the principal curvatures.
/// Half the sum of edge lengths times angles between normals is divided by a third of the area
/// around the vertex.
std::vector<double> vertexBending(const Mesh& surface);

/// Compute weights for densityOnSurface(). They place half of the points evenly over the surface,
/// and the other half in proportion to vertexBending().
std::vector<double> weightsByBending(const Mesh& surface);

/// Average the values of the triangles around each vertex, weighted by the areas of the triangles.
/// The result is 0 for a vertex without triangles.
/// @param[in] values  #F values of the triangles
std::vector<double> vertexMeans(const Mesh& surface, const std::vector<double>& values);

/// Test whether a density is positive at any of its Directions.
/// @throws std::invalid_argument if a density is negative or not finite
bool isAnywhere(const SphereDensity& density, const Run& run = {});

/// Combine densities. Each of them contributes the same number of points to the result.
/// @param[in] densities  densities to combine, at least one
SphereDensity equalShares(const std::vector<SphereDensity>& densities, const Run& run = {});
}

#endif
