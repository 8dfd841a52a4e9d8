/// Register one mapped surface with another: deform its map to the sphere so that equal directions
/// correspond.
/// Own construction: rotations, then descents from coarse to fine spheres, escape local minima.

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
  double ShapeWeight = 1.0;   ///< weight of built-in features of the surfaces; 0 ignores them
  double StretchWeight = 1.0; ///< weight of the symmetric Dirichlet energy; above 0
  int Frequency = 16;         ///< of the finest geodesic sphere that is deformed, at least 8
};

/// Surface with a map that covers the sphere once without folds.
struct RegisteredSurface
{
  MappedMesh Surface;
  Rows Features; ///< #V by #K finite numbers to be matched between both surfaces
};

struct SphericalRegistrationResult
{
  Points SpherePositions;       ///< #V by 3 unit vectors, of the moving surface
  double Stretch = 0.0;         ///< symmetric Dirichlet energy; 1 if the surfaces are isometric
  double LandmarkError = 0.0;   ///< maximum remaining distance, on the unit sphere
  double AgreementBefore = 1.0; ///< weighted mean correlation of the features; 1 without features
  double AgreementAfter = 1.0;
  Index NumberOfUnmetLandmarks = 0; ///< Diffeomorphic: farther than 1e-6 from their targets
  Index NumberOfFolds = 0;          ///< by exact arithmetic
};

/// Register a moving surface with a fixed one.
///
/// 1. Find rotations by two or more landmarks, or several good ones by features.
/// 2. Descend from each rotation on stretch and features. Keep the result of low energy whose
///    corresponding positions agree best after a rotation, since a head and a tail may have similar
///    features.
/// 3. Continue the descent on finer spheres. The last descent is regularized less.
/// 4. Interpolate the deformation at the moving surface's vertices, then move these to the
///    landmarks by a flow.
///
/// A deformation that folds a triangle is reduced until it does not. Rotation and Moebius fit the
/// landmarks by least squares or, without landmarks, the deformation.
///
/// @param[in] landmarks       pairs of vertices of the moving and of the fixed surface; moving ones
///   are distinct
/// @param[in] featureWeights  #K, at least 0
/// @throws std::invalid_argument if a map folds, or landmarks are too few for the space
/// @throws Aborted
/// @post the result does not depend on the number of threads
SphericalRegistrationResult registerSpheres(const RegisteredSurface& moving,
  const RegisteredSurface& fixed, const std::vector<std::pair<int, int>>& landmarks,
  const std::vector<double>& featureWeights, const SphericalRegistrationOptions& options = {},
  const Run& run = {});
}

#endif
