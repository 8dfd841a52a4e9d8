/// Find a map between two surfaces that has little stretch and makes features agree. Stretch is the
/// symmetric Dirichlet energy of \cite Smith2015.

#ifndef ConformalRegistrationDescent_h
#define ConformalRegistrationDescent_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/SphereSamples.h"
#include "Sphere/SphereStar.h"

#include <vector>

namespace conformal
{
/// Values of a surface in the directions of a geodesic sphere. Positions are scaled so that the
/// surface area is 4 pi, the area of the unit sphere.
struct SampledSurface
{
  SphereGrid Grid;
  Rows Values; ///< #G by 3 + #K, for each vertex of Grid its position, then its features
};

/// Pair of corresponding directions.
struct SpherePair
{
  Vector3 From, To; ///< unit vectors on the sphere of the moving and of the fixed surface
};

struct RegistrationWeights
{
  double Stretch = 1.0; ///< weight of the symmetric Dirichlet energy
  /// Factor of the sphere's metric, which is added to the metrics of the surfaces.
  double Sphere = 0.1;
  /// Weight of the symmetric Dirichlet energy of the map from sphere to sphere, which is infinite
  /// at a fold.
  double Barrier = 0.02;
  std::vector<double> Features; ///< #K, weights of the squared differences of features
  double Landmarks = 0.0;       ///< weight of the squared distances of landmarks
};

struct RegistrationEnergy
{
  double Stretch = 0.0;   ///< symmetric Dirichlet energy; 1 if both surfaces are isometric
  double Barrier = 0.0;   ///< weighted energy of the map from sphere to sphere; 0 for a rotation
  double Features = 0.0;  ///< weighted mean square difference of features
  double Landmarks = 0.0; ///< mean square distance of landmarks
  double Total = 0.0;
};

struct DescentOptions
{
  RegistrationWeights Weights;
  int MaximumNumberOfSteps = 30;
  /// The descent ends if a step decreases the energy by less than this, relative to its excess over
  /// the minimum.
  double Tolerance = 5e-3;
};

/// Minimize the energy by projected Newton steps. Each step moves the vertices of the moving
/// surface's sphere.
///
/// The negative part of the Hessian of the stretch is removed. If a step folds triangles, the moves
/// of their vertices are halved until no triangle is folded. Then all moves are shortened until the
/// energy decreases.
///
/// Let J be the linear map of a triangle from one surface to the other. The stretch is the mean of
/// (|J|^2 + |J^-1|^2) / 4 over the areas of both surfaces. It is 1 for an isometric map, and larger
/// otherwise. The metric of each surface is increased by RegistrationWeights::Sphere times the
/// metric of the sphere, so that no triangle has zero area.
/// @param[in] pairs       corresponding directions on both spheres
/// @param[in,out] places  #V by 3 unit vectors, a sphere mesh without folds before and after
/// @return the final energy
/// @throws Aborted
RegistrationEnergy descend(const SampledSurface& moving, const SampledSurface& fixed,
  const std::vector<SpherePair>& pairs, const DescentOptions& options, Points& places,
  const Run& run = {});
}

#endif
