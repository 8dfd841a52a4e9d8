// Tables of spherical-harmonic coefficients, which filters, sources and writers share.
#ifndef GlueHarmonicTables_h
#define GlueHarmonicTables_h

#include "Base/Types.h" // for Columns

#include <string> // for names
#include <vector> // for names

class vtkTable;

namespace glue
{
/// Coefficients of functions, a row for each harmonic in the order of
/// Harmonics/SphericalHarmonics.h.
struct Harmonics
{
  conformal::Columns Coefficients; ///< the first three columns are those of positions
  std::vector<std::string> Names;  ///< of the columns behind those
};

/// A row for each harmonic: columns "Degree" and "Order" (int), "X", "Y", "Z" and the others
/// (double).
void ToTable(const Harmonics& harmonics, vtkTable* table);

/// The same back; rows may be in any order. Further columns of 1 component that have a name and
/// numbers are taken, all others are left out.
/// @throws std::invalid_argument that says which column or row is missing, twice, or not finite, or
///         that the degree is more than conformal::MaximumHarmonicDegree
Harmonics FromTable(vtkTable* table);
}

#endif
