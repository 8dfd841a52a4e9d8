/// Glue triangles along their sides. Any set of triangles thus becomes a manifold, whose holes can
/// be filled and which can be cut. Cutting and stitching as in \cite Gueziec2001.

#ifndef ConformalGluedSurface_h
#define ConformalGluedSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Repair/LoopCap.h"

#include <vector>

namespace conformal
{
/// Manifold of triangles with explicitly glued sides.
///
/// Side 3 r + k of triangle r runs from its corner k to the next one. Two triangles are neighbors
/// if their sides are glued, whether or not they share points. The surface is therefore a manifold
/// for any triangles. If several fans of triangles share a point, each fan has its own vertex at
/// the point.
struct GluedSurface
{
  std::vector<int> Corners;       ///< #3F, vertex at the start of each side
  std::vector<int> Across;        ///< #3F, side to which each side is glued; -1 on the boundary
  std::vector<int> TriangleIds;   ///< #F, id of the input triangle, or Added, or Temporary
  std::vector<Vector3> Positions; ///< #V
  std::vector<int> PointIds;      ///< #V, id of the input point, or Added
  /// #V: for an added vertex, ids of one or more input points; their mean gives its point data.
  /// Empty for other vertices.
  std::vector<std::vector<int>> Parents;

  static constexpr int Added = -1;     ///< added triangle or vertex
  static constexpr int Temporary = -2; ///< added triangle that is removed later

  int numberOfSides() const { return static_cast<int>(this->Corners.size()); }
  int numberOfTriangles() const { return static_cast<int>(this->TriangleIds.size()); }
  int numberOfVertices() const { return static_cast<int>(this->PointIds.size()); }
  static int after(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static int before(int side) { return side % 3 == 0 ? side + 2 : side - 1; }
  int from(int side) const { return this->Corners[side]; }
  int to(int side) const { return this->Corners[after(side)]; }

  /// Return the next side that starts at the same vertex, clockwise or counter-clockwise; -1 at the
  /// boundary.
  int clockwise(int side) const { return this->Across[side] < 0 ? -1 : after(this->Across[side]); }
  int counterClockwise(int side) const { return this->Across[before(side)]; }
};

/// Statistics of glueTriangles().
struct GluingReport
{
  Index NumberOfRepeatedPoints = 0;   ///< triangles removed because a point is repeated
  Index NumberOfDuplicates = 0;       ///< triangles removed because another one has equal points
  Index NumberOfNonManifoldEdges = 0; ///< edges of more than two triangles in the whole input
  /// Triangles of the largest part whose orientation was reversed.
  Index NumberOfTurnedTriangles = 0;
  Index NumberOfPartsRemoved = 0;
  Index NumberOfTrianglesRemoved = 0; ///< triangles of removed parts
  double AreaRemoved = 0.0;           ///< area of removed parts divided by the total area
};

/// Glue triangles to surfaces and keep the largest one.
///
/// 1. Remove triangles with repeated points, and duplicates of earlier triangles.
/// 2. Glue the two sides of each edge. If an edge has more than two sides, glue pairs of consistent
///    orientation with the smallest dihedral bend; this separates bodies that touch. Sides without
///    a partner form the boundary.
/// 3. In each connected part, orient triangles consistently with the majority.
/// 4. Keep the connected part of largest area.
///
/// Vertices and triangles have the order of the input. Where several fans of triangles shared a
/// point, the copies of the point are adjacent in this order.
/// @param[in] points     finite
/// @param[in] triangles  #F by 3 ids of points
/// @throws std::invalid_argument if the largest part is not orientable
GluedSurface glueTriangles(
  const PointView& points, const Triangles& triangles, GluingReport& report, const Run& run = {});

/// Return the boundary as loops of sides. Each side ends where the next side of its loop begins.
std::vector<std::vector<int>> openLoops(const GluedSurface& surface);

/// Return the corner positions of a loop of sides, ordered for the orientation of a cap that fills
/// the loop.
Points cornersOfCap(const GluedSurface& surface, const std::vector<int>& loop);

/// Make a cap that fills a loop of sides. No inner edge of the cap joins vertices that already
/// share an edge.
LoopCap capFor(const GluedSurface& surface, const std::vector<int>& loop);

/// Close a loop of open sides: glue two sides to each other, or fill a loop of three or more sides
/// with the cap.
/// @param[in] cap         triangles over cornersOfCap()
/// @param[in] triangleId  value of TriangleIds for the cap's triangles: Added or Temporary
void closeLoop(GluedSurface& surface, const std::vector<int>& loop, const LoopCap& cap,
  int triangleId = GluedSurface::Added);

/// Cut along a loop of glued sides that visits no vertex twice. The surface to the right of the
/// loop gets new vertices.
/// @return the loop of open sides on the right
std::vector<int> cutAlong(GluedSurface& surface, const std::vector<int>& loop);

/// Insert vertices where several glued edges join the same two vertices. All of these edges but one
/// get a vertex. Afterward, the vertex ids of the triangles determine which triangles are adjacent.
/// @return the number of inserted vertices
Index splitDoubleEdges(GluedSurface& surface);
}

#endif
