/// Values of points that are made of the values of others.
/// Own construction: weights by rows, which several units share.

#ifndef ConformalResampleWeights_h
#define ConformalResampleWeights_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <utility>
#include <vector>

namespace conformal
{
/// For each of #N points the points of another surface that it is made of, and how much each
/// counts: those of point i stand at [Offsets[i], Offsets[i + 1]).
struct ResampleWeights
{
  std::vector<Index> Offsets = { 0 }; ///< #N + 1
  std::vector<int> Ids;
  std::vector<double> Weights; ///< above 0; of each point the sum is 1, unless there are none

  Index size() const { return static_cast<Index>(this->Offsets.size()) - 1; }

  /// Add a point, made of others of any weights; those of 0 are left out, the others divided by
  /// their sum.
  void add(const std::vector<std::pair<int, double>>& parts);
};

/// Leave out the points that do not count. What is left of each sum is made 1 again.
/// @param[in] counts  for each point of the other surface; not 0 if it counts
ResampleWeights restrictedTo(const ResampleWeights& weights, const std::vector<char>& counts);

/// One for all of several surfaces, whose points are numbered one after the other.
/// @param[in] ofSurfaces  #S weights of equal size
/// @param[in] sizes       #S numbers of points that their ids name
/// @param[in] shares      #S, at least 0, of sum 1
ResampleWeights blended(const std::vector<const ResampleWeights*>& ofSurfaces,
  const std::vector<Index>& sizes, const std::vector<double>& shares);

/// Means of numbers; they never leave the range of what they are made of, so that a constant stays
/// the same to the bit.
struct ResampledNumbers
{
  std::vector<double> Values; ///< #N by the number of components; 0 where there are none
  Index NumberOfMissing = 0;  ///< points whose weights are all at numbers that are not finite
};

/// Numbers that are not finite do not count, as though their points were left out.
/// @param[in] values      one row of so many components for each point that the weights name
/// @throws Aborted
ResampledNumbers resampleNumbers(const ResampleWeights& weights, const std::vector<double>& values,
  int numberOfComponents, const Run& run = {});

/// For each point the label of the largest total weight, as the first of the points that have it;
/// of labels that weigh the same the smallest. -1 where there are no weights.
/// @param[in] labels  one for each point that the weights name, none of them NaN
/// @throws Aborted
std::vector<int> heaviestLabels(
  const ResampleWeights& weights, const std::vector<double>& labels, const Run& run = {});
}

#endif
