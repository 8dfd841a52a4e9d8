/// Deterministic subsets of the samples, a different one at each turn.

#ifndef ConformalSampleRotation_h
#define ConformalSampleRotation_h

#include "Base/Random.h"
#include "Cloud/TrainingSamples.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
/// Which patterns a pass takes: all where they are few, else evenly spaced ones in the scan's own
/// order, from a start that moves from turn to turn so that all are used. Of a cloud spread over
/// processes each takes its own; together they are those that one process would take.
class SampleRotation
{
public:
  SampleRotation(const TrainingSamples& samples, unsigned int seed)
    : Total(samples.totalSize())
    , First(samples.firstOfTotal())
    , Last(samples.firstOfTotal() + samples.size())
    , Start(Random(seed).uniform())
  {
  }

  /// @param[in] wanted  how many patterns the next pass should take, on all processes
  void turn(Index wanted)
  {
    this->TotalCount = std::min(wanted, this->Total);
    constexpr double GoldenSection = 0.6180339887498949; // its multiples spread evenly
    this->Start = std::fmod(this->Start + GoldenSection, 1.0);
    this->Begin = this->firstFrom(this->First);
    this->End = this->firstFrom(this->Last);
  }

  Index totalCount() const { return this->TotalCount; }
  Index count() const { return this->End - this->Begin; }
  /// Place of this process's first pattern among those of the turn.
  Index begin() const { return this->Begin; }
  /// Of TrainingSamples, i in [0, count()).
  Index id(Index i) const { return this->idOfTotal(this->Begin + i) - this->First; }

private:
  Index idOfTotal(Index i) const
  {
    const double spacing = static_cast<double>(this->Total) / static_cast<double>(this->TotalCount);
    return std::min(
      static_cast<Index>((static_cast<double>(i) + this->Start) * spacing), this->Total - 1);
  }

  /// The first of the turn whose id is not below this one.
  Index firstFrom(Index id) const
  {
    Index low = 0, high = this->TotalCount;
    while (low < high)
    {
      const Index middle = (low + high) / 2;
      if (this->idOfTotal(middle) < id)
      {
        low = middle + 1;
      }
      else
      {
        high = middle;
      }
    }
    return low;
  }

  Index Total, First, Last;
  Index TotalCount = 0, Begin = 0, End = 0;
  double Start;
};
}

#endif
