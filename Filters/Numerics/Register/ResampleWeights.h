/// Interpolate values at points from values at other points. Own construction: weights are a sparse
/// matrix, because several methods compute them and several filters use them.

#ifndef ConformalResampleWeights_h
#define ConformalResampleWeights_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <utility>
#include <vector>

namespace conformal
{
/// Sparse matrix of interpolation weights. Each of its #N rows expresses one point as a weighted
/// mean of points of another surface. The entries of point i are at [Offsets[i], Offsets[i + 1]).
struct ResampleWeights
{
  std::vector<Index> Offsets = { 0 }; ///< #N + 1
  std::vector<int> Ids;
  std::vector<double> Weights; ///< weights above 0; the sum of each row that is not empty is 1

  Index size() const { return static_cast<Index>(this->Offsets.size()) - 1; }

  /// Append a row. The weights are normalized to sum 1; weights of 0 are dropped.
  void add(const std::vector<std::pair<int, double>>& parts);
};

/// Remove excluded points from all rows, and normalize the remaining weights of each row to sum 1.
/// @param[in] counts  for each point of the other surface, 0 to exclude it, else 1
ResampleWeights restrictedTo(const ResampleWeights& weights, const std::vector<char>& counts);

/// Blend the weights of several surfaces into one matrix. In it, points are numbered consecutively
/// over all surfaces.
/// @param[in] ofSurfaces  #S matrices with equal numbers of rows
/// @param[in] sizes       #S, number of points of each surface
/// @param[in] shares      #S, weight of each surface, at least 0; the sum is 1
ResampleWeights blended(const std::vector<const ResampleWeights*>& ofSurfaces,
  const std::vector<Index>& sizes, const std::vector<double>& shares);

/// Weighted means of numbers. A mean is within the range of its numbers, so that constant values
/// are preserved bit by bit.
struct ResampledNumbers
{
  std::vector<double> Values; ///< #N rows of components; 0 for empty rows of weights
  Index NumberOfMissing = 0;  ///< number of points for which no number with a weight is finite
};

/// Compute weighted means of numbers. Numbers that are not finite are ignored, and the remaining
/// weights are normalized.
/// @param[in] values      one row of numberOfComponents numbers for each point of the other surface
/// @throws Aborted
ResampledNumbers resampleNumbers(const ResampleWeights& weights, const std::vector<double>& values,
  int numberOfComponents, const Run& run = {});

/// Find the label of the largest total weight for each point. If several labels have this weight,
/// the smallest is selected. Return the id of the first point with the selected label, or -1 for an
/// empty row.
/// @param[in] labels  one label for each point of the other surface, none of them NaN
/// @throws Aborted
std::vector<int> heaviestLabels(
  const ResampleWeights& weights, const std::vector<double>& labels, const Run& run = {});
}

#endif
