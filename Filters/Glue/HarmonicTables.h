// Convert coefficients of spherical harmonics to tables and back, for filters, sources and writers.
#ifndef GlueHarmonicTables_h
#define GlueHarmonicTables_h

#include "Base/Types.h" // for Columns

#include <string> // for names
#include <vector> // for names

class vtkTable;

namespace glue
{
/// Coefficients of functions on the sphere. There is one row for each harmonic, in the order of
/// harmonicIndex() in Harmonics/SphericalHarmonics.h.
struct Harmonics
{
  conformal::Columns Coefficients; ///< first the three columns of positions, then further columns
  std::vector<std::string> Names;  ///< names of the columns after the first three
};

/// Convert coefficients to a table with one row for each harmonic. Its columns are "Degree" and
/// "Order" (int), then "X", "Y", "Z" and the further columns with their names (double).
void ToTable(const Harmonics& harmonics, vtkTable* table);

/// Convert a table to coefficients. Rows may have any order. Further named columns of numbers with
/// 1 component are included; all other columns are skipped.
/// @throws std::invalid_argument if a column or row is missing, repeated or not finite; the message
///   contains the column or row
/// @throws std::invalid_argument if the degree is above conformal::MaximumHarmonicDegree
Harmonics FromTable(vtkTable* table);
}

#endif
