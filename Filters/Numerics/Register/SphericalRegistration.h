/// Register a moving surface with a fixed surface. Both surfaces have maps to the sphere. The map
/// of the moving surface is deformed until corresponding points of both surfaces have the same
/// position on the sphere.
///
/// Own construction, not from a publication: shape, features and landmarks are terms of one energy.
/// The energy is minimized by descents (stepwise minimizations) from several initial rotations.

#ifndef ConformalSphericalRegistration_h
#define ConformalSphericalRegistration_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/PreparedSurface.h"

#include <utility>
#include <vector>

namespace conformal
{
/// Transforms of the sphere by which registration can change the moving surface's map.
enum class SpaceOfTransforms
{
  Rotation,     ///< rotations, which preserve the angles and areas of the map
  Moebius,      ///< Moebius transforms, which preserve the angles of the map
  Diffeomorphic ///< smooth one-to-one deformations
};

/// Options of registerSpheres().
struct SphericalRegistrationOptions
{
  SpaceOfTransforms Space = SpaceOfTransforms::Diffeomorphic;
  /// Weight of the features that are computed from the shapes of the surfaces; 0 to ignore them. A
  /// feature is a number at each vertex, such as the curvature.
  double ShapeWeight = 1.0;
  /// Weight of the squared distance in space between corresponding points, for surfaces that share
  /// one space, such as time steps of a body; 0 to ignore it. The unit of length is the square root
  /// of the area divided by 4 pi. Both centers are at the origin. See RegisteredSurface::Expected.
  double PositionWeight = 0.0;
  /// Weight of the stretch (symmetric Dirichlet energy) of the map between the surfaces; above 0.
  double StretchWeight = 1.0;
  /// Frequency f of the finest geodesic sphere on which the deformation is computed, at least 8. A
  /// geodesic sphere is a subdivided icosahedron with 10 f^2 + 2 vertices.
  int Frequency = 16;
  /// Whether the input maps approximately correspond. The deformation then starts from these maps,
  /// instead of from the best of several rotations, and step 4 is left out.
  bool StartFromMaps = false;
};

/// New map of the moving surface, and measures of its agreement with the fixed surface.
struct SphericalRegistrationResult
{
  Points SpherePositions; ///< #V by 3 unit vectors, the new map of the moving surface
  /// Stretch (symmetric Dirichlet energy) of the map between the surfaces, see
  /// registrationStretch(); 1 if the map is isometric (preserves lengths).
  double Stretch = 0.0;
  /// Landmarks are given vertices of the moving surface, each with a corresponding vertex of the
  /// fixed surface. The target of a landmark is the sphere position of the corresponding vertex.
  /// LandmarkError is the maximum distance between a landmark and its target on the unit sphere,
  /// after registration.
  double LandmarkError = 0.0;
  /// Weighted mean correlation of the features of both surfaces before registration, see
  /// featureAgreement(); 1 without features.
  double AgreementBefore = 1.0;
  /// Weighted mean correlation of the features of both surfaces after registration, see
  /// featureAgreement(); 1 without features.
  double AgreementAfter = 1.0;
  /// Number of landmarks farther than 1e-6 from their targets on the unit sphere. Counted only for
  /// Diffeomorphic.
  Index NumberOfUnmetLandmarks = 0;
  Index NumberOfFolds = 0; ///< number of folded triangles of the new map, by exact arithmetic
  /// Whether two correspondences are about equally good, such as head and tail of similar shape.
  bool IsAmbiguous = false;
  /// Result of the second best correspondence if IsAmbiguous, otherwise empty.
  std::vector<SphericalRegistrationResult> Second;
};

/// Register a moving surface with a fixed surface.
///
/// 1. Prepare features of both surfaces (PreparedSurface.h).
/// 2. Find a deformation of the moving surface's sphere with low energy (SphereDeformation.h). The
///    energy is a sum of the stretch of the map, weighted squared differences of features, and
///    further terms for landmarks and against folds. The features include the proximities of the
///    landmarks, so that landmarks also move the points between them.
/// 3. Interpolate the deformation of the geodesic sphere at the moving surface's vertices. Then
///    move landmark vertices the rest of the way to their targets by a flow, a smooth motion of all
///    vertices (LandmarkFlow.h).
/// 4. If some landmarks are not at their targets, the map of the moving surface leaves too little
///    area to limbs, or has narrow triangles. Compute another map of the moving surface, with
///    another balance of angles and areas (GlobalConformalMap.h), and repeat, up to three times.
///    Keep the result with the fewest unmet landmarks.
/// 5. Measure the result (RegistrationQuality.h).
///
/// If the deformation folds a triangle of the moving surface, a smaller fraction of the deformation
/// is applied. For SpaceOfTransforms Rotation and Moebius, the result is a transform instead of a
/// deformation. This transform is fitted to the landmarks by least squares. If there are no
/// landmarks, the transform is fitted to the deformation of the coarse sphere. Triangles that a
/// Moebius transform folds are repaired, if possible.
///
/// @param[in] landmarks       pairs of a vertex of the moving surface and a vertex of the fixed
///   surface. No vertex of the moving surface is repeated.
/// @param[in] featureWeights  #K, weights of the columns of Features, at least 0
/// @throws std::invalid_argument if a map has folds, or does not cover the sphere once
/// @throws std::invalid_argument if there is exactly one landmark for Rotation, or one or two
///   landmarks for Moebius
/// @throws Aborted
/// @post the result does not depend on the number of threads
SphericalRegistrationResult registerSpheres(const RegisteredSurface& moving,
  const RegisteredSurface& fixed, const std::vector<std::pair<int, int>>& landmarks,
  const std::vector<double>& featureWeights, const SphericalRegistrationOptions& options = {},
  const Run& run = {});
}

#endif
