/// How many points are wanted where on the sphere.

#ifndef ConformalSphereDensity_h
#define ConformalSphereDensity_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <vector>

namespace conformal
{
/// A density of points on the sphere. Only its ratios count.
struct SphereDensity
{
  /// Points for an area at a direction, a unit vector: finite, at least 0. May be asked by many
  /// threads.
  std::function<double(const Vector3&)> At;

  /// Directions close enough for no detail of the density to be missed between the points of a
  /// coarse mesh, and the area of the sphere that each of them stands for, in any unit.
  Points Directions;         ///< #D by 3 unit vectors, at least one
  std::vector<double> Areas; ///< #D, finite, at least 0
};

/// The densities in all of the directions.
/// @throws std::invalid_argument if one is negative or not finite, or if there are none
std::vector<double> densitiesOf(const SphereDensity& density, const Run& run = {});

/// Densities times areas, added up.
/// @param[in] densities  densitiesOf the density
/// @throws std::invalid_argument if they are 0 everywhere, or too many
double integralOf(const SphereDensity& density, const std::vector<double>& densities);

/// A density whose points are spread over a surface: as a density on the sphere it is larger by as
/// much as the map makes the surface smaller.
///
/// @param[in] surface  a map that covers the sphere exactly once, mirrored or not
/// @param[in] weights  #V, points for an area of the surface: finite, at least 0; linear in between
/// @throws std::invalid_argument if the map does not cover the sphere so
/// @throws Aborted
SphereDensity densityOnSurface(
  const MappedMesh& surface, const std::vector<double>& weights, const Run& run = {});

/// For each vertex of a surface by how much it bends there, as the absolute values of the principal
/// curvatures added up: half of the angles at its edges times their lengths, for a third of the
/// area around.
std::vector<double> vertexBending(const Mesh& surface);

/// Weights for densityOnSurface() with which half of the points lie evenly over the surface, half
/// in proportion to vertexBending().
std::vector<double> weightsByBending(const Mesh& surface);

/// The mean of the triangles' values around each vertex, weighted by their areas; 0 where there are
/// none.
/// @param[in] values  #F
std::vector<double> vertexMeans(const Mesh& surface, const std::vector<double>& values);

/// Whether a density is above 0 in one of the directions.
/// @throws std::invalid_argument if one is negative or not finite
bool isAnywhere(const SphereDensity& density, const Run& run = {});

/// A density of which each of several makes up as many points.
/// @param[in] densities  at least one
SphereDensity equalShares(const std::vector<SphereDensity>& densities, const Run& run = {});
}

#endif
