/// Global conformal map of Gu and Yau, as published.

#ifndef ConformalGuYauMap_h
#define ConformalGuYauMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct GuYauOptions
{
  int MaximumNumberOfIterations = 5000; ///< maximum for each phase, at least 0
  double Tolerance = 1e-7;              ///< relative change of the energy at which a phase ends
};

struct GuYauResult
{
  Points Positions;             ///< #V by 3 unit vectors
  double Energy = 0.0;          ///< harmonic energy; 4 pi for a conformal map
  Index NumberOfIterations = 0; ///< number of steps of both phases
  bool Converged = false;       ///< whether both phases reached the tolerance
  /// Number of edges whose opposite angles have a sum above pi
  Index NumberOfNegativeStringConstants = 0;
  Index NumberOfInfiniteStringConstants = 0; ///< number of edges of triangles with zero area
};

/// Minimize the harmonic energy, starting from the Gauss map, \cite Gu2004, \cite Liou2008 section
/// 4.1. Each edge is a string that pulls its vertices along the sphere; its weight is the string
/// constant. The first phase uses equal constants, the second phase those of the harmonic energy.
/// After each step, the sphere is transformed so that the weighted mean of the positions is its
/// center.
///
/// Obtuse triangles can cause negative string constants, which may fold the map. Triangles of zero
/// area cause infinite constants, which are ignored. Both kinds of edges are counted.
///
/// Implementation note: the time step is the longest that is stable for the largest sum of
/// constants at a vertex. It is halved whenever the energy rises. \cite Liou2008 uses one time step
/// for every mesh.
///
/// @param[in] mesh  mesh of size about 1
/// @post the result does not depend on the number of threads
GuYauResult mapByGuYau(const Mesh& mesh, const GuYauOptions& options = {}, const Run& run = {});
}

#endif
