/// Global conformal parameterization of Gu and Yau, as published.

#ifndef ConformalGuYauMap_h
#define ConformalGuYauMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct GuYauOptions
{
  int MaximumNumberOfIterations = 5000; ///< of each phase, at least 0
  double Tolerance = 1e-7;              ///< relative change of the energy that ends a phase
};

struct GuYauResult
{
  Points Positions;                          ///< #V by 3 unit vectors
  double Energy = 0.0;                       ///< of the second phase; 4 pi for a conformal map
  Index NumberOfIterations = 0;              ///< of both phases
  bool Converged = false;                    ///< both phases ended by the tolerance
  Index NumberOfNegativeStringConstants = 0; ///< edges opposite to two angles with a sum above pi
  Index NumberOfInfiniteStringConstants = 0; ///< edges of triangles of zero area; exert no force
};

/// Minimize the harmonic energy from the Gauss map \cite Gu2004, \cite Liou2008 section 4.1. The
/// first phase uses equal string constants, the second those of the harmonic energy. Strings pull
/// vertices along the sphere. After each step, the weighted mean is moved back to the center.
///
/// Obtuse triangles have negative string constants, which may fold the result. Triangles of zero
/// area have infinite ones, which are ignored. Both are counted.
///
/// Implementation note: the time step is the longest that the maximum sum of constants allows, and
/// is halved whenever the energy rises. The paper uses one time step for every mesh.
///
/// @param[in] mesh  about of size one
/// @post the result does not depend on the number of threads
GuYauResult mapByGuYau(const Mesh& mesh, const GuYauOptions& options = {}, const Run& run = {});
}

#endif
