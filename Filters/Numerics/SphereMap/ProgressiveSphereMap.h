/// Map a closed surface of genus zero to the sphere without folds (flipped triangles),
/// \cite Praun2003. The surface is first simplified to a tetrahedron, whose four vertices are
/// mapped. All other vertices are then inserted one by one.

#ifndef ConformalProgressiveSphereMap_h
#define ConformalProgressiveSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Mesh/QuadricCollapse.h"

#include <limits>

namespace conformal
{
/// Method that moves the vertices after all of them are inserted.
enum class SphereMapFinish
{
  Sweeps, ///< NumberOfSweeps and NumberOfSmoothingSweeps, see below
  /// Minimize the energy of the whole map by descendSphereEnergy(). The map then depends on the
  /// surface, and hardly on its triangles.
  Minimum
};

struct ProgressiveSphereMapOptions
{
  /// Balance between angles and areas, in [0, 1]. The value 0 gives a nearly conformal map, 1 a map
  /// that nearly preserves areas.
  double AreaBalance = 0.5;
  SphereMapFinish Finish = SphereMapFinish::Sweeps;
  /// Number of sweeps for SphereMapFinish::Sweeps, at least 0. A sweep moves each vertex once to
  /// reduce the energy.
  int NumberOfSweeps = 30;
  /// Number of later sweeps, after the sweeps of NumberOfSweeps. In the later sweeps, triangles
  /// with the highest energy have more weight.
  int NumberOfSmoothingSweeps = 30;
  /// Treatment of needles (very thin triangles) by QuadricCollapse, which simplifies the surface.
  /// Keep collapses vertices of needles last, and Thin collapses these vertices like other
  /// vertices. Use Thin if large parts of the surface are connected by necks that consist of
  /// needles. With Keep, the vertices of these parts could be inserted only after all vertices of
  /// the necks.
  QuadricCollapse::Needles SurfaceNeedles = QuadricCollapse::Needles::Keep;
  /// Maximum number of relaxations: before some insertions, nearby vertices must be moved to make
  /// space. One relaxation may need one second of running time. If the number is exceeded,
  /// NumericalFailure is thrown.
  Index MaximumNumberOfRelaxations = std::numeric_limits<Index>::max();
  /// Whether to collapse and insert vertices as if all triangles were equilateral, with equal
  /// areas. The final sweeps always use the true shapes. Use this option only if all other attempts
  /// fail.
  bool ConnectivityFirst = false;
};

struct ProgressiveSphereMapResult
{
  Points Positions;                   ///< #V by 3 unit vectors
  Index NumberOfFlippedTriangles = 0; ///< number of flipped triangles of the result; always 0
  /// Number of relaxations: insertions before which nearby vertices were moved to make space
  Index NumberOfRelaxations = 0;
};

/// Map a closed surface of genus zero one-to-one to the unit sphere, \cite Praun2003. Triangles are
/// counter-clockwise seen from outside, both on the surface and on the sphere.
///
/// The surface is first collapsed to a tetrahedron. A collapse removes one vertex. The four
/// vertices of the tetrahedron are placed on the sphere. All other vertices are then inserted in
/// the reverse sequence of the collapses. Each vertex is inserted in the kernel of its neighbors'
/// polygon: positions at which no triangle is flipped. Between and after the insertions, vertices
/// are moved to reduce SphereEnergy, an energy of angles and areas. Moves that would flip a
/// triangle are rejected. An insertion moves the new vertex and its neighbors. A neighbor of many
/// triangles is moved only at some of the insertions, so that the costs of an insertion are
/// bounded.
///
/// Implementation note: \cite Praun2003 minimizes another energy, called stretch. Here, the energy
/// of a triangle is its conformal energy (distortion of angles) times a power of S / A. S is the
/// area of the triangle on the surface, and A is its area on the sphere. AreaBalance determines the
/// exponent. Depending on AreaBalance, maps are nearly conformal, nearly area-preserving, or in
/// between. SphereMapFinish::Minimum minimizes such an energy, with other exponents. The energy of
/// \cite Praun2003 is the sum over triangles of S D/A^2, the Dirichlet energy of the inverse map.
///
/// @param[in] mesh  surface with finite positions, all of them used by triangles. Triangles may
///   have zero area.
/// @throws std::invalid_argument if the surface is not closed, manifold and of genus zero. Also
///   thrown if an option is out of range, or a position is not finite.
/// @throws NumericalFailure if a vertex has no valid position, or the surface has fewer than four
///   triangles
/// @post the result depends only on the arguments: the same input gives the same bits
ProgressiveSphereMapResult mapToSphere(
  const Mesh& mesh, const ProgressiveSphereMapOptions& options = {}, const Run& run = {});
}

#endif
