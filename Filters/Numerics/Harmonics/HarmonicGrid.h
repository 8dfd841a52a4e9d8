/// Fast transforms between harmonics and values on a grid of the sphere.
/// Separation of variables as in \cite Schaeffer2013.

#ifndef ConformalHarmonicGrid_h
#define ConformalHarmonicGrid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Harmonics/GaussLegendre.h"

namespace conformal
{
/// A grid of directions: heights are Gauss-Legendre nodes, longitudes even. Transforms are Fourier
/// along each parallel, then sums over the parallels: O(L^3) for as many directions as L^2.
class HarmonicGrid
{
public:
  /// The smallest grid that integrates functions up to a degree exactly.
  explicit HarmonicGrid(int degree);

  Index size() const { return this->numberOfParallels() * this->NumberOfLongitudes; }
  Index numberOfParallels() const { return static_cast<Index>(this->Parallels.Nodes.size()); }

  /// Parallel by parallel from the north.
  Points directions() const;

  /// Values of functions.
  /// @param[in] coefficients  (L + 1)^2 by #C, L at most half of the number of longitudes
  /// @return size() by #C
  Columns synthesize(const Columns& coefficients, const Run& run = {}) const;

  /// Integrals of values times harmonics over the sphere: the coefficients of functions whose
  /// degree and L are together at most that of the grid.
  /// @param[in] values  size() by #C
  /// @return (L + 1)^2 by #C
  Columns analyze(const Columns& values, int degree, const Run& run = {}) const;

private:
  GaussLegendre Parallels;
  Index NumberOfLongitudes = 1;
};
}

#endif
