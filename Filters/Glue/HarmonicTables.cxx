#include "Glue/HarmonicTables.h"

#include "Harmonics/SphericalHarmonics.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace
{
constexpr std::array<const char*, 3> Coordinates = { "X", "Y", "Z" };

vtkDataArray* RequiredColumn(vtkTable* table, const char* name)
{
  auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name));
  if (!column || column->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(std::string("the table of coefficients has no column \"") + name +
      "\" of numbers with 1 component; it needs Degree, Order, X, Y and Z");
  }
  return column;
}

// Return the named columns of numbers that are neither degree nor order nor positions.
std::vector<vtkDataArray*> OtherColumns(vtkTable* table)
{
  std::vector<vtkDataArray*> others;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    auto* column = vtkDataArray::SafeDownCast(table->GetColumn(i));
    const std::string name = column && column->GetName() ? column->GetName() : "";
    const bool isOwn = name == "Degree" || name == "Order" ||
      std::find(Coordinates.begin(), Coordinates.end(), name) != Coordinates.end();
    if (!name.empty() && !isOwn && column->GetNumberOfComponents() == 1)
    {
      others.push_back(column);
    }
  }
  return others;
}

// Return the most frequent length of the columns. If several lengths are equally frequent, return
// the smallest of them. A column of another length is invalid.
vtkIdType NumberOfRows(const std::vector<vtkDataArray*>& columns)
{
  std::map<vtkIdType, int> counts;
  for (vtkDataArray* column : columns)
  {
    ++counts[column->GetNumberOfTuples()];
  }
  return std::max_element(
    counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
    ->first;
}

// Return the row of coefficients that belongs to a harmonic.
conformal::Index PlaceOf(double degree, double order, int maximum)
{
  const bool isHarmonic = degree >= 0.0 && degree <= maximum && degree == std::floor(degree) &&
    std::abs(order) <= degree && order == std::floor(order);
  if (!isHarmonic)
  {
    throw std::invalid_argument("the table of coefficients has a row of degree " +
      std::to_string(degree) + " and order " + std::to_string(order) +
      "; its rows are those of degrees from 0 to L, here " + std::to_string(maximum) +
      ", each with orders from minus the degree to the degree");
  }
  return conformal::harmonicIndex(static_cast<int>(degree), static_cast<int>(order));
}
}

namespace glue
{
//------------------------------------------------------------------------------
void ToTable(const Harmonics& harmonics, vtkTable* table)
{
  const int maximum = conformal::degreeOfHarmonics(harmonics.Coefficients.rows());
  vtkNew<vtkIntArray> degrees, orders;
  degrees->SetName("Degree");
  orders->SetName("Order");
  for (int degree = 0; degree <= maximum; ++degree)
  {
    for (int order = -degree; order <= degree; ++order)
    {
      degrees->InsertNextValue(degree);
      orders->InsertNextValue(order);
    }
  }
  table->AddColumn(degrees);
  table->AddColumn(orders);
  for (conformal::Index c = 0; c < harmonics.Coefficients.cols(); ++c)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(c < 3 ? Coordinates[c] : harmonics.Names[c - 3].c_str());
    column->SetNumberOfValues(harmonics.Coefficients.rows());
    std::copy_n(
      harmonics.Coefficients.col(c).data(), harmonics.Coefficients.rows(), column->GetPointer(0));
    table->AddColumn(column);
  }
}

//------------------------------------------------------------------------------
Harmonics FromTable(vtkTable* table)
{
  vtkDataArray* const degrees = RequiredColumn(table, "Degree");
  vtkDataArray* const orders = RequiredColumn(table, "Order");
  std::vector<vtkDataArray*> columns;
  columns.reserve(Coordinates.size());
  for (const char* name : Coordinates)
  {
    columns.push_back(RequiredColumn(table, name));
  }
  Harmonics harmonics;
  for (vtkDataArray* other : OtherColumns(table))
  {
    columns.push_back(other);
    harmonics.Names.emplace_back(other->GetName());
  }
  std::vector<vtkDataArray*> all = columns;
  all.insert(all.end(), { degrees, orders });
  const vtkIdType rows = NumberOfRows(all);
  for (vtkDataArray* column : all)
  {
    if (column->GetNumberOfTuples() != rows)
    {
      throw std::invalid_argument(std::string("the column \"") + column->GetName() + "\" has " +
        std::to_string(column->GetNumberOfTuples()) + " values for " + std::to_string(rows) +
        " rows");
    }
  }

  const int maximum = conformal::degreeOfHarmonics(rows);
  harmonics.Coefficients.resize(rows, static_cast<conformal::Index>(columns.size()));
  std::vector<char> isGiven(rows, 0);
  for (vtkIdType row = 0; row < rows; ++row)
  {
    const double degree = degrees->GetTuple1(row), order = orders->GetTuple1(row);
    const conformal::Index place = PlaceOf(degree, order, maximum);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      const double value = columns[c]->GetTuple1(row);
      if (!std::isfinite(value))
      {
        throw std::invalid_argument("the column \"" + std::string(columns[c]->GetName()) +
          "\" is not finite in row " + std::to_string(row));
      }
      harmonics.Coefficients(place, static_cast<conformal::Index>(c)) = value;
    }
    if (isGiven[place] != 0)
    {
      throw std::invalid_argument("the table of coefficients has two rows of degree " +
        std::to_string(std::lround(degree)) + " and order " + std::to_string(std::lround(order)));
    }
    isGiven[place] = 1;
  }
  return harmonics;
}
}
