#include "Glue/TableRows.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace glue
{
namespace
{
std::string NameOf(vtkAbstractArray* column)
{
  return column && column->GetName() ? column->GetName() : "";
}

void RequireEqualLengths(vtkTable* table)
{
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    if (column->GetNumberOfTuples() != table->GetNumberOfRows())
    {
      throw std::invalid_argument("the column \"" + NameOf(column) + "\" of the table has " +
        std::to_string(column->GetNumberOfTuples()) + " rows, but the first column has " +
        std::to_string(table->GetNumberOfRows()));
    }
  }
}

std::vector<vtkDataArray*> ColumnsOf(
  vtkTable* table, const std::vector<std::string>& names, const std::string& label)
{
  std::vector<vtkDataArray*> columns;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns() && names.empty(); ++i)
  {
    auto* column = vtkDataArray::SafeDownCast(table->GetColumn(i));
    const std::string name = NameOf(column);
    if (!name.empty() && name != label && column->GetNumberOfComponents() == 1)
    {
      columns.push_back(column);
    }
  }
  std::set<std::string> known;
  for (const std::string& name : names)
  {
    auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str()));
    if (!column || column->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument(
        "the table has no column \"" + name + "\" of numbers with 1 component");
    }
    if (!known.insert(name).second)
    {
      throw std::invalid_argument("the column \"" + name + "\" was added twice");
    }
    columns.push_back(column);
  }
  if (columns.empty())
  {
    throw std::invalid_argument("the table has no column of numbers with 1 component");
  }
  return columns;
}

template <typename Array, typename Value>
void Append(
  vtkTable* table, const char* name, const TableRows& rows, const std::vector<Value>& values)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->SetNumberOfTuples(table->GetNumberOfRows());
  column->Fill(-1.0);
  for (std::size_t i = 0; i < rows.Ids.size(); ++i)
  {
    column->SetValue(rows.Ids[i], values[i]);
  }
  table->GetRowData()->AddArray(column);
}
}

//------------------------------------------------------------------------------
TableRows ReadRows(vtkTable* table, const std::vector<std::string>& names, const std::string& label)
{
  RequireEqualLengths(table);
  const std::vector<vtkDataArray*> columns = ColumnsOf(table, names, label);
  TableRows rows;
  for (vtkDataArray* column : columns)
  {
    rows.Names.push_back(NameOf(column));
  }
  const auto width = static_cast<conformal::Index>(columns.size());
  rows.Values.resize(width, table->GetNumberOfRows());
  conformal::Index kept = 0;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    for (conformal::Index c = 0; c < width; ++c)
    {
      rows.Values(c, kept) = columns[c]->GetComponent(i, 0);
    }
    if (rows.Values.col(kept).allFinite())
    {
      rows.Ids.push_back(i);
      ++kept;
    }
  }
  rows.NumberOfNonFinite = table->GetNumberOfRows() - kept;
  rows.Values.conservativeResize(width, kept);
  return rows;
}

//------------------------------------------------------------------------------
vtkAbstractArray* LabelColumn(vtkTable* table, const std::string& name)
{
  if (name.empty())
  {
    return nullptr;
  }
  vtkAbstractArray* column = table->GetColumnByName(name.c_str());
  if (!column || column->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(
      "the table has no column \"" + name + "\" of labels with 1 component");
  }
  return column;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> MajorityLabels(vtkAbstractArray* labels,
  const std::vector<vtkIdType>& rows, const std::vector<int>& groups,
  const std::vector<int>& others)
{
  std::map<std::string, int> numberOf; // number of each label
  std::vector<vtkIdType> firstRows;    // first row with each label
  std::vector<std::map<int, int>> counts(others.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const auto [found, isNew] = numberOf.emplace(
      labels->GetVariantValue(rows[i]).ToString(), static_cast<int>(firstRows.size()));
    if (isNew)
    {
      firstRows.push_back(rows[i]);
    }
    ++counts[groups[i]][found->second];
  }
  auto result =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(labels->GetDataType()));
  result->SetName(labels->GetName());
  result->SetNumberOfTuples(static_cast<vtkIdType>(others.size()));
  for (std::size_t g = 0; g < others.size(); ++g)
  {
    // Of equal counts, max_element returns the first, which is the label that comes first.
    const auto most = std::max_element(counts[g].begin(), counts[g].end(),
      [](const auto& a, const auto& b) { return a.second < b.second; });
    const vtkIdType row = most == counts[g].end() ? rows[others[g]] : firstRows[most->first];
    result->SetTuple(static_cast<vtkIdType>(g), row, labels);
  }
  return result;
}

//------------------------------------------------------------------------------
void AppendColumn(
  vtkTable* table, const char* name, const TableRows& rows, const std::vector<int>& values)
{
  Append<vtkIdTypeArray>(table, name, rows, values);
}

//------------------------------------------------------------------------------
void AppendColumn(
  vtkTable* table, const char* name, const TableRows& rows, const std::vector<double>& values)
{
  Append<vtkDoubleArray>(table, name, rows, values);
}
}
