/// Finds the map between two surfaces that stretches least and agrees on features.
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
/// What both surfaces have in the directions of a geodesic sphere. Positions are of a surface whose
/// area is that of the unit sphere.
struct SampledSurface
{
  SphereGrid Grid;
  Rows Values; ///< #G by 3 + #K: positions, then features
};

/// A pair of places that are to correspond.
struct SpherePair
{
  Vector3 From, To; ///< on the moving and on the fixed surface's sphere, unit vectors
};

struct RegistrationWeights
{
  double Stretch = 1.0;         ///< of the symmetric Dirichlet energy
  double Sphere = 0.1;          ///< of the sphere's metric in the surfaces'
  double Barrier = 0.02;        ///< of the symmetric Dirichlet energy of the sphere itself, which
                                ///< grows without limit where a triangle is about to fold
  std::vector<double> Features; ///< #K, of the squared differences
  double Landmarks = 0.0;       ///< of the squared distances
};

struct RegistrationEnergy
{
  double Stretch = 0.0;   ///< symmetric Dirichlet energy; 1 if both surfaces are isometric
  double Barrier = 0.0;   ///< weighted, 0 where the sphere is only turned
  double Features = 0.0;  ///< weighted mean square difference
  double Landmarks = 0.0; ///< mean square distance
  double Total = 0.0;
};

struct DescentOptions
{
  RegistrationWeights Weights;
  int MaximumNumberOfSteps = 30;
  double Tolerance = 5e-3; ///< relative fall of what the energy is above its least
};

/// Move the vertices of the moving surface's sphere to where the energy is least, by Newton steps
/// without the negative part of the stretch's second derivatives: first each vertex of a folded
/// triangle goes back by halves until none is, then all are shortened until the energy falls.
///
/// With J the map of a triangle from one surface to the other, the stretch is the mean of
/// (|J|^2 + |J^-1|^2) / 4 over both areas: 1 where the map keeps lengths, and more elsewhere. The
/// metrics are those of the surfaces and, times Sphere, of the sphere, so that no triangle is
/// without area.
/// @param[in] pairs       places on both spheres that are to correspond
/// @param[in,out] places  #V by 3 unit vectors, of a sphere without folds; so they stay
/// @return the energy that is left
/// @throws Aborted
RegistrationEnergy descend(const SampledSurface& moving, const SampledSurface& fixed,
  const std::vector<SpherePair>& pairs, const DescentOptions& options, Points& places,
  const Run& run = {});
}

#endif
