/// Density of points on the sphere. Own construction: densities are sampled at directions, so that
/// images and surfaces share one interface.

#ifndef ConformalSphereDensity_h
#define ConformalSphereDensity_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Density of points on the sphere, up to a factor.
struct SphereDensity
{
  /// Density at a direction, a unit vector: finite, at least 0. Must be safe to call from several
  /// threads.
  std::function<double(const Vector3&)> At;

  /// Directions dense enough to sample every detail of the density between the points of a coarse
  /// mesh.
  Points Directions; ///< #D by 3 unit vectors, at least one
  /// #D areas of the sphere represented by the directions, in any unit; finite, at least 0
  std::vector<double> Areas;
};

/// Evaluate the density in all its directions.
/// @throws std::invalid_argument if a density is negative or not finite, or if there are no
///   directions
std::vector<double> densitiesOf(const SphereDensity& density, const Run& run = {});

/// Integrate a density: sum of densities times areas.
/// @param[in] densities  densitiesOf() the density
/// @throws std::invalid_argument if all densities are 0, or if the sum overflows
double integralOf(const SphereDensity& density, const std::vector<double>& densities);

/// Convert a density on a surface to a density on the sphere. It is larger by the factor by which
/// the map shrinks areas.
///
/// @param[in] surface  a map that covers the sphere exactly once, mirrored or not
/// @param[in] weights  #V, density on the surface: finite, at least 0; linear between vertices
/// @throws std::invalid_argument if the map does not cover the sphere exactly once
/// @throws Aborted
SphereDensity densityOnSurface(
  const MappedMesh& surface, const std::vector<double>& weights, const Run& run = {});

/// Estimate the bending at each vertex: the sum of the absolute values of the principal curvatures.
/// It is half the sum of edge lengths times angles between normals, divided by a third of the area
/// around the vertex.
std::vector<double> vertexBending(const Mesh& surface);

/// Compute weights for densityOnSurface() that place half of the points evenly over the surface.
/// The other half is in proportion to vertexBending().
std::vector<double> weightsByBending(const Mesh& surface);

/// Average the values of the triangles around each vertex, weighted by their areas; 0 for a vertex
/// without triangles.
/// @param[in] values  #F
std::vector<double> vertexMeans(const Mesh& surface, const std::vector<double>& values);

/// Test whether a density is positive in one of its directions.
/// @throws std::invalid_argument if a density is negative or not finite
bool isAnywhere(const SphereDensity& density, const Run& run = {});

/// Combine densities so that each contributes an equal number of points.
/// @param[in] densities  at least one
SphereDensity equalShares(const std::vector<SphereDensity>& densities, const Run& run = {});
}

#endif
