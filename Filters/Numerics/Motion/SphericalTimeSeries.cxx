#include "Motion/SphericalTimeSeries.h"

#include "Base/Steps.h"
#include "Motion/SurfaceMotion.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

namespace conformal
{
namespace
{
constexpr double Damping = 0.5; // factor of a velocity that is extrapolated
// Weight of the distance between positions before and after a registration with the reference.
constexpr double KeepWeight = 3.0;

// Hash of numbers, \cite Fowler1991.
class Hash
{
public:
  template <typename Number>
  void add(const Number* numbers, Index size)
  {
    const auto* bytes = reinterpret_cast<const unsigned char*>(numbers);
    for (std::size_t i = 0; i < static_cast<std::size_t>(size) * sizeof(Number); ++i)
    {
      this->Value = (this->Value ^ bytes[i]) * 0x100000001b3ULL;
    }
  }
  void add(double number) { this->add(&number, 1); }
  void add(const RegisteredSurface& surface)
  {
    this->add(surface.Surface.Positions.data(), surface.Surface.Positions.size());
    this->add(surface.Surface.SpherePositions.data(), surface.Surface.SpherePositions.size());
    this->add(surface.Surface.Triangles.data(), surface.Surface.Triangles.size());
    this->add(surface.Expected.data(), surface.Expected.size());
    this->add(surface.Features.data(), surface.Features.size());
  }

  std::uint64_t value() const { return this->Value; }

private:
  std::uint64_t Value = 0xcbf29ce484222325ULL;
};

// Maps of the time steps, which become coherent one by one.
class Series
{
public:
  Series(const std::vector<TimeStep>& steps, KnownRegistrations& known,
    const SphericalTimeSeriesOptions& options)
    : Inputs(steps)
    , Known(known)
    , Options(options)
    , Results(steps.size())
  {
    SphericalRegistrationResult& reference = this->Results[options.Reference];
    reference.SpherePositions = steps[options.Reference].Surface.Surface.SpherePositions;
    reference.Stretch = 1.0;
  }

  // Register a time step with its neighbor. Other is the neighbor's neighbor, for extrapolation, or
  // the other neighbor of the time step, for interpolation; -1 if there is none.
  void registerWithNeighbor(Index step, Index neighbor, Index other, const Run& run)
  {
    RegisteredSurface fixed = this->present(neighbor);
    if (other >= 0)
    {
      fixed.Expected = this->expected(step, neighbor, other);
    }
    this->registerWith(neighbor, fixed, step, this->Options.Registration.PositionWeight, run);
  }

  // Register a time step with the reference. Keep points near their present positions. If the
  // reference does not have all landmarks of the time step, the others would lose their targets:
  // leave the map as it is.
  void registerWithReference(Index step, const Run& run)
  {
    const auto& landmarks = this->Inputs[this->Options.Reference].Landmarks;
    for (const auto& landmark : this->Inputs[step].Landmarks)
    {
      if (landmarks.count(landmark.first) == 0)
      {
        run.report(1.0);
        return;
      }
    }
    RegisteredSurface fixed = this->present(this->Options.Reference);
    fixed.Expected =
      positionsInDirections(this->present(step).Surface, fixed.Surface.SpherePositions);
    this->registerWith(this->Options.Reference, fixed, step, KeepWeight, run);
  }

  // Forget registrations that this call did not use.
  void forgetOthers()
  {
    for (auto known = this->Known.begin(); known != this->Known.end();)
    {
      known = this->Used.count(known->first) > 0 ? std::next(known) : this->Known.erase(known);
    }
  }

  std::vector<SphericalRegistrationResult> results() { return std::move(this->Results); }

private:
  // Return the surface of a time step with its present map: the input map before the first
  // registration.
  RegisteredSurface present(Index step) const
  {
    RegisteredSurface surface = this->Inputs[step].Surface;
    if (this->isRegistered(step))
    {
      surface.Surface.SpherePositions = this->Results[step].SpherePositions;
    }
    return surface;
  }

  bool isRegistered(Index step) const { return this->Results[step].SpherePositions.rows() > 0; }

