#include "Glue/PatternArrays.h"

#include "Base/AcrossProcesses.h"
#include "Glue/CloudInput.h"
#include "Glue/Points.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

namespace glue
{
namespace
{
constexpr std::size_t MaximumLabels = 64;
constexpr double MaximumWeight = 1000.0;
constexpr double MaximumLabel = 0x1p53; // larger integers are not exact as doubles

bool IsOfIntegerType(int type)
{
  return type != VTK_FLOAT && type != VTK_DOUBLE;
}

void RequireGoodNames(const WeightedNames& names)
{
  const std::set<std::string> reserved = { SpherePositionName(), "Supported", "StandardError",
    "QuantizationError", vtkDataSetAttributes::GhostArrayName() };
  std::set<std::string> known;
  for (const auto& [name, weight] : names)
  {
    if (!(weight > 0.0 && weight <= MaximumWeight))
    {
      throw std::invalid_argument(
        "the weight of the pattern array \"" + name + "\" must be above 0, and at most 1000");
    }
    if (reserved.count(name) > 0)
    {
      throw std::invalid_argument("a pattern array cannot have the name \"" + name +
        "\", since the output has an array with this name");
    }
    if (!known.insert(name).second)
    {
      throw std::invalid_argument("the pattern array \"" + name + "\" was added twice");
    }
  }
}

// Return the array on a process with points, and null on a process without points.
vtkDataArray* FindArray(vtkPointSet* input, const std::string& name)
{
  if (input->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() < 1)
  {
    throw std::invalid_argument("the input has no point array \"" + name + "\" with numbers");
  }
  return array;
}

// Call body(i, value of each component) for the points of an array that are used.
template <typename Body>
void ForUsed(vtkDataArray* array, const CloudInput& cloud, const Body& body)
{
  if (!array)
  {
    return;
  }
  std::vector<double> values(array->GetNumberOfComponents());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    if (!cloud.Skip || !cloud.Skip(i))
    {
      array->GetTuple(i, values.data());
      body(i, values.data());
    }
  }
}

std::vector<double> LabelsOf(vtkDataArray* array, const std::string& name, const CloudInput& cloud,
  const conformal::Reduce& reduce)
{
  std::set<double> labels;
  ForUsed(array, cloud,
    [&](vtkIdType, const double* value)
    {
      // One label too many is sufficient for the error.
      if (labels.size() <= MaximumLabels)
      {
        labels.insert(*value);
      }
    });
  const std::vector<double> all = conformal::gather(reduce, { labels.begin(), labels.end() });
  labels = { all.begin(), all.end() };
  if (labels.size() > MaximumLabels)
  {
    throw std::invalid_argument("the pattern array \"" + name +
      "\" has integers with 1 component, which are labels, but more than 64 different ones; if "
      "they are numbers, convert the array to floats");
  }
  for (const double label : labels)
  {
    if (std::abs(label) > MaximumLabel)
    {
      throw std::invalid_argument(
        "the labels of the pattern array \"" + name + "\" must be at most 2^53 in magnitude");
    }
  }
  return { labels.begin(), labels.end() };
}

// Find the middle of the range of each component, and the unit: half of the largest range.
void FindRanges(vtkDataArray* source, const CloudInput& cloud, const conformal::Reduce& reduce,
  PatternArrays::Array& array)
{
  const int size = array.NumberOfComponents;
  std::vector<double> extremes(2 * size, -std::numeric_limits<double>::infinity());
  ForUsed(source, cloud,
    [&](vtkIdType, const double* values)
    {
      for (int c = 0; c < size; ++c)
      {
        if (std::isfinite(values[c]))
        {
          extremes[c] = std::max(extremes[c], -values[c]);
          extremes[size + c] = std::max(extremes[size + c], values[c]);
        }
      }
    });
  extremes = conformal::maximum(reduce, extremes);
  array.Center.assign(size, 0.0);
  double half = 0.0;
  for (int c = 0; c < size; ++c)
  {
    if (std::isfinite(extremes[c]) && std::isfinite(extremes[size + c]))
    {
      array.Center[c] = 0.5 * extremes[size + c] - 0.5 * extremes[c];
      half = std::max(half, 0.5 * extremes[size + c] + 0.5 * extremes[c]);
    }
  }
  array.Unit = half > 0.0 ? half : 1.0;
}

PatternArrays::Array Describe(vtkDataArray* source, const std::string& name,
  const CloudInput& cloud, const conformal::Reduce& reduce)
{
  PatternArrays::Array array;
  array.Name = name;
  const std::vector<double> own = { source ? double(source->GetNumberOfComponents()) : 0.0,
    source ? double(source->GetDataType()) : 0.0 };
  const std::vector<double> all = conformal::maximum(reduce, own);
  if (source && own != all)
  {
    throw std::invalid_argument("the pattern array \"" + name +
      "\" has another type or number of components on another process");
  }
  array.NumberOfComponents = static_cast<int>(all[0]);
  array.Type = static_cast<int>(all[1]);
  if (array.NumberOfComponents == 1 && IsOfIntegerType(array.Type))
  {
    array.Labels = LabelsOf(source, name, cloud, reduce);
  }
  else
  {
    FindRanges(source, cloud, reduce, array);
  }
  return array;
}

// Fill the rows of an array, from row `first` on. Mark the points with values that are not finite.
void FillRows(vtkDataArray* source, const CloudInput& cloud, const PatternArrays::Array& array,
  double weight, conformal::Index first, conformal::Columns& values, std::vector<char>& unusable)
{
  ForUsed(source, cloud,
    [&](vtkIdType i, const double* given)
    {
      for (std::size_t k = 0; k < array.Labels.size(); ++k)
      {
        values(first + static_cast<conformal::Index>(k), i) =
          *given == array.Labels[k] ? weight : 0.0;
      }
      for (std::size_t c = 0; c < array.Center.size(); ++c)
      {
        const bool isFinite = std::isfinite(given[c]);
        unusable[i] |= !isFinite;
        values(first + static_cast<conformal::Index>(c), i) =
          isFinite ? weight * ((given[c] - array.Center[c]) / array.Unit) : 0.0;
      }
    });
}
}

