/// Interpolate values at target points from values at source points.
///
/// Own construction, not from a publication: interpolation weights are stored as a sparse matrix.
/// The interpolation functions below accept this matrix from any method that computes weights.

#ifndef ConformalResampleWeights_h
#define ConformalResampleWeights_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <utility>
#include <vector>

namespace conformal
{
/// Sparse matrix of interpolation weights. Row i contains the weights of source points for target
/// point i, one of #N target points. The entries of row i have the indices Offsets[i] to
/// Offsets[i + 1] - 1.
struct ResampleWeights
{
  std::vector<Index> Offsets = { 0 }; ///< #N + 1, index of the first entry of each row
  std::vector<int> Ids;               ///< source point of each entry
  /// Weight of each entry, above 0. The weights of a row have the sum 1, unless the row is empty.
  std::vector<double> Weights;

  /// Return the number #N of rows.
  Index size() const { return static_cast<Index>(this->Offsets.size()) - 1; }

  /// Append a row.
  /// @param[in] parts  source points and their weights. Weights are scaled to sum 1; weights of 0
  ///   are dropped.
  void add(const std::vector<std::pair<int, double>>& parts);
};

/// Remove excluded source points from all rows. Then scale the weights of each row to sum 1.
/// @param[in] counts  one element for each source point: 0 to exclude the point, else 1
ResampleWeights restrictedTo(const ResampleWeights& weights, const std::vector<char>& counts);

/// Combine the interpolation weights of several source surfaces in one matrix. Row i of the result
/// contains the weights of row i of every matrix, each multiplied by the weight of its surface. In
/// the result, the points of the first surface are numbered first, then those of the second
/// surface, and so on.
/// @param[in] ofSurfaces  #S matrices with the same number of rows, one for each surface
/// @param[in] sizes       #S, number of points of each surface
/// @param[in] shares      #S, weight of each surface, at least 0. The sum of the weights is 1.
ResampleWeights blended(const std::vector<const ResampleWeights*>& ofSurfaces,
  const std::vector<Index>& sizes, const std::vector<double>& shares);

/// Interpolated values: weighted means. Rounding never moves a mean outside the range of the
/// averaged values. Constant values are therefore preserved bit by bit.
struct ResampledNumbers
{
  /// Components of the value at each of the #N target points, point by point. The components are 0
  /// where no source point has finite values.
  std::vector<double> Values;
  /// Number of target points that have source points, but none with finite values.
  Index NumberOfMissing = 0;
};

/// Interpolate the values of source points at all target points. Source points with a value that is
/// not finite are ignored. The weights of the remaining source points are scaled to sum 1.
/// @param[in] values  numberOfComponents values for each source point, point by point
/// @throws Aborted
ResampledNumbers resampleNumbers(const ResampleWeights& weights, const std::vector<double>& values,
  int numberOfComponents, const Run& run = {});

/// Select a label for each target point: the label whose source points have the largest total
/// weight. If several labels have this total weight, the smallest label is selected.
/// @param[in] labels  label of each source point; no label is NaN
/// @return for each target point, the id of the first source point with the selected label; -1 if
///   the row of weights is empty
/// @throws Aborted
std::vector<int> heaviestLabels(
  const ResampleWeights& weights, const std::vector<double>& labels, const Run& run = {});
}

#endif
