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
  Robust, ///< conformal, and one to one for every surface
  GuYau   ///< as published: may fold
};

/// Method by which Robust succeeded.
enum class GlobalConformalTier
{
  Harmonic,   ///< one linear solve was enough
  Repaired,   ///< folds were repaired locally
  Progressive ///< mapToSphere(): a conformal map would underflow, or AreaBalance is above 0
};

struct GlobalConformalMapOptions
{
  GlobalConformalMethod Method = GlobalConformalMethod::Robust;
  /// Robust: 0 is conformal, 1 nearly preserves areas.
  double AreaBalance = 0.0;
  int MaximumNumberOfIterations = 5000; ///< GuYau, of each of its two phases
  double Tolerance = 1e-7;              ///< GuYau, relative change of the energy that ends a phase
};

struct GlobalConformalMapResult
{
  Points Positions; ///< #V by 3 unit vectors
  GlobalConformalTier Tier = GlobalConformalTier::Harmonic;
  double Energy = 0.0;          ///< harmonic energy; 4 pi if conformal, never below
  Index NumberOfIterations = 0; ///< GuYau: steps; Robust: linear solves
  /// Whether no triangle is flipped. For GuYau, both phases must also have ended by Tolerance, and
  /// no string constant may be infinite.
  bool Converged = false;
  Index NumberOfFlippedTriangles = 0;        ///< by exact arithmetic
  Index NumberOfNegativeStringConstants = 0; ///< edges opposite to two angles with a sum above pi
  Index NumberOfInfiniteStringConstants = 0; ///< edges of triangles of zero area
};

/// Map a closed surface of genus zero to the unit sphere, \cite Liou2008 section 4.1. Triangles are
/// counter-clockwise seen from outside, as they are on the surface.
///
/// Robust proceeds in these steps:
/// 1. Map by punctureToSphere(), and repair folds by repairFlips().
/// 2. If the puncture lies on a limb, use another one.
/// 3. Relax the angles of misshapen triangles.
/// 4. If a triangle is flipped or too small, use mapToSphere() with the smallest sufficient
///    AreaBalance. Its last attempt uses ConnectivityFirst, which has succeeded on every surface
///    tried.
///
/// With AreaBalance above 0, mapToSphere() is used directly.
///
/// Conformal maps are unique up to a Moebius transform. The area-weighted mean of the surface is
/// moved to the center of the sphere. The sphere is rotated to agree best with directions from the
/// center of the surface.
///
/// @param[in] mesh  finite, all positions used; triangles may have zero area
/// @throws std::invalid_argument if the surface is not closed, manifold and of genus zero, an
///   option is out of range, or points are not finite
/// @throws NumericalFailure if no method finds a valid position for a vertex
/// @post the result does not depend on the number of threads
GlobalConformalMapResult globalConformalMap(
  const Mesh& mesh, const GlobalConformalMapOptions& options = {}, const Run& run = {});
}

#endif
