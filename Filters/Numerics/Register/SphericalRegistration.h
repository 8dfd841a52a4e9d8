/// Register a moving surface with a fixed surface. Both surfaces have maps to the sphere. The map
/// of the moving surface is deformed until corresponding points of both surfaces have the same
/// position on the sphere.
///
/// Own construction, not from a publication: an energy is minimized by descents (stepwise
/// minimizations) from several initial rotations. The first descents use a coarse mesh of the
/// sphere, the next ones use finer meshes. A single descent could end in a poor local minimum.

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
  /// Weight of the stretch (symmetric Dirichlet energy) of the map between the surfaces; above 0.
  double StretchWeight = 1.0;
  /// Frequency f of the finest geodesic sphere on which the deformation is computed, at least 8. A
  /// geodesic sphere is a subdivided icosahedron with 10 f^2 + 2 vertices.
  int Frequency = 16;
};

/// Surface with a map that covers the sphere once without folds. It has #V vertices.
struct RegisteredSurface
{
  MappedMesh Surface;
  /// #V by #K finite numbers. Each column is a feature, such as the curvature. Registration makes
  /// the features of both surfaces equal at corresponding points, as far as possible.
  Rows Features;
};

/// New map of the moving surface, and measures of its agreement with the fixed surface.
struct SphericalRegistrationResult
{
  Points SpherePositions; ///< #V by 3 unit vectors, the new map of the moving surface
  /// Stretch (symmetric Dirichlet energy) of the map between the surfaces; 1 if the map is
  /// isometric (preserves lengths).
  double Stretch = 0.0;
  /// Landmarks are given vertices of the moving surface, each with a corresponding vertex of the
  /// fixed surface. The target of a landmark is the sphere position of the corresponding vertex.
  /// LandmarkError is the maximum distance between a landmark and its target on the unit sphere,
  /// after registration.
  double LandmarkError = 0.0;
  /// Weighted mean correlation of the features of both surfaces before registration; 1 without
  /// features.
  double AgreementBefore = 1.0;
  /// Weighted mean correlation of the features of both surfaces after registration; 1 without
  /// features.
  double AgreementAfter = 1.0;
  /// Number of landmarks farther than 1e-6 from their targets on the unit sphere. Counted only for
  /// Diffeomorphic.
  Index NumberOfUnmetLandmarks = 0;
  Index NumberOfFolds = 0; ///< number of folded triangles of the new map, by exact arithmetic
};

/// Register a moving surface with a fixed surface.
///
/// The score of a map is its energy plus 3 times its pose difference. The energy is a sum of the
/// stretch of the map, weighted squared differences of features, and further terms for landmarks
/// and against folds. The pose difference is 1 minus the correlation of corresponding positions,
/// after the best rotation in space. For example, if the head of an animal is matched with a
/// similar tail, the pose difference is large.
///
/// 1. Find the initial rotations of the moving surface's sphere. If there are at least two
///    landmarks, they determine one rotation. Otherwise, up to eight rotations are found by the
///    features (RotationSearch.h).
/// 2. From each rotation, minimize the energy by a descent on a coarse geodesic sphere
///    (RegistrationDescent.h). Keep up to two of the resulting maps, those with the lowest scores.
/// 3. Continue the descents on finer geodesic spheres, and keep the map with the lowest score. In
///    the last descent, the energy terms against folds have smaller weights.
/// 4. Interpolate the deformation of the geodesic sphere at the moving surface's vertices. Then
///    move landmark vertices to their targets by a flow, a smooth motion of all vertices
///    (LandmarkFlow.h).
///
/// If the deformation folds a triangle of the moving surface, a smaller fraction of the deformation
/// is applied. For SpaceOfTransforms Rotation and Moebius, the result is a transform instead of a
/// deformation. This transform is fitted to the landmarks by least squares. If there are no
/// landmarks, the transform is fitted to the deformation of the coarse sphere.
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
