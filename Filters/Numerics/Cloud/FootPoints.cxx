#include "Cloud/FootPoints.h"

#include "Base/MortonOrder.h"

#include <algorithm>
#include <vector>

namespace conformal
{
namespace
{
/// Find the closest point of each i in [0, count), on all threads, and call body(i, x, foot) for
/// each, in sequence and on one thread.
/// @param[in] placeOf  function that returns the position x of i
/// @param[in] closest  function of i, x and a triangle that is probably near x, or -1
template <typename PlaceOf, typename Closest, typename Body>
void deliverFeet(
  Index count, const PlaceOf& placeOf, const Closest& closest, const Body& body, const Run& run)
{
  constexpr Index ChunkSize = 64 * HeavyBlock; // 10 to 20 ms between reports
  struct Found
  {
    Vector3 Place;
    FootPoint Foot;
  };
  std::vector<Found> found(std::min(count, ChunkSize)), feet(found.size());
  Index delivered = 0, first = 0; // closest points of samples [delivered, first) are in `found`
  const auto deliver = [&]()
  {
    for (Index i = delivered; i < first; ++i)
    {
      body(i, found[i - delivered].Place, found[i - delivered].Foot);
    }
  };
  while (delivered < count)
  {
    const Index size = std::min(ChunkSize, count - first);
    const Index blocks = (size + HeavyBlock - 1) / HeavyBlock;
    run.forEach(blocks + 1,
      [&](Index job)
      {
        if (job == 0)
        {
          deliver();
          return;
        }
        // Places are read in a loop of their own, so that the processor waits for many at a time.
        const Index begin = (job - 1) * HeavyBlock, end = std::min(size, job * HeavyBlock);
        for (Index i = begin; i < end; ++i)
        {
          feet[i].Place = placeOf(first + i);
        }
        // The previous sample is often a neighbor in space: use its triangle as the hint.
        int hint = -1;
        for (Index i = begin; i < end; ++i)
        {
          feet[i].Foot = closest(first + i, feet[i].Place, hint);
          hint = feet[i].Foot.Triangle;
        }
      });
    found.swap(feet);
    delivered = first;
    first += size;
    run.report(static_cast<double>(delivered) / static_cast<double>(count));
  }
}

/// Sample, and its number among those that are visited.
struct Visit
{
  int Sample, Number;
};

/// List the samples idOf(0), ..., idOf(count - 1) in the sequence of all sorted samples.
std::vector<Visit> visitsAlongCurve(const std::vector<int>& sorted, Index count,
  const std::function<Index(Index)>& idOf, const Run& run)
{
  std::vector<int> numbers(sorted.size(), -1);
  forBlocks(run, count, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        numbers[idOf ? idOf(i) : i] = static_cast<int>(i);
      }
    });
  std::vector<Visit> visits;
  visits.reserve(count);
  for (const int sample : sorted)
  {
    if (numbers[sample] >= 0)
    {
      visits.push_back({ sample, numbers[sample] });
    }
  }
  return visits;
}
}

//------------------------------------------------------------------------------
void forEachFoot(const TrainingSamples& samples, const ClosestPoint& closest, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run)
{
  const auto id = [&](Index i) { return idOf ? idOf(i) : i; };
  deliverFeet(
    count, [&](Index i) { return samples[id(i)]; },
    [&](Index i, const Vector3& x, int hint) { return closest(id(i), x, hint); },
    [&](Index i, const Vector3& x, const FootPoint& foot) { body(id(i), x, foot); }, run);
}

//------------------------------------------------------------------------------
void forEachFoot(const TrainingSamples& samples, const TriangleTree& surface, Index count,
  const std::function<Index(Index)>& idOf,
  const std::function<void(Index, const Vector3&, const FootPoint&)>& body, const Run& run)
{
  const auto closest = [&](Index, const Vector3& x, int hint)
  { return surface.closestPoint(x, hint); };
  // Beyond this number of sorted samples for each visited one, sorting the visited ones is faster.
  constexpr Index manyForOne = 16;
  const std::vector<int>* const sorted = samples.sorted();
  if (sorted && samples.size() <= manyForOne * count)
  {
    const std::vector<Visit> visits = visitsAlongCurve(*sorted, count, idOf, run);
    deliverFeet(
      count, [&](Index i) { return samples[visits[i].Sample]; }, closest,
      [&](Index i, const Vector3& x, const FootPoint& foot) { body(visits[i].Number, x, foot); },
      run);
    return;
  }
  // Maximum number of samples sorted at a time, to limit the memory
  constexpr Index maximumSorted = 1 << 20;
  for (Index first = 0; first < count; first += maximumSorted)
  {
    const Index size = std::min(maximumSorted, count - first);
    const auto place = [&](Index i) { return samples[idOf ? idOf(first + i) : first + i]; };
    // Samples are in the cube [-1, 1]^3.
    const std::vector<int> order = mortonOrder(
      size, [&](Index i) { return Vector3(0.5 * (place(i).array() + 1.0)); }, run);
    const auto whole = static_cast<double>(count);
    deliverFeet(
      size, [&](Index i) { return place(order[i]); }, closest,
      [&](Index i, const Vector3& x, const FootPoint& foot) { body(first + order[i], x, foot); },
      run.part(static_cast<double>(first) / whole, static_cast<double>(first + size) / whole));
  }
}
}