//------------------------------------------------------------------------------
void ReadPatternArrays(vtkPointSet* input, const WeightedNames& names,
  const conformal::Reduce& reduce, CloudInput& cloud, PatternArrays& patterns)
{
  RequireGoodNames(names);
  std::int64_t size[] = { input->GetNumberOfPoints() };
  reduce.sum(size, 1);
  if (names.empty() || size[0] == 0)
  {
    return;
  }
  std::vector<vtkDataArray*> sources;
  conformal::Index rows = 0;
  for (const auto& [name, weight] : names)
  {
    sources.push_back(FindArray(input, name));
    patterns.Arrays.push_back(Describe(sources.back(), name, cloud, reduce));
    rows += patterns.Arrays.back().numberOfValues();
  }
  patterns.Values.setZero(rows, input->GetNumberOfPoints());
  std::vector<char> unusable(input->GetNumberOfPoints(), 0);
  conformal::Index first = 0;
  for (std::size_t a = 0; a < names.size(); ++a)
  {
    PatternArrays::Array& array = patterns.Arrays[a];
    FillRows(sources[a], cloud, array, names[a].second, first, patterns.Values, unusable);
    array.Unit /= names[a].second;
    first += array.numberOfValues();
  }
  const auto own = static_cast<std::int64_t>(std::count(unusable.begin(), unusable.end(), char(1)));
  patterns.NumberOfUnusable = conformal::shareOf(reduce, own).Total;
  if (own > 0)
  {
    cloud.Skip = [skip = cloud.Skip, unusable = std::move(unusable)](conformal::Index i)
    { return unusable[i] || (skip && skip(i)); };
  }
}

//------------------------------------------------------------------------------
void AddPatternArrays(
  vtkFieldData* data, const PatternArrays& patterns, const conformal::Columns& values)
{
  conformal::Index first = 0;
  for (const PatternArrays::Array& array : patterns.Arrays)
  {
    const auto output =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array.Type));
    output->SetName(array.Name.c_str());
    output->SetNumberOfComponents(array.NumberOfComponents);
    output->SetNumberOfTuples(values.rows());
    for (conformal::Index i = 0; i < values.rows(); ++i)
    {
      if (!array.Labels.empty())
      {
        conformal::Index label = 0;
        values.row(i).segment(first, array.numberOfValues()).maxCoeff(&label);
        output->SetComponent(i, 0, array.Labels[label]);
      }
      for (std::size_t c = 0; c < array.Center.size(); ++c)
      {
        const double value =
          values(i, first + static_cast<conformal::Index>(c)) * array.Unit + array.Center[c];
        if (!std::isfinite(value))
        {
          throw std::overflow_error(
            "values of the pattern array \"" + array.Name + "\" exceed the range of doubles");
        }
        output->SetComponent(
          i, static_cast<int>(c), IsOfIntegerType(array.Type) ? std::round(value) : value);
      }
    }
    data->AddArray(output);
    first += array.numberOfValues();
  }
}
}
