/// Register many surfaces with their mean shape, so that all surfaces correspond. Each surface has
/// a map to the sphere. Registration deforms the maps until corresponding points have the same
/// position on the sphere.
///
/// Own construction, not from a publication: the mean is recomputed after each round of
/// registrations. The result therefore depends little on any single surface.

#ifndef ConformalSphericalTemplate_h
#define ConformalSphericalTemplate_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/ShapeModes.h"
#include "Register/SphericalRegistration.h"

#include <string>
#include <vector>

namespace conformal
{
/// Options of findSphericalTemplate().
struct SphericalTemplateOptions
{
  SphericalRegistrationOptions Registration; ///< options of the registration of each surface
  /// Transform that aligns the shapes before their mean is computed.
  ShapeAlignment Alignment = ShapeAlignment::Rigid;
  /// Frequency f of the mesh of the mean in the rounds, a geodesic sphere (subdivided icosahedron)
  /// with 10 f^2 + 2 points. The mean of the result has about as many points.
  int MeanFrequency = 45;
  /// Maximum number of rounds, at least 0. Each round registers all surfaces with the mean.
  int MaximumNumberOfRounds = 4;
  /// Rounds end if the mean changes by at most this fraction of its root mean square radius. A
  /// radius is the distance of a point from the center of the mean.
  double Tolerance = 0.01;
};

/// Surface to register, with its landmarks.
struct TemplateInput
{
  std::string Name = "a surface"; ///< name of the surface in messages
  RegisteredSurface Surface;
  /// #L vertex ids without repetition. Landmarks of different surfaces correspond if they have the
  /// same index in this list.
  std::vector<int> Landmarks;
};

/// Registrations of #S surfaces with their mean, and the mean.
struct SphericalTemplateResult
{
  /// #S, registration of each surface with the mean. If MaximumNumberOfRounds is 0, each surface is
  /// registered with the start surface instead. The start surface is one of the input surfaces, see
  /// findSphericalTemplate().
  std::vector<SphericalRegistrationResult> Registrations;
  /// Mean shape, with the center and orientation of the start surface. Sides of triangles have
  /// about equal lengths on the surfaces.
  MappedMesh Mean;
  Index Start = 0; ///< index of the start surface
  /// Change of the mean in each round: root mean square displacement, divided by root mean square
  /// radius.
  std::vector<double> Changes;
};

/// Register all surfaces with a common mean shape.
///
/// 1. Register all surfaces with the first surface. Compute the mean of the registered shapes. The
///    surface closest to this mean becomes the start surface.
/// 2. Register all surfaces with the start surface.
/// 3. Repeat in rounds: Compute the mean positions and mean features of corresponding points, by
///    the latest registrations. Register all surfaces with this mean. Stop if the mean changes by
///    at most options.Tolerance.
///
/// 4. Make a mesh whose sides have about equal lengths on the surfaces (RemeshMeshType::Adaptive).
///    Average the triangles of the registered surfaces on this mesh, see rigidMean(). Limbs in
///    different poses therefore keep their size in the mean.
///
/// Each registration begins with the input map of the surface, not with the result of the previous
/// round. For each landmark index, the sphere positions of this landmark are averaged over all
/// surfaces. The vertex of the mean that is closest to this average is the mean's landmark. No
/// vertex is used twice.
///
/// If a registration is ambiguous, up to three third surfaces decide: those with unambiguous
/// registrations of the lowest stretch. The ambiguous surface is registered with each third
/// surface, whose map is that of its own registration. The result therefore composes two
/// registrations. The third surface votes for the correspondence, best or second best, to which the
/// result is at most half as far as to the other one. Results that are ambiguous do not vote. The
/// majority decides, and the registration is no longer ambiguous. With equal votes, it remains
/// ambiguous.
///
/// A different order of the surfaces may result in a different start surface. If the start surface
/// is the same, results differ only by rounding.
/// @param[in] inputs          #S surfaces, at least one
/// @param[in] featureWeights  #K, weights of the features, at least 0
/// @throws std::invalid_argument if a surface has zero area, or its map does not cover the sphere
///   once. The message contains the name of the surface.
/// @throws std::invalid_argument if the surfaces have different numbers of landmarks
/// @throws std::invalid_argument if registerSpheres() throws this exception
/// @throws Aborted
/// @post the result does not depend on the number of threads
SphericalTemplateResult findSphericalTemplate(const std::vector<TemplateInput>& inputs,
  const std::vector<double>& featureWeights, const SphericalTemplateOptions& options = {},
  const Run& run = {});
}

#endif
