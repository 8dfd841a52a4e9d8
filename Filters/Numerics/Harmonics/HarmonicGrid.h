/// Fast transforms between coefficients of spherical harmonics and values on a grid of the sphere,
/// by separation of variables as in \cite Schaeffer2013.

#ifndef ConformalHarmonicGrid_h
#define ConformalHarmonicGrid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Harmonics/GaussLegendre.h"

namespace conformal
{
/// Grid of directions. The heights of its parallels are Gauss-Legendre nodes; longitudes are evenly
/// spaced. A transform consists of a Fourier transform along each parallel and a sum over
/// parallels. The cost is O(L^3) for about L^2 directions.
class HarmonicGrid
{
public:
  /// Make the smallest grid that integrates functions up to the given degree exactly.
  explicit HarmonicGrid(int degree);

  Index size() const { return this->numberOfParallels() * this->NumberOfLongitudes; }
  Index numberOfParallels() const { return static_cast<Index>(this->Parallels.Nodes.size()); }

  /// Return the directions, parallel by parallel, beginning with the northernmost parallel.
  Points directions() const;

  /// Evaluate functions, given by coefficients, in the directions of the grid.
  /// @param[in] coefficients  (L + 1)^2 by #C; L is at most half of the number of longitudes
  /// @return size() by #C
  Columns synthesize(const Columns& coefficients, const Run& run = {}) const;

  /// Integrate values times harmonics over the sphere. The result is exact for functions whose
  /// degree plus L is at most the degree of the grid.
  /// @param[in] values  size() by #C
  /// @param[in] degree  degree L
  /// @return (L + 1)^2 by #C
  Columns analyze(const Columns& values, int degree, const Run& run = {}) const;

private:
  GaussLegendre Parallels;
  Index NumberOfLongitudes = 1;
};
}

#endif
