/// Register one mapped surface with another: deform its map to the sphere so that equal directions
/// correspond. Own construction: several rotations are tried, then refined on coarse to fine
/// spheres, because a single descent may end in a poor local minimum.

#ifndef ConformalSphericalRegistration_h
#define ConformalSphericalRegistration_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Register/RegistrationDescent.h"
#include "Register/SphereSamples.h"

#include <utility>
#include <vector>

namespace conformal
{
enum class SpaceOfTransforms
{
  Rotation,     ///< preserves angles and areas of the map
  Moebius,      ///< preserves angles
  Diffeomorphic ///< one to one and smooth
};

struct SphericalRegistrationOptions
{
  SpaceOfTransforms Space = SpaceOfTransforms::Diffeomorphic;
  double ShapeWeight = 1.0;   ///< weight of the built-in features of the surfaces; 0 to ignore them
  double StretchWeight = 1.0; ///< weight of the symmetric Dirichlet energy; above 0
  /// Frequency of the finest geodesic sphere that is deformed, at least 8.
  int Frequency = 16;
};

/// Surface with a map that covers the sphere once without folds.
struct RegisteredSurface
{
  MappedMesh Surface;
  Rows Features; ///< #V by #K finite numbers, which registration matches between both surfaces
};

struct SphericalRegistrationResult
{
  Points SpherePositions; ///< #V by 3 unit vectors, the new map of the moving surface
  double Stretch = 0.0;   ///< symmetric Dirichlet energy; 1 if the surfaces are isometric
  /// Maximum distance between corresponding landmarks, on the unit sphere.
  double LandmarkError = 0.0;
  double AgreementBefore = 1.0; ///< weighted mean correlation of the features; 1 without features
  double AgreementAfter = 1.0;
  /// Number of landmarks farther than 1e-6 from their targets; for Diffeomorphic.
  Index NumberOfUnmetLandmarks = 0;
  Index NumberOfFolds = 0; ///< number of folded triangles, by exact arithmetic
};

/// Register a moving surface with a fixed one.
///
/// 1. Find a rotation by landmarks, if there are at least two; otherwise, find several good
///    rotations by features.
/// 2. From each rotation, descend on the energy of stretch and features. Of the results of low
///    energy, keep the one whose corresponding surface points agree best after a rotation. This
///    excludes results that match a head to a tail with similar features.
/// 3. Continue the descent on finer spheres. The last descent has less regularization.
/// 4. Interpolate the deformation at the moving surface's vertices, then move landmark vertices to
///    their targets by a flow (LandmarkFlow.h).
///
/// A deformation that folds a triangle is reduced until no triangle is folded. For Rotation and
/// Moebius, the transform is fitted by least squares to the landmarks or, if there are none, to the
/// deformation.
///
/// @param[in] landmarks       pairs of a vertex of the moving and a vertex of the fixed surface. No
///   vertex of the moving surface is repeated.
/// @param[in] featureWeights  #K, weights of the features, at least 0
/// @throws std::invalid_argument if a map folds, or landmarks are too few for the space
/// @throws Aborted
/// @post the result does not depend on the number of threads
SphericalRegistrationResult registerSpheres(const RegisteredSurface& moving,
  const RegisteredSurface& fixed, const std::vector<std::pair<int, int>>& landmarks,
  const std::vector<double>& featureWeights, const SphericalRegistrationOptions& options = {},
  const Run& run = {});
}

#endif
