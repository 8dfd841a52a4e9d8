/// Repair triangle meshes that are almost closed surfaces of genus zero. The method is an own
/// construction, not from a publication. Holes are filled and handles are cut without moving
/// points, because the given points are measured data.

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
  /// Maximum area of the filling of a hole, in [0, 1]. The unit is the area of the largest
  /// connected part of the input. Larger holes stay open.
  double MaximumHoleArea = 0.25;
};

/// Kind of a loop of edges where the mesh was repaired, or left open.
enum class RepairLoopType
{
  FilledHole, ///< boundary of a hole that was filled
  /// Boundary of a hole that was left open, since the area of its filling would exceed the maximum
  OpenHole,
  CutHandle,    ///< loop around a handle; the handle was cut along this loop
  FilledTunnel, ///< loop around the opening of a handle; the opening was filled
};

/// Location of a repair, or of a hole that was left open.
struct RepairLoop
{
  RepairLoopType Type = RepairLoopType::FilledHole;
  /// Consecutive points of the loop, #L by 3. The first point is not repeated at the end.
  Points Positions;
  /// Area of the filling of the loop, divided by the area of the largest connected part of the
  /// input. A cut handle has two fillings; the area is that of one.
  double AreaFraction = 0.0;
};

/// Repaired mesh, with the source of each triangle and vertex in the input. Unchanged triangles are
/// first, in the order of the input. Pieces of triangles that were split where parts overlap
/// follow, mixed with added triangles. Likewise, vertices at points of the input are first,
/// including copies of vertices along cuts. Added vertices follow.
struct GenusZeroRepairResult : Mesh
{
  /// Id of the input triangle of each triangle or piece, or -1 for an added triangle, #F.
  std::vector<int> TriangleIds;
  /// Id of the input point of each vertex, or -1 for an added vertex, #V.
  std::vector<int> PointIds;
  /// Ids of one or more input points for each added vertex. The point data of the vertex are the
  /// mean over these points.
  std::vector<std::vector<int>> Parents;
  std::vector<RepairLoop> Loops;

  GluingReport Gluing;
  Index NumberOfPointsMerged = 0;
  Index NumberOfPartsJoined = 0; ///< number of parts that overlap others and were joined with them
  Index NumberOfTrianglesAdded = 0; ///< includes pieces of triangles that were split
  Index NumberOfTrianglesUntouched = 0;
  Index EulerNumber = 0;    ///< Euler number of the result, by checkGenusZero()
  bool IsGenusZero = false; ///< whether the result has genus zero, by checkGenusZero()

  Index count(RepairLoopType type) const;
};

/// Make a closed surface of genus zero from a mesh with holes, handles, or disconnected parts.
///
/// 1. Merge points with equal coordinates, if they are on open edges (edges of only one triangle).
///    Replace closed parts that overlap by their union (UnionOfParts.h).
/// 2. Connect the triangles along shared edges, so that they form manifolds. Keep the connected
///    manifold of largest area (GluedSurface.h).
/// 3. Fill each hole by a disk of triangles (LoopCap.h), unless the disk would exceed
///    MaximumHoleArea. If two vertices are then joined by several edges, split all of these edges
///    but one.
/// 4. Orient the mesh outward.
/// 5. While there are handles, find a short loop at each handle (HandleLoops.h). The loop runs
///    around the handle, or through its opening if that is shorter. Cut the mesh along the loop.
///    The cut duplicates the points of the loop. Fill both boundaries of the cut. The two fillings
///    coincide in space.
///
/// No point is moved. If parts overlap, their union has added points where edges pass through
/// triangles, and pieces of triangles. If a mesh needs no repair, the result equals the input
/// without unused points.
/// @param[in] points  coordinates of the points, #P by 3; must be finite at points used by
///   triangles
/// @param[in] triangles  #F by 3 ids of points
/// @throws std::invalid_argument if there are no triangles, or if points are not finite
/// @throws std::invalid_argument if the largest connected part is not orientable, or if an option
///   is out of range
GenusZeroRepairResult repairGenusZero(const PointView& points, const Triangles& triangles,
  const GenusZeroRepairOptions& options = {}, const Run& run = {});
}

#endif
