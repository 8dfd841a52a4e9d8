/// Join closed parts of a mesh that overlap each other, such as two lobes of a comet, each modeled
/// as a closed surface.
///
/// Own construction, not from a publication: libraries for Boolean operations on meshes are large,
/// or their licenses are not compatible. Only unions are necessary here.

#ifndef ConformalUnionOfParts_h
#define ConformalUnionOfParts_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Repair/GluedSurface.h"

#include <array>
#include <vector>

namespace conformal
{
/// Mesh in which parts that overlapped are one part.
struct UnionOfParts
{
  /// Number of parts that became parts of others; 0 if no parts overlap. Triangles are then those
  /// of the input, and Positions, PointIds, Parents and IsTurned are empty.
  Index NumberOfPartsJoined = 0;
  /// #V by 3. If a point of the input has several fans of triangles, each fan has a vertex. Added
  /// vertices follow, where an edge of one part passes through a triangle of another.
  Points Positions;
  std::vector<int> PointIds; ///< #V, id of the input's point of each vertex; -1 if there is none
  /// Ids of the input's points at the two ends of the edge that contains each added vertex.
  std::vector<std::array<int, 2>> Parents;
  /// #F by 3 ids of vertices. Whole triangles are first, in the order of the input. Pieces of
  /// triangles that were split follow.
  conformal::Triangles Triangles;
  std::vector<int> TriangleIds;     ///< id of the input's triangle that contains each triangle, #F
  std::vector<char> IsTurned;       ///< whether the orientation of each triangle was reversed, #F
  Index NumberOfWholeTriangles = 0; ///< number of triangles that were not split
  GluingReport Gluing;              ///< changes before parts were joined, see glueAllTriangles()
};

/// Return the result of uniteParts() for triangles that are one part.
UnionOfParts unchangedPart(const Triangles& triangles);

/// Replace parts that cross each other by their union. A part is a set of triangles whose sides are
/// glued (GluedSurface.h), so that repeated, duplicate and reversed triangles and common points of
/// parts do not matter. Only closed parts are joined. A part whose orientation differs from that of
/// the part of largest volume bounds a cavity, unless it crosses a part that does not: it is then
/// turned and joined.
///
/// 1. Find all pairs of triangles that cross each other (SelfIntersections.h). Two triangles that
///    cross have a common segment. At each end of the segment, an edge of one triangle passes
///    through the other triangle.
/// 2. Split these triangles along the segments (TriangleSplit.h).
/// 3. The segments divide both parts into patches. Remove the patches inside the other part. A
///    patch is inside if the solid angle of the other part, seen from the patch, is above 2 pi.
///
/// If points, edges or triangles of two parts coincide, the segments do not form closed curves. One
/// part is then regarded as moved by at most 1e-6 of the size of the mesh, to decide which
/// triangles cross. Points of the input do not move. If no such offset gives closed curves, the
/// parts are not joined. Parts with flush faces do not cross before they are moved. They are joined
/// if their bounding boxes overlap and neither box contains the other.
///
/// Each round joins disjoint pairs of parts, and searches all pairs of triangles again. If all
/// parts cross the same part, the time is therefore quadratic in the number of parts.
/// @param[in] points  coordinates of the points, #P by 3; finite at points used by triangles
/// @param[in] triangles  #F by 3 ids of points
/// @throws Aborted
UnionOfParts uniteParts(const PointView& points, const Triangles& triangles, const Run& run = {});
}

#endif
