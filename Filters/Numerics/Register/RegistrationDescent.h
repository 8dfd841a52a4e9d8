/// Find the map between two surfaces of minimum stretch and best agreement of features.
/// Symmetric Dirichlet energy of \cite Smith2015.

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
/// surface area is that of the unit sphere, 4 pi.
struct SampledSurface
{
  SphereGrid Grid;
  Rows Values; ///< #G by 3 + #K: positions, then features
};

/// Pair of corresponding directions.
struct SpherePair
{
  Vector3 From, To; ///< on the moving and on the fixed surface's sphere, unit vectors
};

struct RegistrationWeights
{
  double Stretch = 1.0;  ///< weight of the symmetric Dirichlet energy
  double Sphere = 0.1;   ///< share of the sphere's metric that is added to those of the surfaces
  double Barrier = 0.02; ///< weight of the sphere's own symmetric Dirichlet energy; that energy is
                         ///< infinite at a fold
  std::vector<double> Features; ///< #K, weights of the squared differences
  double Landmarks = 0.0;       ///< weight of the squared distances
};

struct RegistrationEnergy
{
  double Stretch = 0.0;   ///< symmetric Dirichlet energy; 1 if both surfaces are isometric
  double Barrier = 0.0;   ///< weighted; 0 for a rotation of the sphere
  double Features = 0.0;  ///< weighted mean square difference
  double Landmarks = 0.0; ///< mean square distance
  double Total = 0.0;
};

struct DescentOptions
{
  RegistrationWeights Weights;
  int MaximumNumberOfSteps = 30;
  double Tolerance = 5e-3; ///< ends at this relative decrease of the energy above its minimum
};

/// Move the vertices of the moving surface's sphere to minimize the energy, by projected Newton
/// steps.
///
/// The Hessian of the stretch has its negative part removed. If a step folds triangles, the moves
/// of their vertices are halved until none is folded. Then all moves are shortened until the energy
/// decreases.
///
/// With J the map of a triangle from one surface to the other, the stretch is the mean of (|J|^2 +
/// |J^-1|^2) / 4 over both areas. It is 1 where the map is isometric, and larger elsewhere. The
/// metrics are those of the surfaces plus Sphere times that of the sphere, so that no triangle has
/// zero area.
/// @param[in] pairs       corresponding directions on both spheres
/// @param[in,out] places  #V by 3 unit vectors, of a sphere without folds before and after
/// @return the final energy
/// @throws Aborted
RegistrationEnergy descend(const SampledSurface& moving, const SampledSurface& fixed,
  const std::vector<SpherePair>& pairs, const DescentOptions& options, Points& places,
  const Run& run = {});
}

#endif
