/// Interpolate values at points from values at other points.
/// Own construction: weights by rows, which several units share.

#ifndef ConformalResampleWeights_h
#define ConformalResampleWeights_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <utility>
#include <vector>

namespace conformal
{
/// Sparse matrix of interpolation weights by rows: each of #N points is a weighted mean of points
/// of another surface. The entries of point i are at [Offsets[i], Offsets[i + 1]).
struct ResampleWeights
{
  std::vector<Index> Offsets = { 0 }; ///< #N + 1
  std::vector<int> Ids;
  std::vector<double> Weights; ///< above 0; the sum of each row is 1, unless it is empty

  Index size() const { return static_cast<Index>(this->Offsets.size()) - 1; }

  /// Append a row. Weights may have any sum and are normalized; weights of 0 are dropped.
  void add(const std::vector<std::pair<int, double>>& parts);
};

/// Remove excluded points from each row, and normalize its remaining weights to sum 1.
/// @param[in] counts  for each point of the other surface; 0 to exclude it
ResampleWeights restrictedTo(const ResampleWeights& weights, const std::vector<char>& counts);

/// Blend the weights of several surfaces into one matrix; ids of points are numbered consecutively
/// over all surfaces.
/// @param[in] ofSurfaces  #S weights of equal size
/// @param[in] sizes       #S numbers of points of the surfaces
/// @param[in] shares      #S, at least 0, of sum 1
ResampleWeights blended(const std::vector<const ResampleWeights*>& ofSurfaces,
  const std::vector<Index>& sizes, const std::vector<double>& shares);

/// Weighted means of numbers. A mean stays within the range of its numbers, so that a constant is
/// preserved bit by bit.
struct ResampledNumbers
{
  std::vector<double> Values; ///< #N by the number of components; 0 for empty rows
  Index NumberOfMissing = 0;  ///< points for which every number with a weight is not finite
};

/// Compute weighted means of numbers. Numbers that are not finite are ignored, and the remaining
/// weights are normalized.
/// @param[in] values      one row of numberOfComponents numbers for each point of the other surface
/// @throws Aborted
ResampledNumbers resampleNumbers(const ResampleWeights& weights, const std::vector<double>& values,
  int numberOfComponents, const Run& run = {});

/// Find the label of the largest total weight for each point. The result is the id of the first
/// point with that label. Of labels of equal weight, the smallest is selected. Rows without weights
/// return -1.
/// @param[in] labels  one for each point of the other surface, none of them NaN
/// @throws Aborted
std::vector<int> heaviestLabels(
  const ResampleWeights& weights, const std::vector<double>& labels, const Run& run = {});
}

#endif
