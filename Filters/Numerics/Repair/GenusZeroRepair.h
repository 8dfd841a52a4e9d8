/// Repair triangle meshes that are almost closed surfaces of genus zero. Own construction: holes
/// are filled and handles are cut without moving points, because the given points are data.

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
  /// Maximum area of the filling of a hole, as a fraction of the surface area.
  double MaximumHoleArea = 0.25;
};

enum class RepairLoopType
{
  FilledHole,   ///< filled boundary
  OpenHole,     ///< boundary left open, since its filling would be larger than the maximum area
  CutHandle,    ///< loop around a handle, along which the handle was cut
  FilledTunnel, ///< loop around the opening of a handle; the opening was filled
};

/// Location of a repair, or of a hole left open.
struct RepairLoop
{
  RepairLoopType Type = RepairLoopType::FilledHole;
  /// #L by 3, consecutive points of the loop; the first point is not repeated at the end.
  Points Positions;
  double AreaFraction = 0.0; ///< area of one filling divided by the area of the original surface
};

/// Repaired mesh, with the source of each triangle and vertex in the input. Unchanged triangles are
/// first, in the order of the input. Unchanged vertices are first, then their copies along cuts,
/// then added vertices.
struct GenusZeroRepairResult : Mesh
{
  std::vector<int> TriangleIds; ///< #F, triangle of the input, or -1 for an added triangle
  std::vector<int> PointIds;    ///< #V, point of the input, or -1 for an added vertex
  /// For each added vertex, ids of one or more input points; their mean gives its point data.
  std::vector<std::vector<int>> Parents;
  std::vector<RepairLoop> Loops;

  GluingReport Gluing;
  Index NumberOfPointsMerged = 0;
  Index NumberOfTrianglesAdded = 0;
  Index NumberOfTrianglesUntouched = 0;
  Index EulerNumber = 0;    ///< Euler number of the result, by checkGenusZero()
  bool IsGenusZero = false; ///< whether the result has genus zero, by checkGenusZero()

  Index count(RepairLoopType type) const;
};

/// Make a closed surface of genus zero from a mesh with holes, handles, or disconnected parts.
///
/// 1. Merge points of open edges with equal coordinates. Glue the triangles to a manifold and keep
///    its largest part (GluedSurface.h).
/// 2. Fill holes up to the maximum area (LoopCap.h).
/// 3. Orient the mesh outward.
/// 4. While there are handles, cut each along a short loop around or through it, whichever is
///    shorter (HandleLoops.h). Fill both sides of the cut. The two sides, and the points along the
///    cut, coincide.
///
/// No point is moved. A mesh that needs no repair is returned unchanged, except that unused points
/// are removed.
/// @param[in] points  finite where triangles use them
/// @throws std::invalid_argument if there are no triangles, points are not finite, the largest part
///   is not orientable, or an option is out of range
GenusZeroRepairResult repairGenusZero(const PointView& points, const Triangles& triangles,
  const GenusZeroRepairOptions& options = {}, const Run& run = {});
}

#endif
