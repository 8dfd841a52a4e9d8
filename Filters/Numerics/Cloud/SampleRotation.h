/// Select another subset of the samples for each pass of training, deterministically. A pass is one
/// loop over the subset. The selection is our own construction: from pass to pass, the selected
/// positions in the sequence of samples are shifted by 0.618 (the golden section) of their spacing.
/// The subsets of successive passes are then evenly distributed over all samples.

#ifndef ConformalSampleRotation_h
#define ConformalSampleRotation_h

#include "Base/Random.h"
#include "Cloud/TrainingSamples.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
/// Selection of the samples of each pass of training. If the wanted number is at least the number
/// of all samples, all samples are selected. Otherwise, samples at equal spacing in the sequence of
/// the cloud are selected. The first selected position differs from pass to pass. In the course of
/// many passes, all samples are thus selected. Each rank (MPI process) selects from its part of the
/// cloud. All ranks together select the same samples as a single process would.
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

  /// Select from samples that are all on this rank.
  SampleRotation(Index numberOfSamples, unsigned int seed)
    : Total(numberOfSamples)
    , First(0)
    , Last(numberOfSamples)
    , Start(Random(seed).uniform())
  {
  }

  /// Select the samples of the next pass.
  /// @param[in] wanted  total number of samples to select, summed over all ranks
  void turn(Index wanted)
  {
    this->TotalCount = std::min(wanted, this->Total);
    // Multiples of this number modulo 1 are evenly distributed in [0, 1).
    constexpr double GoldenSection = 0.6180339887498949;
    this->Start = std::fmod(this->Start + GoldenSection, 1.0);
    this->Begin = this->firstFrom(this->First);
    this->End = this->firstFrom(this->Last);
  }

  Index totalCount() const { return this->TotalCount; }
  Index count() const { return this->End - this->Begin; }
  /// Return the position of this rank's first selected sample among the selected samples of all
  /// ranks.
  Index begin() const { return this->Begin; }
  /// Return the id in TrainingSamples of the i-th selected sample of this rank, for i in [0,
  /// count()).
  Index id(Index i) const { return this->idOfTotal(this->Begin + i) - this->First; }

private:
  Index idOfTotal(Index i) const
  {
    const double spacing = static_cast<double>(this->Total) / static_cast<double>(this->TotalCount);
    return std::min(
      static_cast<Index>((static_cast<double>(i) + this->Start) * spacing), this->Total - 1);
  }

  /// Return the position of the first selected sample whose id among all samples is at least the
  /// given id.
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
