// Tables of spherical-harmonic coefficients, shared by filters, sources and writers.
#ifndef GlueHarmonicTables_h
#define GlueHarmonicTables_h

#include "Base/Types.h" // for Columns

#include <string> // for names
#include <vector> // for names

class vtkTable;

namespace glue
{
/// Coefficients of functions, one row for each harmonic in the order of
/// Harmonics/SphericalHarmonics.h.
struct Harmonics
{
  conformal::Columns Coefficients; ///< the first three columns are those of positions
  std::vector<std::string> Names;  ///< of the columns after the first three
};

/// Convert coefficients to a table of one row for each harmonic: columns "Degree" and "Order"
/// (int), "X", "Y", "Z" and the named ones (double).
void ToTable(const Harmonics& harmonics, vtkTable* table);

/// Convert a table to coefficients; rows may have any order. Further named columns of numbers with
/// 1 component are included, all others are skipped.
/// @throws std::invalid_argument with the column or row, if it is missing, repeated or not finite
/// @throws std::invalid_argument if the degree is above conformal::MaximumHarmonicDegree
Harmonics FromTable(vtkTable* table);
}

#endif
