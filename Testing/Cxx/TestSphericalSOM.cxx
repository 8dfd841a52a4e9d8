#include "vtkSphericalSOM.h"

#include "FilterContract.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{
constexpr vtkIdType Size = 300;

// Three kinds of rows, with columns of very different units.
vtkSmartPointer<vtkTable> MakeTable()
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(5);
  vtkNew<vtkDoubleArray> small;
  small->SetName("Small");
  vtkNew<vtkFloatArray> large;
  large->SetName("Large");
  vtkNew<vtkIntArray> count;
  count->SetName("Count");
  vtkNew<vtkStringArray> kind;
  kind->SetName("Kind");
  for (vtkIdType i = 0; i < Size; ++i)
  {
    const auto k = static_cast<int>(i % 3);
    small->InsertNextValue(1e-6 * (k == 0 ? 10.0 : 1.0) + 1e-6 * random->GetNextRangeValue(-1, 1));
    large->InsertNextValue(
      static_cast<float>(1e6 * (k == 1 ? 10.0 : 1.0) + 1e6 * random->GetNextRangeValue(-1, 1)));
    count->InsertNextValue(100 + static_cast<int>(random->GetNextRangeValue(0, 20)));
    kind->InsertNextValue(k == 0 ? "first" : k == 1 ? "second" : "third");
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(small);
  table->AddColumn(large);
  table->AddColumn(count);
  table->AddColumn(kind);
  return table;
}

vtkSmartPointer<vtkSphericalSOM> MakeFilter(vtkTable* table)
{
  auto filter = vtkSmartPointer<vtkSphericalSOM>::New();
  filter->SetInputData(table);
  filter->SetLabelColumn("Kind");
  return filter;
}

double Error(vtkSphericalSOM* filter, const char* name)
{
  return filter->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
}
}

TEST(SphericalSOM, WritesItsArrays)
{
  auto filter = MakeFilter(MakeTable());
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
  vtkPolyData* sphere = filter->GetOutput();
  ASSERT_EQ(sphere->GetNumberOfPoints(), 92); // 5 sqrt(300) = 87
  contract::ExpectSpherePosition(sphere);
  for (const char* name : { "Small", "Large", "Count", "UMatrix" })
  {
    contract::ExpectArray(sphere->GetPointData(), name, VTK_DOUBLE, 1, 92);
  }
  contract::ExpectArray(sphere->GetPointData(), "HitCount", VTK_INT, 1, 92);
  EXPECT_EQ(sphere->GetPointData()->GetAbstractArray("Kind")->GetNumberOfTuples(), 92);
  EXPECT_GT(Error(filter, "QuantizationError"), 0.0);
  EXPECT_LT(Error(filter, "QuantizationError"), 0.5); // a standard deviation is 1
  EXPECT_LT(Error(filter, "TopographicError"), 0.25);
  contract::ExpectPrints(filter, "NumberOfNeurons");
}

// The columns of port 1 agree with each other, with the input and with the sphere.
TEST(SphericalSOM, RowsHaveTheirWinners)
{
  auto table = MakeTable();
  auto filter = MakeFilter(table);
  filter->Update();
  EXPECT_EQ(table->GetNumberOfColumns(), 4); // the input is not changed
  vtkTable* rows = filter->GetTable();
  ASSERT_EQ(rows->GetNumberOfRows(), Size);
  EXPECT_EQ(rows->GetColumnByName("Kind"), table->GetColumnByName("Kind"));
  auto* winner = vtkIdTypeArray::SafeDownCast(rows->GetColumnByName("Winner"));
  auto* second = vtkIdTypeArray::SafeDownCast(rows->GetColumnByName("SecondWinner"));
  auto* error = vtkDoubleArray::SafeDownCast(rows->GetColumnByName("QuantizationError"));
  auto* kinds = vtkStringArray::SafeDownCast(table->GetColumnByName("Kind"));
  auto* labels =
    vtkStringArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetAbstractArray("Kind"));
  ASSERT_TRUE(winner && second && error && labels);
  double sum = 0.0;
  std::vector<int> hits(92, 0);
  for (vtkIdType i = 0; i < Size; ++i)
  {
    EXPECT_NE(winner->GetValue(i), second->GetValue(i));
    EXPECT_EQ(labels->GetValue(winner->GetValue(i)), kinds->GetValue(i));
    sum += error->GetValue(i) / Size;
    ++hits[winner->GetValue(i)];
  }
  EXPECT_NEAR(sum, Error(filter, "QuantizationError"), 1e-12);
  std::set<std::string> all;
  for (int i = 0; i < 92; ++i)
  {
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("HitCount")->GetTuple1(i), hits[i]);
    all.insert(labels->GetValue(i));
  }
  EXPECT_EQ(all, (std::set<std::string>{ "first", "second", "third" }));
}

TEST(SphericalSOM, LearnsTheColumnsThatAreAdded)
{
  auto filter = MakeFilter(MakeTable());
  filter->AddColumn("Large");
  filter->AddColumn("Small");
  EXPECT_EQ(filter->GetNumberOfColumns(), 2);
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetArray("Count"), nullptr);
  double range[2];
  data->GetArray("Large")->GetRange(range);
  EXPECT_GT(range[0], 0.0);
  EXPECT_LT(range[0], 1.6e6);
  EXPECT_GT(range[1], 9.5e6);
  EXPECT_LT(range[1], 11e6);
  filter->RemoveAllColumns();
  filter->SetLabelColumn("Count");
  filter->Update();
  // Numbers are labels, too, and are not learned then.
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Count")->GetDataType(), VTK_INT);
}

