// Convert tables of VTK to rows of numbers for the numerical core, and columns of results to
// arrays.
#ifndef GlueTableRows_h
#define GlueTableRows_h

#include "Base/Types.h" // for Columns

#include "vtkSmartPointer.h" // for arrays

#include <string> // for names
#include <vector> // for names

class vtkAbstractArray;
class vtkTable;

namespace glue
{
/// Rows of a table without those that have a number that is not finite.
struct TableRows
{
  std::vector<std::string> Names; ///< names of the columns
  conformal::Columns Values;      ///< a row for each column of the table, and a column for each row
  std::vector<vtkIdType> Ids;     ///< row of the table of each column of Values
  vtkIdType NumberOfNonFinite = 0; ///< number of rows that are left out
};

/// Read columns of numbers with 1 component.
/// @param[in] names  names of the columns. If empty, all named columns of numbers with 1 component
///   are read, except for the column `label`.
/// @throws std::invalid_argument if columns have different lengths, or if a column is missing, is
///   given twice, or has no numbers with 1 component
TableRows ReadRows(
  vtkTable* table, const std::vector<std::string>& names, const std::string& label);

/// Return the column of labels, or null if the name is empty.
/// @throws std::invalid_argument if the column is missing, or does not have 1 component
vtkAbstractArray* LabelColumn(vtkTable* table, const std::string& name);

/// Make an array with the label of each group of rows: the most frequent label of its rows. Of
/// labels that are equally frequent, the one that comes first in the table is used. A group without
/// rows gets the label of a given row.
/// @param[in] labels  labels of the rows of a table: strings or numbers
/// @param[in] rows    rows of the table to which `groups` refers
/// @param[in] groups  group of each row
/// @param[in] others  for each group, the row whose label is used if the group has none
/// @return array with the type and name of `labels`, and a value for each group
vtkSmartPointer<vtkAbstractArray> MajorityLabels(vtkAbstractArray* labels,
  const std::vector<vtkIdType>& rows, const std::vector<int>& groups,
  const std::vector<int>& others);

///@{
/// Append a column to a table, with a value for each row that was read, and -1 for all other rows.
/// A column with the same name is replaced.
void AppendColumn(
  vtkTable* table, const char* name, const TableRows& rows, const std::vector<int>& values);
void AppendColumn(
  vtkTable* table, const char* name, const TableRows& rows, const std::vector<double>& values);
///@}
}

#endif
