/// Global conformal map of a closed surface to the sphere.

#ifndef ConformalGlobalConformalMap_h
#define ConformalGlobalConformalMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
enum class GlobalConformalMethod
{
  Robust, ///< conformal, and one to one whatever the surface
  GuYau   ///< as published: may fold
};

/// What Robust had to do.
enum class GlobalConformalTier
{
  Harmonic,   ///< one linear solve was enough
  Repaired,   ///< folds were taken out in places
  Progressive ///< mapToSphere: a conformal map would not fit into numbers, or areas were asked for
};

struct GlobalConformalMapOptions
{
  GlobalConformalMethod Method = GlobalConformalMethod::Robust;
  /// Robust: from conformal, 0, to nearly equal in area, 1.
  double AreaBalance = 0.0;
  int MaximumNumberOfIterations = 5000; ///< GuYau, of each of its two phases
  double Tolerance = 1e-7;              ///< GuYau, relative change of the energy that ends a phase
};

struct GlobalConformalMapResult
{
  Points Positions; ///< #V by 3 unit vectors
  GlobalConformalTier Tier = GlobalConformalTier::Harmonic;
  double Energy = 0.0;          ///< harmonic; 4 pi if conformal, never below
  Index NumberOfIterations = 0; ///< GuYau: steps; Robust: linear solves
  /// No triangle is flipped and, for GuYau, both phases ended by Tolerance and no string constant
  /// is infinite.
  bool Converged = false;
  Index NumberOfFlippedTriangles = 0;        ///< by exact arithmetic
  Index NumberOfNegativeStringConstants = 0; ///< edges between angles of more than pi in sum
  Index NumberOfInfiniteStringConstants = 0; ///< edges of triangles without area
};

/// Map a closed surface of genus zero to the unit sphere, triangles counter-clockwise seen from
/// outside as they are on the surface.
///
/// Robust: punctureToSphere; repairFlips where it folds; another puncture where the first lies on a
/// limb; the angles of misshapen triangles relaxed; and if all this leaves a triangle flipped, or
/// too small to be told from one, mapToSphere with as little AreaBalance as will do, in the end
/// with its ConnectivityFirst, which has found room on every surface tried. An AreaBalance above 0
/// takes mapToSphere at once.
///
/// Conformal maps are given up to a Moebius transform: the area-weighted mean of the surface is
/// moved to the sphere's center, and the sphere turned to where it agrees best with directions from
/// the surface's middle.
///
/// @param[in] mesh  finite, all positions used; triangles may have no area
/// @throws std::invalid_argument with what is wrong, if the surface is not closed, manifold and of
///         genus zero, if an option is out of range, or points are not finite
/// @throws NumericalFailure if all that finds no room for a vertex
/// @post the result does not depend on the number of threads
/// \cite Liou2008 section 4.1
GlobalConformalMapResult globalConformalMap(
  const Mesh& mesh, const GlobalConformalMapOptions& options = {}, const Run& run = {});
}

#endif