// Without standardization, the column with the largest numbers determines the map alone.
TEST(SphericalSOM, StandardizationGivesColumnsTheSameEffect)
{
  auto filter = MakeFilter(MakeTable());
  filter->StandardizeOff();
  filter->Update();
  EXPECT_GT(Error(filter, "QuantizationError"), 1e3);
  auto* kinds = vtkStringArray::SafeDownCast(filter->GetTable()->GetColumnByName("Kind"));
  auto* winner = vtkIdTypeArray::SafeDownCast(filter->GetTable()->GetColumnByName("Winner"));
  auto* labels =
    vtkStringArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetAbstractArray("Kind"));
  int wrong = 0;
  for (vtkIdType i = 0; i < Size; ++i)
  {
    wrong += labels->GetValue(winner->GetValue(i)) != kinds->GetValue(i);
  }
  EXPECT_GT(wrong, Size / 10); // first and third differ in "Small" only
}

TEST(SphericalSOM, RowsThatAreNotFiniteAreLeftOut)
{
  auto table = MakeTable();
  auto* small = vtkDoubleArray::SafeDownCast(table->GetColumnByName("Small"));
  small->SetValue(7, std::numeric_limits<double>::quiet_NaN());
  small->SetValue(100, std::numeric_limits<double>::infinity());
  auto filter = MakeFilter(table);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  observed.ExpectWarning("2 of 300 rows have a number that is not finite");
  vtkTable* rows = filter->GetTable();
  for (const char* name : { "Winner", "SecondWinner", "QuantizationError" })
  {
    contract::ExpectArray(rows->GetRowData(), name, -1, 1, Size);
    EXPECT_EQ(rows->GetValueByName(7, name).ToDouble(), -1.0);
    EXPECT_EQ(rows->GetValueByName(100, name).ToDouble(), -1.0);
    EXPECT_GE(rows->GetValueByName(8, name).ToDouble(), 0.0);
  }
  small->Fill(std::numeric_limits<double>::quiet_NaN());
  small->Modified();
  table->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetTable()->GetNumberOfRows(), 0);
}

TEST(SphericalSOM, TablesThatCannotBeUsedAreErrors)
{
  const auto refused =
    [](vtkTable* table, const std::string& column, const char* label, const char* message)
  {
    auto filter = MakeFilter(table);
    filter->SetLabelColumn(label);
    if (!column.empty())
    {
      filter->AddColumn("Small");
      filter->AddColumn(column);
    }
    contract::Observed observed(filter);
    filter->Update();
    observed.ExpectError(message);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetTable()->GetNumberOfRows(), 0);
  };
  refused(MakeTable(), "missing", "", "no column \"missing\" of numbers");
  refused(MakeTable(), "Kind", "", "no column \"Kind\" of numbers");
  refused(MakeTable(), "Small", "", "added twice");
  refused(MakeTable(), "", "missing", "no column \"missing\" of labels");
  refused(MakeTable(), "Count", "Count", "name of another array");
  auto ragged = MakeTable();
  vtkIntArray::SafeDownCast(ragged->GetColumnByName("Count"))->InsertNextValue(1);
  refused(ragged, "", "", "column \"Count\" of the table has 301 rows");
  auto own = MakeTable();
  own->GetColumnByName("Large")->SetName("UMatrix");
  refused(own, "", "", "column \"UMatrix\" has the name of another array");
  for (const char* name : { "Winner", "SecondWinner", "QuantizationError" })
  {
    auto again = MakeTable();
    again->GetColumnByName("Large")->SetName(name);
    const std::string message =
      "column \"" + std::string(name) + "\" has the name of another array";
    refused(again, "", "", message.c_str());
    refused(again, "Count", name, message.c_str());
    auto filter = MakeFilter(again); // neither learned nor the label
    filter->AddColumn("Small");
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 92);
  }
  vtkNew<vtkTable> words;
  words->AddColumn(MakeTable()->GetColumnByName("Kind"));
  refused(words, "", "", "no column of numbers");
  auto few = MakeFilter(MakeTable());
  few->SetNumberOfNeurons(11);
  contract::Observed observed(few);
  few->Update();
  observed.ExpectError("at least 12");
}

TEST(SphericalSOM, AnEmptyTableGivesAWarning)
{
  const vtkNew<vtkTable> table;
  auto filter = MakeFilter(table);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  observed.ExpectWarning("no rows");
}

TEST(SphericalSOM, SameBitsOnAnyBackendAndNumberOfThreads)
{
  const auto winners = [](const char* backend, int threads)
  {
    auto filter = MakeFilter(MakeTable());
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads, backend, false), [&]() { filter->Update(); });
    vtkDataArray* weights = filter->GetOutput()->GetPointData()->GetArray("Small");
    std::vector<double> values;
    for (vtkIdType i = 0; i < weights->GetNumberOfTuples(); ++i)
    {
      values.push_back(weights->GetTuple1(i));
    }
    return values;
  };
  const auto serial = winners("Sequential", 1);
  EXPECT_EQ(winners("STDThread", 2), serial);
  EXPECT_EQ(winners("STDThread", 4), serial);
}

TEST(SphericalSOM, RunsOnlyWhenModifiedAndCanBeAborted)
{
  auto filter = MakeFilter(MakeTable());
  contract::ExpectRunsOnlyWhenModified(filter.Get(), [&]() { filter->SetRandomSeed(2); });
  contract::ExpectRunsOnlyWhenModified(filter.Get(), [&]() { filter->AddColumn("Small"); });
  auto stopped = MakeFilter(MakeTable());
  contract::ExpectStopsWhenAsked(stopped);
}
