/// Glue triangles side to side: any triangles become a manifold, which can be filled and cut.
/// Cutting and stitching as in \cite Gueziec2001.

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
/// for any triangles. If several fans of triangles share a point, each has a vertex of its own
/// there.
struct GluedSurface
{
  std::vector<int> Corners;       ///< #3F vertices
  std::vector<int> Across;        ///< #3F, the side that each side is glued to; -1 on the boundary
  std::vector<int> TriangleIds;   ///< #F ids of input triangles, or Added or Temporary
  std::vector<Vector3> Positions; ///< #V
  std::vector<int> PointIds;      ///< #V ids of input points; Added for others
  /// #V: for added vertices, the ids of one or more points of which it is the mean; otherwise
  /// empty.
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

  /// Return the next side from the same vertex, clockwise or counter-clockwise; -1 at the boundary.
  int clockwise(int side) const { return this->Across[side] < 0 ? -1 : after(this->Across[side]); }
  int counterClockwise(int side) const { return this->Across[before(side)]; }
};

/// Statistics of glueTriangles().
struct GluingReport
{
  Index NumberOfRepeatedPoints = 0;   ///< triangles removed because a point is repeated
  Index NumberOfDuplicates = 0;       ///< triangles removed because another one has equal points
  Index NumberOfNonManifoldEdges = 0; ///< edges of more than two triangles, of the whole mesh
  Index NumberOfTurnedTriangles = 0;  ///< triangles with reversed orientation, of the largest part
  Index NumberOfPartsRemoved = 0;
  Index NumberOfTrianglesRemoved = 0; ///< triangles of removed parts
  double AreaRemoved = 0.0;           ///< area of removed parts over the total area
};

/// Glue triangles to surfaces and keep the largest one.
///
/// 1. Remove triangles with repeated points, and duplicates of earlier triangles.
/// 2. Glue the two sides of each edge. Of more than two sides, glue those of consistent orientation
///    with the smallest bend; touching bodies are separated. The remaining sides form a boundary.
/// 3. In each part, orient triangles consistently with the majority.
/// 4. Keep the part of largest area.
///
/// Points keep the order of the input, including their copies where fans of triangles met.
/// Triangles keep the order of the input.
/// @param[in] points     finite
/// @param[in] triangles  #F by 3 ids of points
/// @throws std::invalid_argument if the largest part is not orientable
GluedSurface glueTriangles(
  const PointView& points, const Triangles& triangles, GluingReport& report, const Run& run = {});

/// Return the boundary as loops of sides, each of which ends where the next begins.
std::vector<std::vector<int>> openLoops(const GluedSurface& surface);

/// Return the corners of a loop of sides, in the order required for the orientation of a cap.
Points cornersOfCap(const GluedSurface& surface, const std::vector<int>& loop);

/// Make a cap that fits a loop of sides: none of its edges joins vertices that already share an
/// edge.
LoopCap capFor(const GluedSurface& surface, const std::vector<int>& loop);

/// Close a loop of open sides: glue two sides to each other, fill three or more by the cap.
/// @param[in] cap         of cornersOfCap()
/// @param[in] triangleId  Added or Temporary
void closeLoop(GluedSurface& surface, const std::vector<int>& loop, const LoopCap& cap,
  int triangleId = GluedSurface::Added);

/// Cut along a simple loop of glued sides. The surface to the right of the loop gets new vertices.
/// @return the loop of open sides on the right
std::vector<int> cutAlong(GluedSurface& surface, const std::vector<int>& loop);

/// Insert vertices where several glued edges join the same two vertices, in all of these edges but
/// one. Afterwards, vertex ids alone determine adjacency.
/// @return the number of inserted vertices
Index splitDoubleEdges(GluedSurface& surface);
}

#endif