  // Register a time step with another one. If the time step was registered before, start from its
  // present map.
  void registerWith(
    Index other, const RegisteredSurface& fixed, Index step, double positionWeight, const Run& run)
  {
    const RegisteredSurface moving = this->present(step);
    SphericalRegistrationOptions with = this->Options.Registration;
    with.PositionWeight = positionWeight;
    with.StartFromMaps = this->isRegistered(step);
    const bool wasAmbiguous = this->Results[step].IsAmbiguous;
    std::vector<std::pair<int, int>> landmarks;
    Hash hash;
    for (const auto& [number, vertex] : this->Inputs[step].Landmarks)
    {
      const auto found = this->Inputs[other].Landmarks.find(number);
      if (found != this->Inputs[other].Landmarks.end())
      {
        landmarks.emplace_back(vertex, found->second);
        hash.add(vertex);
        hash.add(found->second);
      }
    }
    for (const double number : { with.ShapeWeight, with.PositionWeight, with.StretchWeight,
           1.0 * with.Frequency, with.StartFromMaps ? 1.0 : 0.0 })
    {
      hash.add(number);
    }
    hash.add(
      this->Options.FeatureWeights.data(), static_cast<Index>(this->Options.FeatureWeights.size()));
    hash.add(moving);
    hash.add(fixed);
    const auto found = this->Known.find(hash.value());
    if (found != this->Known.end())
    {
      this->Results[step] = found->second;
    }
    else
    {
      try
      {
        this->Results[step] =
          registerSpheres(moving, fixed, landmarks, this->Options.FeatureWeights, with, run);
      }
      catch (const std::invalid_argument& error)
      {
        throw std::invalid_argument(this->Inputs[step].Name + ": " + error.what());
      }
      this->Known[hash.value()] = this->Results[step];
    }
    this->Results[step].IsAmbiguous = this->Results[step].IsAmbiguous || wasAmbiguous;
    this->Used.insert(hash.value());
    run.report(1.0);
  }

  // Compute the expected positions of the neighbor's vertices at the time of a step, from the
  // positions of the neighbor and of another time step.
  Points expected(Index step, Index neighbor, Index other) const
  {
    const MappedMesh& mesh = this->Inputs[neighbor].Surface.Surface;
    MappedMesh second = this->Inputs[other].Surface.Surface;
    second.SpherePositions = this->Results[other].SpherePositions;
    const Points there = positionsInDirections(second, this->Results[neighbor].SpherePositions);
    const double passed = this->Inputs[step].Time - this->Inputs[neighbor].Time,
                 between = this->Inputs[other].Time - this->Inputs[neighbor].Time;
    const double fraction = passed / between; // below 0 for extrapolation
    return mesh.Positions +
      (fraction < 0.0 ? Damping * fraction : fraction) * (there - mesh.Positions);
  }

  const std::vector<TimeStep>& Inputs;
  KnownRegistrations& Known;
  const SphericalTimeSeriesOptions& Options;
  std::vector<SphericalRegistrationResult> Results;
  std::set<std::uint64_t> Used;
};
}

//------------------------------------------------------------------------------
std::vector<SphericalRegistrationResult> registerTimeSeries(const std::vector<TimeStep>& steps,
  KnownRegistrations& known, const SphericalTimeSeriesOptions& options, const Run& run)
{
  const auto size = static_cast<Index>(steps.size());
  if (options.Reference < 0 || options.Reference >= size)
  {
    throw std::invalid_argument("the reference is time step " + std::to_string(options.Reference) +
      ", but there are " + std::to_string(size));
  }
  for (Index t = 1; t < size; ++t)
  {
    if (!(steps[t].Time > steps[t - 1].Time))
    {
      throw std::invalid_argument(steps[t].Name + " is not later than " + steps[t - 1].Name);
    }
  }
  Series series(steps, known, options);
  Steps parts(run,
    std::vector<double>(std::max<Index>(1, (size - 1) * (1 + 2 * options.NumberOfSweeps)), 1.0));
  for (int pass = 0; pass <= options.NumberOfSweeps; ++pass)
  {
    for (const Index direction : { 1, -1 })
    {
      for (Index t = options.Reference + direction; t >= 0 && t < size; t += direction)
      {
        const Index before = t - 2 * direction, after = t + direction;
        const bool hasAfter = pass > 0 && after >= 0 && after < size;
        const bool hasBefore = (t - direction) != options.Reference;
        series.registerWithNeighbor(
          t, t - direction, hasAfter ? after : (hasBefore ? before : -1), parts.next());
      }
    }
    for (Index t = 0; t < size && pass > 0; ++t)
    {
      if (t != options.Reference)
      {
        series.registerWithReference(t, parts.next());
      }
    }
  }
  series.forgetOthers();
  run.report(1.0);
  return series.results();
}
}
