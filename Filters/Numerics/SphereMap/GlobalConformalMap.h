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
  Robust, ///< default method: a one-to-one map for every surface tested, conformal where possible
  GuYau   ///< method as published, which may fold
};

/// Step in which the method Robust succeeded.
enum class GlobalConformalTier
{
  Harmonic, ///< one linear solve was sufficient
  Repaired, ///< folds of the linear solution were repaired locally
  /// The map was computed by mapToSphere(), because a conformal map would underflow or AreaBalance
  /// is above 0
  Progressive
};

struct GlobalConformalMapOptions
{
  GlobalConformalMethod Method = GlobalConformalMethod::Robust;
  /// For Robust: 0 gives a conformal map, 1 a map that nearly preserves areas
  double AreaBalance = 0.0;
  int MaximumNumberOfIterations = 5000; ///< for GuYau: maximum for each of its two phases
  double Tolerance = 1e-7; ///< for GuYau: relative change of the energy at which a phase ends
};

struct GlobalConformalMapResult
{
  Points Positions; ///< #V by 3 unit vectors
  GlobalConformalTier Tier = GlobalConformalTier::Harmonic;
  double Energy = 0.0;          ///< harmonic energy; 4 pi for a conformal map, larger for any other
  Index NumberOfIterations = 0; ///< for GuYau: number of steps; for Robust: number of linear solves
  /// Whether no triangle is flipped. For GuYau, both phases must also have reached Tolerance, and
  /// no string constant may be infinite.
  bool Converged = false;
  Index NumberOfFlippedTriangles = 0; ///< number of flipped triangles, by exact arithmetic
  /// Number of edges whose opposite angles have a sum above pi
  Index NumberOfNegativeStringConstants = 0;
  Index NumberOfInfiniteStringConstants = 0; ///< number of edges of triangles with zero area
};

/// Map a closed surface of genus zero to the unit sphere, \cite Liou2008 section 4.1. Triangles are
/// counter-clockwise seen from outside, both on the surface and on the sphere.
///
/// The method Robust has these steps:
/// 1. Map by punctureToSphere(), and repair folds by repairFlips().
/// 2. If the removed triangle (the puncture) lies on a limb, repeat step 1 with another triangle.
/// 3. Move vertices of misshapen triangles to preserve angles better.
/// 4. If a triangle is flipped or too small, use mapToSphere() instead, with the smallest
///    sufficient AreaBalance. The last attempt uses ConnectivityFirst, which has succeeded on every
///    surface tested.
///
/// If AreaBalance is above 0, only mapToSphere() is used.
///
/// Conformal maps are unique up to a Moebius transform. The transform is chosen so that the mean of
/// the sphere positions, weighted by areas of the surface, is the center of the sphere. Finally the
/// sphere is rotated, so that positions agree best with directions from the center of the surface.
///
/// @param[in] mesh  surface; finite, without unused positions; triangles may have zero area
/// @throws std::invalid_argument if the surface is not closed, manifold and of genus zero, an
///   option is out of range, or points are not finite
/// @throws NumericalFailure if no method finds a valid position for a vertex
/// @post the result does not depend on the number of threads
GlobalConformalMapResult globalConformalMap(
  const Mesh& mesh, const GlobalConformalMapOptions& options = {}, const Run& run = {});
}

#endif
