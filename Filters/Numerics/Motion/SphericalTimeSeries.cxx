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

  // Register a time step with its neighbor. Other is the neighbor's neighbor for extrapolation, or
  // the other neighbor of the time step for interpolation; -1 if there is none.
  void registerStep(Index step, Index neighbor, Index other, const Run& run)
  {
    RegisteredSurface fixed = this->Inputs[neighbor].Surface;
    fixed.Surface.SpherePositions = this->Results[neighbor].SpherePositions;
    if (other >= 0)
    {
      fixed.Expected = this->expected(step, neighbor, other);
    }
    const RegisteredSurface& moving = this->Inputs[step].Surface;
    std::vector<std::pair<int, int>> landmarks;
    Hash hash;
    for (const auto& [number, vertex] : this->Inputs[step].Landmarks)
    {
      const auto found = this->Inputs[neighbor].Landmarks.find(number);
      if (found != this->Inputs[neighbor].Landmarks.end())
      {
        landmarks.emplace_back(vertex, found->second);
        hash.add(vertex);
        hash.add(found->second);
      }
    }
    const SphericalRegistrationOptions& with = this->Options.Registration;
    for (const double number :
      { with.ShapeWeight, with.PositionWeight, with.StretchWeight, 1.0 * with.Frequency })
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
    this->Used.insert(hash.value());
    run.report(1.0);
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
  Steps parts(
    run, std::vector<double>(std::max<Index>(1, (size - 1) * (1 + options.NumberOfSweeps)), 1.0));
  for (int pass = 0; pass <= options.NumberOfSweeps; ++pass)
  {
    for (const Index direction : { 1, -1 })
    {
      for (Index t = options.Reference + direction; t >= 0 && t < size; t += direction)
      {
        const Index before = t - 2 * direction, after = t + direction;
        const bool hasAfter = pass > 0 && after >= 0 && after < size;
        const bool hasBefore = (t - direction) != options.Reference;
        series.registerStep(
          t, t - direction, hasAfter ? after : (hasBefore ? before : -1), parts.next());
      }
    }
  }
  series.forgetOthers();
  run.report(1.0);
  return series.results();
}
}
