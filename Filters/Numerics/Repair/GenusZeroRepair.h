/// Repairs triangle meshes that are almost closed surfaces of genus zero.
/// Own construction: a sequence of repairs that moves no point.

#ifndef ConformalGenusZeroRepair_h
#define ConformalGenusZeroRepair_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Repair/GluedSurface.h"

#include <utility>
#include <vector>

namespace conformal
{
struct GenusZeroRepairOptions
{
  /// The largest hole that is filled: area of what fills it, as a share of the surface's.
  double MaximumHoleArea = 0.25;
};

enum class RepairLoopType
{
  FilledHole,   ///< a boundary that was filled
  OpenHole,     ///< a boundary that was left: it is too large
  CutHandle,    ///< around a handle, which was cut through there
  FilledTunnel, ///< through a handle, whose hole was filled there
};

/// Where something was repaired, or was not.
struct RepairLoop
{
  RepairLoopType Type = RepairLoopType::FilledHole;
  Points Positions;          ///< #L by 3, in order, the first not again at the end
  double AreaFraction = 0.0; ///< area of what fills it, once, over that of the surface at first
};

/// The mesh that is left and how it was made. Triangles that were not touched come first, in the
/// order of the input; so do vertices, then copies of those along cuts, and new ones.
struct GenusZeroRepairResult : Mesh
{
  std::vector<int> TriangleIds; ///< #F, -1 for those that were added
  std::vector<int> PointIds;    ///< #V, -1 for those that were added
  /// What each added vertex lies between: the ids of points, one or more, that count the same.
  std::vector<std::vector<int>> Parents;
  std::vector<RepairLoop> Loops;

  GluingReport Gluing;
  Index NumberOfPointsMerged = 0;
  Index NumberOfTrianglesAdded = 0;
  Index NumberOfTrianglesUntouched = 0;
  Index EulerNumber = 0;    ///< of the result, by checkGenusZero()
  bool IsGenusZero = false; ///< likewise

  Index count(RepairLoopType type) const;
};

/// Make a closed surface of genus zero of a mesh that has holes, handles, or other parts beside.
///
/// 1. Points of open edges with equal coordinates are merged, and the triangles glued to a manifold
///    of which the largest part is kept (GluedSurface.h).
/// 2. Holes are filled (LoopCap.h), unless they are too large.
/// 3. The mesh is turned outward.
/// 4. As long as there are handles, each is cut along a short loop around it or through it
///    (HandleLoops.h), whichever is shorter, and both sides of the cut are filled. The two sides,
///    and the points along the cut, lie at the same places.
///
/// Nothing is moved. A mesh that needs no repair is returned as it is, but for points of no
/// triangle.
/// @param[in] points  finite where triangles use them
/// @throws std::invalid_argument if there are no triangles, points are not finite, the largest part
///   is not orientable, or an option is out of range
GenusZeroRepairResult repairGenusZero(const PointView& points, const Triangles& triangles,
  const GenusZeroRepairOptions& options = {}, const Run& run = {});
}

#endif
