/// Make the maps of the time steps of a moving body correspond: a point of the body keeps its
/// position on the sphere.
///
/// Own construction, not from a publication: each time step is registered with a neighboring time
/// step. All time steps share one space, and bodies move smoothly. Positions that are expected from
/// the motion so far are therefore terms of the registration energy. Shape alone cannot determine
/// rotations of a body about its own axis.

#ifndef ConformalSphericalTimeSeries_h
#define ConformalSphericalTimeSeries_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/PreparedSurface.h"
#include "Register/SphericalRegistration.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace conformal
{
/// Options of registerTimeSeries().
struct SphericalTimeSeriesOptions
{
  SphericalTimeSeriesOptions() { this->Registration.PositionWeight = 10.0; }

  /// Options of each registration. Space must be Diffeomorphic.
  SphericalRegistrationOptions Registration;
  /// #K weights of the columns of Features of each surface, at least 0.
  std::vector<double> FeatureWeights;
  Index Reference = 0; ///< index of the time step whose map does not change
  /// Number of sweeps after the first pass. A sweep registers each time step again: first with
  /// positions that are expected from both neighbors in time, then with the reference.
  int NumberOfSweeps = 1;
};

/// Surface at one time.
struct TimeStep
{
  std::string Name = "a time step"; ///< name of the time step in messages
  double Time = 0.0;                ///< above the time of the previous time step
  RegisteredSurface Surface;
  /// Vertex of each landmark, by the number of the landmark. Landmarks of two time steps correspond
  /// if they have the same number. A time step can have any of the landmarks, or none.
  std::map<int, int> Landmarks;
};

/// Results of registrations that are kept for later calls, by hashes of all that they depend on. If
/// a call was aborted, or time steps were added, only the other registrations are computed.
using KnownRegistrations = std::map<std::uint64_t, SphericalRegistrationResult>;

/// Register the time steps of a body with each other.
///
/// 1. Begin at the reference. Register its neighbors in time with it, then their neighbors with
///    them, and so on. The fixed surface of each registration is the surface of the neighbor. Its
///    positions are extrapolated to the time of the moving surface: its velocity is half of the
///    velocity between the neighbor and the neighbor's neighbor.
/// 2. In each sweep, register each time step again. The positions of the fixed surface are
///    interpolated in time between both neighbors of the moving surface. This removes slips of
///    single time steps along the surface, which later time steps would have inherited.
/// 3. Then register each time step with the reference, starting from its present map, so that small
///    errors of many registrations do not add up (drift). Each position of the reference is
///    expected where the present map has it on the time step. The result therefore stays near the
///    present map, also if the body has changed so much that shape alone leads to wrong
///    correspondences.
/// A time step with a landmark that the reference does not have is not registered with the
/// reference, since this landmark would lose its target.
/// @param[in] steps  #S time steps, at least one, in ascending order of times
/// @param[in,out] known  registrations of earlier calls; the registrations of this call are added
/// @return #S results; SpherePositions of a time step is its new map. The result of the reference
///   is its input map. Quality is that of the last registration of the time step; IsAmbiguous is
///   true if any of its registrations was ambiguous.
/// @throws std::invalid_argument if a map has folds, or does not cover the sphere once; the message
///   contains the name of the time step
/// @throws std::invalid_argument if times do not ascend, or the reference is not a time step
/// @throws Aborted
/// @post the result does not depend on the number of threads
std::vector<SphericalRegistrationResult> registerTimeSeries(const std::vector<TimeStep>& steps,
  KnownRegistrations& known, const SphericalTimeSeriesOptions& options = {}, const Run& run = {});
}

#endif
