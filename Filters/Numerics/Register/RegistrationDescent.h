/// Find a map between two surfaces that has little stretch and makes features agree. A feature is a
/// number at each point of a surface, such as the curvature. Stretch is measured by the symmetric
/// Dirichlet energy of \cite Smith2015.
///
/// Each surface has a map to the unit sphere. One surface is called moving, the other one fixed.
/// The map between the surfaces is represented by a deformation of the moving surface's sphere.

#ifndef ConformalRegistrationDescent_h
#define ConformalRegistrationDescent_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/SphereSamples.h"
#include "Sphere/SphereStar.h"

#include <vector>

namespace conformal
{
/// Surface sampled in the directions of the vertices of a geodesic sphere. Positions are scaled so
/// that the surface area is 4 pi, the area of the unit sphere.
struct SampledSurface
{
  SphereGrid Grid; ///< geodesic sphere with #G vertices
  /// #G rows of 3 + #K columns: for each vertex of Grid the position, then #K feature values.
  Rows Values;
};

/// Landmark: direction on the sphere of each surface. Both directions show corresponding points.
struct SpherePair
{
  Vector3 From, To; ///< unit vectors on the sphere of the moving and of the fixed surface
};

/// Weights of the terms of the registration energy.
struct RegistrationWeights
{
  double Stretch = 1.0; ///< weight of the symmetric Dirichlet energy
  /// Factor by which the metric of the sphere is multiplied. The product is added to the metric of
  /// each surface before the stretch is computed.
  double Sphere = 0.1;
  /// Weight of the barrier: the symmetric Dirichlet energy of the deformation of the sphere. The
  /// barrier prevents folds, because this energy is infinite for a triangle of zero area.
  double Barrier = 0.02;
  std::vector<double> Features; ///< #K, weights of the squared differences of features
  double Landmarks = 0.0;       ///< weight of the squared distances of landmarks
};

/// Values of the registration energy and of its terms.
struct RegistrationEnergy
{
  double Stretch = 0.0;   ///< symmetric Dirichlet energy; 1 if both surfaces are isometric
  double Barrier = 0.0;   ///< weighted energy of the sphere's deformation; 0 for a rotation
  double Features = 0.0;  ///< weighted mean square difference of the features of both surfaces
  double Landmarks = 0.0; ///< mean square distance of landmarks on the unit sphere
  double Total = 0.0;     ///< weighted sum of all terms
};

/// Options of descend().
struct DescentOptions
{
  RegistrationWeights Weights;
  int MaximumNumberOfSteps = 30;
  /// The descent ends if a step reduces the energy by less than Tolerance times (energy -
  /// Weights.Stretch). The energy is never below Weights.Stretch.
  double Tolerance = 5e-3;
};

/// Minimize the registration energy by projected Newton steps, which move the vertices of the
/// moving surface's sphere.
///
/// Before each step, negative eigenvalues are removed from the Hessian of the stretch. If a step
/// folds triangles, the moves of their vertices are halved until no triangle is folded. Then all
/// moves are shortened until the energy decreases.
///
/// The stretch is defined as follows. Let J be the linear map of a triangle from one surface to the
/// other. The stretch is the mean of (|J|^2 + |J^-1|^2) / 4 over the areas of both surfaces. The
/// stretch is 1 for an isometric map, and above 1 for any other map. Before J is computed,
/// RegistrationWeights::Sphere times the metric of the sphere is added to the metric of each
/// surface. Thus no triangle has zero area.
/// @param[in] pairs       landmarks: corresponding directions on the spheres of both surfaces
/// @param[in,out] places  #V by 3 unit vectors: vertices of the moving surface's sphere mesh. The
///   mesh has no folds before or after the call.
/// @return the energy after the last step
/// @throws Aborted
RegistrationEnergy descend(const SampledSurface& moving, const SampledSurface& fixed,
  const std::vector<SpherePair>& pairs, const DescentOptions& options, Points& places,
  const Run& run = {});
}

#endif
