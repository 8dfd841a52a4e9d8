/// Register many mapped surfaces with their mean, so that all of them correspond. Own construction:
/// surfaces are registered in rounds with their mean, because the result then depends little on any
/// single surface.

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
struct SphericalTemplateOptions
{
  SphericalRegistrationOptions Registration; ///< options of the registration of each surface
  /// Alignment of the shapes before the mean is computed.
  ShapeAlignment Alignment = ShapeAlignment::Rigid;
  /// Frequency f of the mean, which has 10 f^2 + 2 points.
  int MeanFrequency = 45;
  /// Maximum number of rounds of registration with the mean, at least 0.
  int MaximumNumberOfRounds = 4;
  double Tolerance = 0.01; ///< rounds end at this change of the mean, relative to its size
};

/// Surface with landmarks.
struct TemplateInput
{
  std::string Name = "a surface"; ///< name of the surface in messages
  RegisteredSurface Surface;
  std::vector<int> Landmarks; ///< #L distinct vertices, in the same order for all surfaces
};

struct SphericalTemplateResult
{
  /// #S, registration of each surface with the mean; without rounds, or for a single surface, with
  /// the start surface.
  std::vector<SphericalRegistrationResult> Registrations;
  /// Mean on a geodesic sphere, at the position and orientation of the start surface.
  MappedMesh Mean;
  Index Start = 0; ///< number of the start surface, with which all are registered first
  /// Change of the mean in each round: root mean square distance divided by the root mean square
  /// radius.
  std::vector<double> Changes;
};

/// Register all surfaces with a common mean shape.
///
/// 1. Register all surfaces with the first one. The surface closest to the mean of the registered
///    shapes is the start surface.
/// 2. Register all surfaces with the start surface.
/// 3. In each round, register all surfaces with the mean of positions and features of the previous
///    round. Stop when the mean converges.
///
/// Each registration begins with the surface's input map, so that a round may improve on the
/// previous round. Landmarks of the mean are the vertices closest to the mean landmark positions.
///
/// The order of the surfaces matters only for the choice of the start surface. With the same start
/// surface, results differ only by rounding.
/// @param[in] inputs          #S surfaces, at least one
/// @param[in] featureWeights  #K, weights of the features, at least 0
/// @throws std::invalid_argument if a surface has zero area, its map does not cover the sphere
///   once, or its number of landmarks differs from that of the first one; the message names the
///   surface
/// @throws std::invalid_argument if registerSpheres() throws it
/// @throws Aborted
/// @post the result does not depend on the number of threads
SphericalTemplateResult findSphericalTemplate(const std::vector<TemplateInput>& inputs,
  const std::vector<double>& featureWeights, const SphericalTemplateOptions& options = {},
  const Run& run = {});
}

#endif
