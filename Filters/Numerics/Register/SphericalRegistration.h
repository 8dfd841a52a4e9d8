/// Registers one mapped surface with another: deforms its map to the sphere so that equal
/// directions correspond.
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
  Rotation,     ///< keeps angles and areas of the map
  Moebius,      ///< keeps angles
  Diffeomorphic ///< one to one and smooth
};

struct SphericalRegistrationOptions
{
  SpaceOfTransforms Space = SpaceOfTransforms::Diffeomorphic;
  double ShapeWeight = 1.0;   ///< of the surfaces' own features; 0 does without them
  double StretchWeight = 1.0; ///< of the symmetric Dirichlet energy; above 0
  int Frequency = 16;         ///< of the finest geodesic sphere that is deformed, at least 8
};

/// A surface with a map that covers the sphere once without folds.
struct RegisteredSurface
{
  MappedMesh Surface;
  Rows Features; ///< #V by #K numbers, finite, on which both surfaces are to agree
};

struct SphericalRegistrationResult
{
  Points SpherePositions;       ///< #V by 3 unit vectors, of the moving surface
  double Stretch = 0.0;         ///< symmetric Dirichlet energy; 1 if the surfaces are isometric
  double LandmarkError = 0.0;   ///< largest distance that is left, on the unit sphere
  double AgreementBefore = 1.0; ///< of the features: weighted mean correlation; 1 without features
  double AgreementAfter = 1.0;
  Index NumberOfUnmetLandmarks = 0; ///< Diffeomorphic: farther away than a millionth
  Index NumberOfFolds = 0;          ///< by exact arithmetic
};

/// Steps: a rotation, by two or more landmarks or the best of several by features; a descent from
/// each on stretch and features, of which the one is carried on to finer spheres whose energy is
/// least and whose corresponding positions agree best after a rotation, since a head and a tail may
/// look alike along the surface; at last, one that is held less to the map as it was. The moving
/// surface's vertices are carried along; then they flow to the landmarks.
/// A deformation that folds a triangle is undone as far as it takes.
/// Rotation and Moebius are those closest to the landmarks or, without any, to the deformation.
///
/// @param[in] landmarks       pairs of vertices, of the moving and of the fixed surface, each
///                            vertex of the moving one once
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
