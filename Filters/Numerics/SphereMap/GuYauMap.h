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
  Index NumberOfNegativeStringConstants = 0; ///< edges between angles that add up to more than pi
  Index NumberOfInfiniteStringConstants = 0; ///< edges of triangles without area, held by nothing
};

/// Start at the Gauss map; let strings of equal constants, then of the harmonic energy's constants,
/// pull the vertices along the sphere, the weighted mean being put back to the center after each
/// step \cite Gu2004, \cite Liou2008 section 4.1.
///
/// With obtuse triangles string constants are negative and the result folds; with triangles of no
/// area they are infinite. Both are counted; the latter are left out.
///
/// Implementation note: the time step is as long as the largest sum of constants allows and is
/// halved whenever the energy rises, instead of being the same for every mesh.
///
/// @param[in] mesh  about of size one
/// @post the result does not depend on the number of threads
GuYauResult mapByGuYau(const Mesh& mesh, const GuYauOptions& options = {}, const Run& run = {});
}

#endif
