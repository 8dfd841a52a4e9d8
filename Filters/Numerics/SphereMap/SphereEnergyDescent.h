/// Minimize the energy of a whole sphere map by a quasi-Newton method, as in \cite Zhu2018. Each
/// step solves a linear system, so that all parts of the surface move together. Sweeps over single
/// vertices would need more and more steps for smaller triangles.

#ifndef ConformalSphereEnergyDescent_h
#define ConformalSphereEnergyDescent_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Sphere/SphereStar.h"
#include "SphereMap/BoundedTriangles.h"

namespace conformal
{
struct SphereEnergyDescentOptions
{
  SphereEnergy Energy;
  int MaximumNumberOfSteps = 100;
  /// The steps end if a step of Newton's method would decrease the energy by less than this
  /// fraction.
  double Tolerance = 1e-6;
};

struct SphereEnergyMinimum
{
  double Energy = 0.0; ///< energy of the result
  int NumberOfSteps = 0;
  bool Converged = false; ///< whether Tolerance was reached
};

/// Move all vertices of a sphere map to reduce the sum of SphereEnergy over all triangles.
///
/// The search direction is that of the method L-BFGS. Its initial matrix is the Laplacian of the
/// present map on the sphere. The weight of a triangle in the Laplacian is its stiffness divided by
/// its area on the sphere. The stiffness is each term of the energy, times the square of the
/// exponent of the area A in this term. The matrix is factored again every few steps. A step is
/// shortened until the energy decreases and no triangle is flipped.
/// @param[in] shapes          triangles of the surface
/// @param[in,out] positions   #V by 3 unit vectors without flipped triangles
/// @throws Aborted
/// @post the result does not depend on the number of threads
SphereEnergyMinimum descendSphereEnergy(const Triangles& triangles, const BoundedTriangles& shapes,
  Points& positions, const SphereEnergyDescentOptions& options = {}, const Run& run = {});
}

#endif
