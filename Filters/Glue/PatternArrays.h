// Convert point arrays of a cloud to pattern values of samples, and learned pattern values back to
// arrays. Pattern values are dimensions of the samples beyond the three coordinates.
#ifndef GluePatternArrays_h
#define GluePatternArrays_h

#include "Base/Reduce.h" // for Reduce
#include "Base/Types.h"  // for Columns

#include <functional> // for Skip
#include <string>     // for names
#include <utility>    // for pairs
#include <vector>     // for arrays

class vtkFieldData;
class vtkPointSet;

namespace glue
{
struct CloudInput;

/// Names of arrays, each with its weight.
using WeightedNames = std::vector<std::pair<std::string, double>>;

/// Pattern values of a cloud, and what is needed to convert learned values to arrays.
struct PatternArrays
{
  struct Array
  {
    std::string Name;
    int Type = 0; ///< type of the values, such as VTK_DOUBLE
    int NumberOfComponents = 0;
    std::vector<double> Center; ///< middle of the range of each component
    double Unit = 1.0;          ///< change of an array value per change of a pattern value
    /// Different values of an array of labels, ascending; empty for an array of numbers. Each label
    /// is a pattern value: the weight at points with the label, 0 at others.
    std::vector<double> Labels;
    conformal::Index numberOfValues() const
    {
      return this->Labels.empty() ? this->NumberOfComponents
                                  : static_cast<conformal::Index>(this->Labels.size());
    }
  };
  std::vector<Array> Arrays;
  conformal::Columns Values; ///< D by #P
  /// Number of points that are left out, on all ranks, since a value is not finite
  conformal::Index NumberOfUnusable = 0;
};

/// Read pattern values. An integer array with 1 component contains labels, all other arrays contain
/// numbers. The components of numbers are shifted to the middle of their ranges, and divided by
/// half of the largest range. Like coordinates, they are then within [-1, 1], and are multiplied by
/// the weight. Points with a value that is not finite are added to those that the cloud skips.
/// @param[in,out] cloud  cloud of the input
/// @param[out] patterns  must outlive the samples made of the cloud. Do not move the object.
/// @throws std::invalid_argument if an array is missing, has no numbers, is given twice, or has
/// more
///   than 64 labels, or if a weight is not positive and finite
void ReadPatternArrays(vtkPointSet* input, const WeightedNames& names,
  const conformal::Reduce& reduce, CloudInput& cloud, PatternArrays& patterns);

/// Add arrays of learned pattern values, with the names and types of the arrays of the input.
/// @param[in] values  #V by D; empty if there are no pattern values
void AddPatternArrays(
  vtkFieldData* data, const PatternArrays& patterns, const conformal::Columns& values);
}

#endif
