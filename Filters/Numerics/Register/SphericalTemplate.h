/// Registers many mapped surfaces with their mean, so that all of them correspond.
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
  ShapeAlignment Alignment = ShapeAlignment::Rigid; ///< before the mean is taken
  int MeanFrequency = 45;                           ///< f, for 10 f^2 + 2 points of the mean
  int MaximumNumberOfRounds = 4; ///< in which all are registered with their mean; may be 0
  double Tolerance = 0.01;       ///< change of the mean, in its size, with which rounds end
};

/// A surface, and its landmarks.
struct TemplateInput
{
  std::string Name = "a surface"; ///< in messages
  RegisteredSurface Surface;
  std::vector<int> Landmarks; ///< #L vertices, each once; of all surfaces in one order
};

struct SphericalTemplateResult
{
  /// #S, with the mean; without rounds, or of a single surface, with the start.
  std::vector<SphericalRegistrationResult> Registrations;
  MappedMesh Mean;             ///< on a geodesic sphere, where the start lies and as it is turned
  Index Start = 0;             ///< the surface with which all were registered first
  std::vector<double> Changes; ///< of the mean in each round: rms distance over the rms radius
};

/// Steps: all are registered with the first one, and the start is found, the surface that is
/// closest to the mean of their shapes; all are registered with the start; then in each round with
/// the mean of positions and features of the round before, until it changes no more. Each
/// registration begins with the surface's own map, so that a round may find a better one than that
/// before.
///
/// Landmarks of the mean are the vertices closest to the mean of where they lie.
///
/// The order of the surfaces decides what the start is looked for with; it counts no more where the
/// same one is found, but for rounding.
/// @param[in] inputs          #S, at least one, in one space
/// @param[in] featureWeights  #K, at least 0
/// @throws std::invalid_argument that names the surface that has no area, a map that does not cover
/// the
///   sphere once, or another number of landmarks than the first one; or as registerSpheres() does
/// @throws Aborted
/// @post the result does not depend on the number of threads
SphericalTemplateResult findSphericalTemplate(const std::vector<TemplateInput>& inputs,
  const std::vector<double>& featureWeights, const SphericalTemplateOptions& options = {},
  const Run& run = {});
}

#endif
