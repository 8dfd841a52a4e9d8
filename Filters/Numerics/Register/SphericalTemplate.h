/// Register many mapped surfaces with their mean, so that all of them correspond.
/// Own construction: rounds of registration with the mean of all surfaces.

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
  SphericalRegistrationOptions Registration;        ///< of each surface
  ShapeAlignment Alignment = ShapeAlignment::Rigid; ///< before the mean is computed
  int MeanFrequency = 45;                           ///< f, for 10 f^2 + 2 points of the mean
  int MaximumNumberOfRounds = 4; ///< rounds of registration with the mean; at least 0
  double Tolerance = 0.01;       ///< rounds end at this change of the mean, relative to its size
};

/// Surface with landmarks.
struct TemplateInput
{
  std::string Name = "a surface"; ///< in messages
  RegisteredSurface Surface;
  std::vector<int> Landmarks; ///< #L distinct vertices, in one order for all surfaces
};

struct SphericalTemplateResult
{
  /// #S, with the mean; without rounds, or for a single surface, with the start surface.
  std::vector<SphericalRegistrationResult> Registrations;
  MappedMesh Mean; ///< on a geodesic sphere, with position and orientation of the start surface
  Index Start = 0; ///< surface with which all are registered first
  std::vector<double> Changes; ///< of the mean in each round: rms distance over the rms radius
};

/// Register all surfaces with a common mean shape.
///
/// 1. Register all surfaces with the first one. The surface closest to their mean shape is the
///    start.
/// 2. Register all surfaces with the start.
/// 3. In each round, register all surfaces with the mean of positions and features of the previous
///    round. Stop when the mean converges.
///
/// Each registration begins with the surface's own map, so that a round may improve on the previous
/// one. Landmarks of the mean are the vertices closest to the mean landmark positions.
///
/// The order of the surfaces matters only for the choice of the start. If the start is equal,
/// results differ by rounding only.
/// @param[in] inputs          #S, at least one, in one space
/// @param[in] featureWeights  #K, at least 0
/// @throws std::invalid_argument if a surface has zero area, its map does not cover the sphere
///   once, or its number of landmarks differs from that of the first one; the message names the
///   surface
/// @throws std::invalid_argument as registerSpheres() does
/// @throws Aborted
/// @post the result does not depend on the number of threads
SphericalTemplateResult findSphericalTemplate(const std::vector<TemplateInput>& inputs,
  const std::vector<double>& featureWeights, const SphericalTemplateOptions& options = {},
  const Run& run = {});
}

#endif
