/// Convert coefficients of spherical harmonics to values on a grid of the sphere, and back. These
/// fast transforms separate longitude and latitude, as in \cite Schaeffer2013.

#ifndef ConformalHarmonicGrid_h
#define ConformalHarmonicGrid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Harmonics/GaussLegendre.h"

namespace conformal
{
/// Grid of directions on the sphere, arranged on parallels (circles of equal latitude). The heights
/// z of the parallels are Gauss-Legendre nodes (GaussLegendre.h). The longitudes are evenly spaced.
/// A transform consists of a Fourier transform along each parallel, and a sum over parallels. The
/// cost is O(L^3) for about L^2 directions, where L is the degree of the harmonics.
class HarmonicGrid
{
public:
  /// Make a grid that integrates functions up to the given degree exactly, by weighted sums over
  /// its directions. A function has degree D if it is a sum of spherical harmonics up to degree D.
  /// The given degree is called the degree of the grid.
  explicit HarmonicGrid(int degree);

  /// Return the number of directions.
  Index size() const { return this->numberOfParallels() * this->NumberOfLongitudes; }
  Index numberOfParallels() const { return static_cast<Index>(this->Parallels.Nodes.size()); }

  /// Return all directions, one parallel after the other, from the north pole to the south pole.
  Points directions() const;

  /// Evaluate functions in the directions of the grid.
  /// @param[in] coefficients  (L + 1)^2 by #C, coefficients of #C functions. The degree L is at
  ///   most half of the number of longitudes.
  /// @return size() by #C values
  Columns synthesize(const Columns& coefficients, const Run& run = {}) const;

  /// Integrate values times harmonics over the sphere. Let D be the degree of the function that has
  /// the given values. If D + L is at most the degree of the grid, the integrals are exact.
  /// @param[in] values  size() by #C values in the directions of the grid
  /// @param[in] degree  maximum degree L of the harmonics
  /// @return (L + 1)^2 by #C integrals. If the integrals are exact, they are the coefficients of
  ///   the functions.
  Columns analyze(const Columns& values, int degree, const Run& run = {}) const;

private:
  GaussLegendre Parallels;
  Index NumberOfLongitudes = 1;
};
}

#endif
