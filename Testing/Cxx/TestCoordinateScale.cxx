// Every filter in any unit of length: the same result in that unit, or an error and nothing.
#include "../Cases/Case.h"
#include "../Cases/Judge.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace
{
/// What a filter wrote, by name; nothing after an error.
struct Results
{
  std::map<std::string, std::vector<double>> Values;
  bool Failed = false;
};

/// A run of a class at scales.
struct Case
{
  std::string Class;
  cases::ScaledRun Run;

  int power(const std::string& array) const
  {
    static const std::map<std::string, int> common = { { "Points", 1 }, { "QuantizationError", 1 },
      { "StandardError", 1 }, { "KernelWidth", 1 }, { "GridSpacing", 1 }, { "HoleWidth", 1 },
      { "HoleDepth", 1 }, { "Distance", 1 } };
    for (const std::map<std::string, int>& powers : { this->Run.Powers, common })
    {
      const auto found = powers.find(array);
      if (found != powers.end())
      {
        return found->second;
      }
    }
    return 0;
  }

  /// Whether it writes areas, which leave the range of doubles long before lengths do.
  bool hasAreas() const
  {
    return std::any_of(this->Run.Powers.begin(), this->Run.Powers.end(),
      [](const auto& power) { return std::abs(power.second) > 1; });
  }
};

std::ostream& operator<<(std::ostream& os, const Case& item)
{
  return os << item.Class << item.Run.Name;
}

void Gather(Results& results, const std::string& name, vtkDataArray* array)
{
  std::vector<double>& values = results.Values[name];
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      values.push_back(array->GetComponent(i, c));
    }
  }
}

void GatherArrays(Results& results, const std::string& prefix, vtkDataObject* data)
{
  for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
  {
    vtkFieldData* fields = data->GetAttributesAsFieldData(kind);
    for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
    {
      if (vtkDataArray* array = fields->GetArray(i))
      {
        Gather(results, prefix + array->GetName(), array);
      }
    }
  }
}

/// Run a filter, and gather all of its output.
Results ResultsAt(const Case& item, double scale)
{
  Results results;
  const cases::Messages messages;
  const auto filter = item.Run.Make(scale);
  filter->Update();
  results.Failed = messages.errors() > 0;
  const cases::Outcome outcome = cases::JudgeFilter(filter, messages, false);
  EXPECT_FALSE(cases::isBad(outcome.Verdict)) << outcome.Reason;
  for (int port = 0; port < filter->GetNumberOfOutputPorts() && !results.Failed; ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output))
    {
      for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
      {
        auto* block = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
        Gather(results, "Points", block->GetPoints()->GetData());
        GatherArrays(results, "Block" + std::to_string(i), block);
      }
    }
    auto* points = vtkPointSet::SafeDownCast(output);
    if (points && points->GetPoints()) // An optional output may be empty.
    {
      Gather(results, "Points", points->GetPoints()->GetData());
    }
    GatherArrays(results, "", output);
  }
  for (const std::string& name : item.Run.Ignored)
  {
    results.Values.erase(name);
  }
  return results;
}

std::vector<Case> Cases()
{
  std::vector<Case> all;
  for (const cases::Case& of : cases::All())
  {
    for (const cases::ScaledRun& run : of.Scaled)
    {
      all.push_back({ of.Class, run });
    }
  }
  return all;
}

class CoordinateScale : public testing::TestWithParam<Case>
{
};

/// The values in the unit of a scale: with the same bits, or within a share of the largest.
void ExpectSame(
  const Case& item, const Results& base, const Results& results, double scale, double share)
{
  ASSERT_EQ(base.Values.size(), results.Values.size());
  for (const auto& [name, expected] : base.Values)
  {
    ASSERT_EQ(results.Values.count(name), 1U) << name;
    const std::vector<double>& actual = results.Values.at(name);
    const int power = item.power(name);
    ASSERT_EQ(expected.size(), actual.size()) << name;
    double largest = 0.0;
    for (const double value : expected)
    {
      largest = std::max(largest, std::abs(value));
    }
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      double back = actual[i];
      for (int factor = 0; factor < power; ++factor)
      {
        back /= scale;
      }
      for (int factor = 0; factor > power; --factor)
      {
        back *= scale;
      }
      const bool rounded = power > 0 && std::abs(actual[i]) < std::numeric_limits<double>::min();
      // Subnormal numbers are known to 2^-1074 in the unit of the scale only.
      const double tolerance = share > 0.0 ? share * std::max(1.0, largest)
        : rounded                          ? 1e-6 * largest
                                           : 0.0;
      ASSERT_TRUE(std::isfinite(actual[i])) << name << " " << i;
      ASSERT_LE(std::abs(back - expected[i]), tolerance)
        << name << " " << i << ": " << back << " instead of " << expected[i];
    }
  }
}

bool IsFinite(const Results& results)
{
  return std::all_of(results.Values.begin(), results.Values.end(),
    [](const auto& entry)
    {
      return std::all_of(entry.second.begin(), entry.second.end(),
        [](double number) { return std::isfinite(number); });
    });
}
}

TEST_P(CoordinateScale, PowersOfTwoGiveTheSameBits)
{
  const Case& item = GetParam();
  const Results base = ResultsAt(item, 1.0);
  ASSERT_FALSE(base.Failed);
  for (const int exponent : { -1000, -560, -500, -20, 100, 500, 560, 1000, 1023 })
  {
    SCOPED_TRACE(exponent);
    const double scale = std::ldexp(1.0, exponent);
    const Results results = ResultsAt(item, scale);
    const bool mayFail = (item.hasAreas() && std::abs(exponent) > 460) || exponent > 1000;
    EXPECT_TRUE(mayFail || !results.Failed);
    if (!results.Failed)
    {
      ExpectSame(item, base, results, scale, 0.0);
    }
  }
}

TEST_P(CoordinateScale, OtherUnitsGiveTheSameButForRounding)
{
  const Case& item = GetParam();
  const Results base = ResultsAt(item, 1.0);
  for (const double scale : { 1e-300, 1e-170, 1e-20, 1e154, 1e200, 1e307, 1.7e308 })
  {
    SCOPED_TRACE(scale);
    const Results results = ResultsAt(item, scale);
    const bool mayFail = (item.hasAreas() && (scale < 1e-140 || scale > 1e140)) || scale > 1e306;
    EXPECT_TRUE(mayFail || !results.Failed);
    EXPECT_TRUE(IsFinite(results));
    if (!results.Failed && std::isfinite(item.Run.Tolerance))
    {
      ExpectSame(item, base, results, scale, item.Run.Tolerance);
    }
  }
}

TEST_P(CoordinateScale, CoordinatesOfFewBitsGiveNumbersOrAnError)
{
  for (const double scale : { 0.0, 5e-324, 1e-322, 1e-315, 1e-310 })
  {
    SCOPED_TRACE(scale);
    EXPECT_TRUE(IsFinite(ResultsAt(GetParam(), scale)));
  }
}

INSTANTIATE_TEST_SUITE_P(, CoordinateScale, testing::ValuesIn(Cases()),
  [](const testing::TestParamInfo<Case>& info)
  { return info.param.Class.substr(3) + info.param.Run.Name; });
