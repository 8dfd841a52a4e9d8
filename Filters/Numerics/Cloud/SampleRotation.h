/// Select deterministic subsets of the samples, a different subset for each pass. Own construction:
/// each subset is shifted by the golden section, because successive subsets are then spread evenly.

#ifndef ConformalSampleRotation_h
#define ConformalSampleRotation_h

#include "Base/Random.h"
#include "Cloud/TrainingSamples.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
/// Selection of the samples of a pass. If there are few samples, all are selected. Otherwise,
/// samples are selected at equal spacing in the order of the scan. The first position changes from
/// pass to pass, so that in the course of many passes all samples are used. Each rank selects from
/// its own part. Together the ranks select the same samples as a single process.
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

  /// Select the samples of the next pass.
  /// @param[in] wanted  total number of samples to select, summed over all ranks
  void turn(Index wanted)
  {
    this->TotalCount = std::min(wanted, this->Total);
    constexpr double GoldenSection = 0.6180339887498949; // its multiples modulo 1 are spread evenly
    this->Start = std::fmod(this->Start + GoldenSection, 1.0);
    this->Begin = this->firstFrom(this->First);
    this->End = this->firstFrom(this->Last);
  }

  Index totalCount() const { return this->TotalCount; }
  Index count() const { return this->End - this->Begin; }
  /// Return the position of this rank's first sample among all samples of the pass.
  Index begin() const { return this->Begin; }
  /// Return the id in TrainingSamples of the i-th sample of this rank, for i in [0, count()).
  Index id(Index i) const { return this->idOfTotal(this->Begin + i) - this->First; }

private:
  Index idOfTotal(Index i) const
  {
    const double spacing = static_cast<double>(this->Total) / static_cast<double>(this->TotalCount);
    return std::min(
      static_cast<Index>((static_cast<double>(i) + this->Start) * spacing), this->Total - 1);
  }

  /// Find the first sample of the pass whose id is at least the given id. The result is its
  /// position in the pass.
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
