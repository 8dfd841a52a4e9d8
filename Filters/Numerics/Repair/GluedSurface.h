/// Connect triangles along their sides, so that any set of triangles becomes a manifold. Fill holes
/// of the manifold, and cut the manifold along loops. Cutting and connecting (stitching) are as in
/// \cite Gueziec2001.

#ifndef ConformalGluedSurface_h
#define ConformalGluedSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Repair/LoopCap.h"

#include <vector>

namespace conformal
{
/// Manifold of triangles whose sides are explicitly glued, that is, declared to be the same edge.
///
/// Triangle r has the three sides 3 r + k, with k in {0, 1, 2}. Side 3 r + k runs from corner k of
/// the triangle to the next corner. Two triangles are neighbors if their sides are glued. Triangles
/// that share points, but no glued sides, are not neighbors. Any set of triangles is therefore a
/// manifold. A fan is a set of triangles that are connected around a point. If several fans share a
/// point, each fan has a separate vertex at the point.
struct GluedSurface
{
  std::vector<int> Corners; ///< #3F, vertex at the start of each side
  std::vector<int> Across;  ///< #3F, side that is glued to each side; -1 on the boundary
  /// #F, id of the input triangle; Added or Temporary if there is none.
  std::vector<int> TriangleIds;
  std::vector<Vector3> Positions; ///< #V, position of each vertex
  std::vector<int> PointIds; ///< #V, id of the input point of each vertex; Added if there is none
  /// #V, ids of one or more input points for each added vertex. The point data of the vertex are
  /// the mean over these points. The list is empty for other vertices.
  std::vector<std::vector<int>> Parents;

  static constexpr int Added = -1; ///< mark of a triangle or vertex that is not in the input
  /// Mark of a triangle that is removed later, for example in a hole that stays open.
  static constexpr int Temporary = -2;

  int numberOfSides() const { return static_cast<int>(this->Corners.size()); }
  int numberOfTriangles() const { return static_cast<int>(this->TriangleIds.size()); }
  int numberOfVertices() const { return static_cast<int>(this->PointIds.size()); }
  static int after(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static int before(int side) { return side % 3 == 0 ? side + 2 : side - 1; }
  int from(int side) const { return this->Corners[side]; }
  int to(int side) const { return this->Corners[after(side)]; }

  /// Return the next side that starts at the same vertex as the given side, in clockwise or
  /// counter-clockwise direction. Return -1 at the boundary.
  int clockwise(int side) const { return this->Across[side] < 0 ? -1 : after(this->Across[side]); }
  int counterClockwise(int side) const { return this->Across[before(side)]; }
};

/// Counts of the changes that glueTriangles() made.
struct GluingReport
{
  /// Number of triangles removed because two corners are the same point.
  Index NumberOfRepeatedPoints = 0;
  /// Number of triangles removed because an earlier triangle has the same points.
  Index NumberOfDuplicates = 0;
  /// Number of edges of more than two triangles in the whole input.
  Index NumberOfNonManifoldEdges = 0;
  /// Number of points of the largest connected part that have several vertices, one for each fan.
  Index NumberOfSeparatedPoints = 0;
  /// Number of triangles whose orientation was reversed, in the largest connected part.
  Index NumberOfTurnedTriangles = 0;
  Index NumberOfPartsRemoved = 0;     ///< number of connected parts that were not kept
  Index NumberOfTrianglesRemoved = 0; ///< number of triangles in the removed parts
  double AreaRemoved = 0.0;           ///< area of the removed parts divided by the total area
};

/// Glue triangles to form manifold surfaces, and keep the largest surface.
///
/// 1. Remove triangles with repeated points, and duplicates of earlier triangles.
/// 2. At each edge of two triangles, glue the sides of the two triangles to each other. If more
///    than two triangles share an edge, glue their sides in pairs. Pairs of consistent orientation
///    are glued first. Among these pairs, the pair with the smallest angle between the normals of
///    its triangles is first. If two bodies touch at an edge, this order separates the bodies.
///    Sides without a partner form the boundary.
/// 3. In each connected part, orient all triangles consistently. Keep the orientation that most
///    triangles of the part have in the input.
/// 4. Keep the connected part of largest area.
///
/// Vertices and triangles have the order of the input. If a point has several vertices, one for
/// each fan, the ids of these vertices are consecutive.
/// @param[in] points  finite coordinates, #P by 3
/// @param[in] triangles  #F by 3 ids of points
/// @param[out] report  counts of the changes
/// @throws std::invalid_argument if the largest connected part is not orientable
GluedSurface glueTriangles(
  const PointView& points, const Triangles& triangles, GluingReport& report, const Run& run = {});

/// Glue triangles as glueTriangles() does, and keep all parts. The members NumberOfPartsRemoved,
/// NumberOfTrianglesRemoved and AreaRemoved of the report are not changed. Sides of a part that is
/// not orientable are not glued where they do not agree.
GluedSurface glueAllTriangles(
  const PointView& points, const Triangles& triangles, GluingReport& report, const Run& run = {});

/// Return the number of points of the input that have several vertices, one for each fan. Vertices
/// of a point must have consecutive ids, as after glueTriangles().
Index numberOfSeparatedPoints(const GluedSurface& surface);

/// Return the boundary as loops of open sides (sides that are not glued). Each side ends where the
/// next side of its loop begins.
std::vector<std::vector<int>> openLoops(const GluedSurface& surface);

/// Return the positions at the corners of a loop of sides, in the order that capLoop() requires.
/// The function capLoop() fills the loop with a disk of triangles (cap).
Points cornersOfCap(const GluedSurface& surface, const std::vector<int>& loop);

/// Make a cap, a disk of triangles that fills a loop of sides. No inner edge of the cap joins
/// vertices that already share an edge.
LoopCap capFor(const GluedSurface& surface, const std::vector<int>& loop);

/// Close a loop of open sides. If the loop has two sides, glue them to each other. Otherwise, fill
/// the loop with a cap.
/// @param[in] cap  result of capFor() for the loop
/// @param[in] triangleId  value of TriangleIds for the triangles of the cap: Added or Temporary
void closeLoop(GluedSurface& surface, const std::vector<int>& loop, const LoopCap& cap,
  int triangleId = GluedSurface::Added);

/// Cut the surface along a loop of glued sides. The loop must not visit a vertex twice. Triangles
/// to the right of the loop get copies of its vertices.
/// @return the new loop of open sides, on the right of the cut
std::vector<int> cutAlong(GluedSurface& surface, const std::vector<int>& loop);

/// Insert vertices where several glued edges join the same two vertices. One of these edges is left
/// unchanged; a vertex is inserted in each of the others. Afterward, two triangles with two common
/// vertex ids are always neighbors.
/// @return the number of inserted vertices
Index splitDoubleEdges(GluedSurface& surface);
}

#endif
