/// Map a closed surface of genus zero to the sphere, conformally where possible, \cite Liou2008
/// section 4.1.

#ifndef ConformalGlobalConformalMap_h
#define ConformalGlobalConformalMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
enum class GlobalConformalMethod
{
  Robust, ///< default method: one-to-one for every surface tested, and conformal where possible
  GuYau   ///< published method of Gu and Yau; its maps may have folds (flipped triangles)
};

/// Tier (stage of the method Robust) that computed the map.
enum class GlobalConformalTier
{
  Harmonic, ///< the solution of linear equations had no folds
  Repaired, ///< the solution of linear equations had folds, which were repaired locally
  /// The map was computed by mapToSphere(), which inserts the vertices one by one. This tier is
  /// used if AreaBalance is above 0, or if triangles of a conformal map would be too small for
  /// double precision.
  Progressive
};

struct GlobalConformalMapOptions
{
  GlobalConformalMethod Method = GlobalConformalMethod::Robust;
  /// For Robust: balance between angles and areas, in [0, 1]. The value 0 gives a conformal map, 1
  /// a map that nearly preserves areas.
  double AreaBalance = 0.0;
  /// For GuYau: maximum number of steps in each of its two phases, see mapByGuYau()
  int MaximumNumberOfIterations = 5000;
  /// For GuYau: relative change of the energy per step at which a phase ends
  double Tolerance = 1e-7;
};

struct GlobalConformalMapResult
{
  Points Positions; ///< #V by 3 unit vectors
  GlobalConformalTier Tier = GlobalConformalTier::Harmonic;
  /// Harmonic energy; tends to 4 pi for conformal maps of fine meshes, to more for other maps
  double Energy = 0.0;
  Index NumberOfIterations = 0; ///< for GuYau: number of steps; for Robust: number of linear solves
  /// Whether the map is valid: no triangle is flipped. GuYau has two more conditions: both phases
  /// have reached Tolerance, and no string constant (cotangent weight of an edge) is infinite.
  bool Converged = false;
  Index NumberOfFlippedTriangles = 0; ///< number of flipped triangles, computed in exact arithmetic
  /// Number of edges with a negative string constant (cotangent weight): the sum of the angles
  /// opposite to the edge exceeds pi
  Index NumberOfNegativeStringConstants = 0;
  /// Number of edges with an infinite string constant: an adjacent triangle has zero area
  Index NumberOfInfiniteStringConstants = 0;
};

/// Map a closed surface of genus zero to the unit sphere, \cite Liou2008 section 4.1. Triangles are
/// counter-clockwise seen from outside, both on the surface and on the sphere.
///
/// The method Robust has these steps:
/// 1. Remove one triangle (the puncture), and map the rest of the surface by linear equations, see
///    punctureToSphere(). Repair folds (flipped triangles) locally, see repairFlips().
/// 2. If the repair fails, or the puncture is on a limb (long, thin part), repeat step 1 once with
///    another triangle.
/// 3. Find triangles whose angles are not preserved. Move the vertices of these triangles so that
///    angles are preserved better.
/// 4. If a triangle is flipped or too small, use mapToSphere() instead. This function inserts the
///    vertices one by one. It has its own option AreaBalance,
///    ProgressiveSphereMapOptions::AreaBalance. Several values of this option are tried in
///    ascending order. The last attempt inserts vertices as if all triangles were equilateral, with
///    equal areas (option ConnectivityFirst). This attempt succeeded on every surface tested.
///
/// If AreaBalance is above 0, steps 1 to 3 are omitted, and only mapToSphere() is used. The map
/// then minimizes an energy of angles and areas over the surface. It hardly depends on the
/// triangles: if each triangle is divided into four, positions on the sphere change by 0.2 degrees
/// on the cow Spot.
///
/// Conformal maps are unique up to a Moebius transform (conformal map of the sphere to itself). For
/// a conformal map, this transform is chosen so that the area-weighted mean of the sphere positions
/// is the sphere's center. Finally, maps of Robust are rotated. The rotation brings sphere
/// positions as close as possible to the directions from the surface's center to its vertices.
///
/// @param[in] mesh  surface with finite positions, all of them used by triangles. Triangles may
///   have zero area.
/// @throws std::invalid_argument if the surface is not closed, manifold and of genus zero. Also
///   thrown if an option is out of range, or a position is not finite.
/// @throws NumericalFailure if no method finds a valid position for a vertex
/// @post the result does not depend on the number of threads
GlobalConformalMapResult globalConformalMap(
  const Mesh& mesh, const GlobalConformalMapOptions& options = {}, const Run& run = {});
}

#endif
