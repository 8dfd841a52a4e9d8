/// Compute densities of points on the sphere, from which makeAdaptiveSphere() builds a mesh. The
/// representation of a density is our own construction: a function, and the directions at which the
/// function is sampled. Densities from images and from surfaces thus have one interface.

#ifndef ConformalSphereDensity_h
#define ConformalSphereDensity_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Relative density of points on the sphere. Multiplying a density by a constant does not change
/// the mesh built from it.
struct SphereDensity
{
  /// Function that returns the density at a direction, a unit vector. Densities are finite and at
  /// least 0. Several threads may call the function concurrently.
  std::function<double(const Vector3&)> At;

  /// Directions at which the density is sampled. Details of the density that are smaller than the
  /// distance between directions may be missed.
  Points Directions; ///< #D by 3 unit vectors, at least one
  /// #D areas: the part of the sphere that each direction represents, in any unit of area; finite,
  /// at least 0
  std::vector<double> Areas;
};

/// Evaluate a density at all its Directions.
/// @throws std::invalid_argument if a density is negative or not finite, or if there are no
///   directions
std::vector<double> densitiesOf(const SphereDensity& density, const Run& run = {});

/// Integrate a density over the sphere: compute the sum of densities times areas.
/// @param[in] densities  result of densitiesOf() for this density
/// @throws std::invalid_argument if all densities are 0, or if the sum overflows
double integralOf(const SphereDensity& density, const std::vector<double>& densities);

/// Convert a density on a surface to a density on the sphere, by the surface's map to the sphere.
/// If the map reduces an area by a factor, the density is multiplied by this factor.
///
/// @param[in] surface  surface whose map covers the sphere exactly once; the map may reverse
///   orientation
/// @param[in] weights  #V densities at the vertices of the surface, finite and at least 0.
///   Densities are interpolated linearly between vertices.
/// @throws std::invalid_argument if the map does not cover the sphere exactly once
/// @throws Aborted
SphereDensity densityOnSurface(
  const MappedMesh& surface, const std::vector<double>& weights, const Run& run = {});

/// Estimate the bending at each vertex: the sum of the absolute values of the principal curvatures.
/// The bending of an edge is its length times the angle between the normals of its two triangles.
/// Let E be the sum of the bending of all edges at the vertex. Let A be the area of all triangles
/// at the vertex. The estimate is (E / 2) / (A / 3), because an edge has two vertices, and a
/// triangle has three.
std::vector<double> vertexBending(const Mesh& surface);

/// Compute weights for densityOnSurface() from the bending of the surface. In a mesh built with
/// these weights, half of the points are distributed evenly over the surface. The other half has a
/// density proportional to vertexBending().
std::vector<double> weightsByBending(const Mesh& surface);

/// Compute the mean of the values of the triangles around each vertex, weighted by the areas of the
/// triangles. If a vertex has no triangles, the result is 0.
/// @param[in] values  #F values of the triangles
std::vector<double> vertexMeans(const Mesh& surface, const std::vector<double>& values);

/// Test whether a density is positive at one or more of its Directions.
/// @throws std::invalid_argument if a density is negative or not finite
bool isAnywhere(const SphereDensity& density, const Run& run = {});

/// Add densities, each divided by its integral. Each density thus contributes the same number of
/// points to a mesh.
/// @param[in] densities  densities to add, at least one
SphereDensity equalShares(const std::vector<SphereDensity>& densities, const Run& run = {});
}

#endif
