// Convert coefficients of spherical harmonics to tables of VTK and back, for filters, sources and
// writers.
#ifndef GlueHarmonicTables_h
#define GlueHarmonicTables_h

#include "Base/Types.h" // for Columns

#include <string> // for names
#include <vector> // for names

class vtkTable;

namespace glue
{
/// Coefficients of functions on the sphere. Each function is a weighted sum of spherical harmonics,
/// and the weights are its coefficients. Each row belongs to one spherical harmonic. The rows are
/// in the order of harmonicIndex() in Harmonics/SphericalHarmonics.h.
struct Harmonics
{
  /// Three columns of coefficients of positions (x, y, z), then columns of further functions.
  conformal::Columns Coefficients;
  std::vector<std::string> Names; ///< names of the columns after the first three
};

/// Convert coefficients to a table with one row for each spherical harmonic. The first columns are
/// "Degree" and "Order" (int), and "X", "Y" and "Z" (double). Then follow the columns of further
/// functions (double).
void ToTable(const Harmonics& harmonics, vtkTable* table);

/// Convert a table with the columns of ToTable() to coefficients. The rows can be in any order.
/// Columns of further functions must have a name and contain numbers of 1 component. All other
/// columns are skipped.
/// @throws std::invalid_argument if a column or row is missing, repeated or not finite. The message
///   contains the column or row.
/// @throws std::invalid_argument if the maximum degree is above conformal::MaximumHarmonicDegree
Harmonics FromTable(vtkTable* table);
}

#endif
