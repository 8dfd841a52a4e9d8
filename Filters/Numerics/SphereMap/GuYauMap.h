/// Map a closed surface of genus zero conformally to the sphere by the published method of Gu and
/// Yau, \cite Gu2004.

#ifndef ConformalGuYauMap_h
#define ConformalGuYauMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct GuYauOptions
{
  /// Maximum number of steps in each of the two phases, at least 0
  int MaximumNumberOfIterations = 5000;
  double Tolerance = 1e-7; ///< relative change of the energy per step at which a phase ends
};

struct GuYauResult
{
  Points Positions; ///< #V by 3 unit vectors
  /// Harmonic energy; tends to 4 pi for conformal maps of fine meshes, to more for other maps
  double Energy = 0.0;
  Index NumberOfIterations = 0; ///< number of steps of both phases
  bool Converged = false;       ///< whether both phases reached the tolerance
  /// Number of edges with a negative string constant (stiffness of a spring, see mapByGuYau()): the
  /// sum of the angles opposite to the edge exceeds pi
  Index NumberOfNegativeStringConstants = 0;
  /// Number of edges with an infinite string constant: an adjacent triangle has zero area
  Index NumberOfInfiniteStringConstants = 0;
};

/// Minimize the harmonic energy of a map to the sphere, \cite Gu2004 and \cite Liou2008 section
/// 4.1. The initial map is the Gauss map, which maps each vertex to its normal. The energy is the
/// elastic energy of springs along the edges. The springs are called strings in \cite Gu2004. The
/// string constant of an edge is the stiffness of its spring. The energy is reduced by steps of
/// gradient descent, in two phases. The first phase uses equal constants. The second phase uses
/// cotangent weights, which define the harmonic energy. After each step, the area-weighted mean of
/// the positions is subtracted, and the positions are normalized.
///
/// Obtuse triangles can cause negative string constants. With negative constants, the map may have
/// folds (flipped triangles). Triangles of zero area cause infinite constants, which are ignored.
/// The result contains the numbers of edges with negative and with infinite constants.
///
/// Implementation note: the time step is the factor of the gradient in a step. Its initial value is
/// the reciprocal of the largest sum of absolute constants at a vertex. A longer time step would be
/// unstable. If the energy rises, the time step is halved. In contrast, \cite Liou2008 uses one
/// time step for every mesh.
///
/// @param[in] mesh  closed mesh of genus zero, with coordinates of magnitude about 1
/// @post the result does not depend on the number of threads
GuYauResult mapByGuYau(const Mesh& mesh, const GuYauOptions& options = {}, const Run& run = {});
}

#endif
