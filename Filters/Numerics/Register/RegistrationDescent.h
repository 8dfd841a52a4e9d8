/// Find a map between two surfaces by descent, the stepwise minimization of an energy. The energy
/// is low if the map has little stretch, and if features agree at corresponding points. A feature
/// is a number at each point of a surface, such as the curvature. Stretch is measured by the
/// symmetric Dirichlet energy of \cite Smith2015.
///
/// Each surface has a map to the unit sphere. One surface is called moving, the other one fixed.
/// The vertices of the moving surface's sphere are moved. Points of both surfaces correspond if
/// they have the same position on the sphere after this deformation.

#ifndef ConformalRegistrationDescent_h
#define ConformalRegistrationDescent_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/SphereSamples.h"
#include "Sphere/SphereStar.h"

#include <vector>

namespace conformal
{
/// Points of a surface, with features. The points are those that are mapped to the vertices of a
/// geodesic sphere (a subdivided icosahedron). Positions are scaled so that the surface area is 4
/// pi, the area of the unit sphere.
struct SampledSurface
{
  SphereGrid Grid; ///< geodesic sphere with #G vertices
  /// #G rows of 3 + #K columns: for each vertex of Grid the position, then #K feature values.
  Rows Values;
};

/// Landmark: a point of the moving surface, and the corresponding point of the fixed surface. Both
/// points are given by their positions on the sphere. The target of the landmark is the position of
/// the second point.
struct SpherePair
{
  Vector3 From, To; ///< unit vectors on the sphere of the moving and of the fixed surface
};

/// Weights of the terms of the registration energy.
struct RegistrationWeights
{
  double Stretch = 1.0; ///< weight of the symmetric Dirichlet energy
  /// Factor of the sphere's metric in the stretch, see descend(). A metric consists of the dot
  /// products of the edge vectors of each triangle. The sphere's metric times this factor is added
  /// to the metric of each surface.
  double Sphere = 0.1;
  /// Weight of the barrier, an energy term that prevents folds. The barrier is the symmetric
  /// Dirichlet energy of the deformation of the sphere. For a triangle of zero area, the barrier is
  /// infinite.
  double Barrier = 0.02;
  std::vector<double> Features; ///< #K, weights of the squared differences of features
  double Landmarks = 0.0; ///< weight of the squared distances between landmarks and their targets
};

/// Values of the registration energy and of its terms. An isometric map preserves all lengths.
struct RegistrationEnergy
{
  double Stretch = 0.0; ///< stretch of the map, see descend(); 1 if the map is isometric
  /// Weighted barrier against folds, see RegistrationWeights; 0 if the sphere is only rotated.
  double Barrier = 0.0;
  double Features = 0.0; ///< weighted mean square difference of the features of both surfaces
  /// Mean square distance between landmarks and their targets on the unit sphere.
  double Landmarks = 0.0;
  /// Weights.Stretch * Stretch + Barrier + Features + Weights.Landmarks * Landmarks, where Weights
  /// are the RegistrationWeights.
  double Total = 0.0;
};

/// Options of descend().
struct DescentOptions
{
  RegistrationWeights Weights;
  int MaximumNumberOfSteps = 30;
  /// Let E be the energy. The descent ends if a step reduces E by less than Tolerance times (E -
  /// Weights.Stretch). Weights.Stretch is a lower bound of E, because the stretch is at least 1.
  double Tolerance = 5e-3;
};

/// Minimize the registration energy by Newton steps, which move the vertices of the moving
/// surface's sphere. The energy is the sum of the terms in RegistrationEnergy.
///
/// Before each step, negative eigenvalues are removed from the Hessian of the stretch (projected
/// Newton method). With this change, the step points toward lower energies. If a step folds
/// triangles, the moves of the vertices of these triangles are halved until no triangle is folded.
/// Then all moves are shortened until the energy decreases.
///
/// The stretch is defined as follows. Let J be the linear map of a triangle from one surface to the
/// other, and |J| its Frobenius norm. The stretch is the mean of (|J|^2 + |J^-1|^2) / 4 over the
/// areas of both surfaces. The stretch is 1 for an isometric map, and above 1 for any other map. In
/// this definition, the metric of a surface includes RegistrationWeights::Sphere times the metric
/// of the sphere. In this sum of metrics, no triangle has zero area.
/// @param[in] pairs       landmarks: corresponding positions on the spheres of both surfaces
/// @param[in,out] places  #V by 3 unit vectors: positions of the vertices of moving.Grid on the
///   deformed sphere. Precondition: no triangle is folded. The result has no folded triangle,
///   either.
/// @return the energy after the last step
/// @throws Aborted
RegistrationEnergy descend(const SampledSurface& moving, const SampledSurface& fixed,
  const std::vector<SpherePair>& pairs, const DescentOptions& options, Points& places,
  const Run& run = {});
}

#endif
