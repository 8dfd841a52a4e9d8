/// Triangles glued side to side: any triangles become a manifold, which can be filled and cut.
/// Cutting and stitching as in \cite Gueziec2001.

#ifndef ConformalGluedSurface_h
#define ConformalGluedSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Repair/LoopCap.h"

#include <vector>

namespace conformal
{
/// Side 3 r + k of triangle r runs from its corner k to the next one. Two triangles are neighbors
/// if their sides are glued, not if they name the same points: so the surface is a manifold
/// whatever the triangles, and where several fans of triangles meet in a point, each has a vertex
/// of its own there.
struct GluedSurface
{
  std::vector<int> Corners;       ///< #3F vertices
  std::vector<int> Across;        ///< #3F sides, each glued to that one; -1 on the boundary
  std::vector<int> TriangleIds;   ///< #F of what it was made of, or one of the two below
  std::vector<Vector3> Positions; ///< #V
  std::vector<int> PointIds;      ///< #V of what it was made of; Added for others
  /// #V: of added vertices the points that they lie between, one or more; else empty.
  std::vector<std::vector<int>> Parents;

  static constexpr int Added = -1;     ///< was added
  static constexpr int Temporary = -2; ///< a triangle that was added and is to be removed again

  int numberOfSides() const { return static_cast<int>(this->Corners.size()); }
  int numberOfTriangles() const { return static_cast<int>(this->TriangleIds.size()); }
  int numberOfVertices() const { return static_cast<int>(this->PointIds.size()); }
  static int after(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static int before(int side) { return side % 3 == 0 ? side + 2 : side - 1; }
  int from(int side) const { return this->Corners[side]; }
  int to(int side) const { return this->Corners[after(side)]; }

  /// The next side from the same vertex, clockwise or counter-clockwise; -1 behind the last.
  int clockwise(int side) const { return this->Across[side] < 0 ? -1 : after(this->Across[side]); }
  int counterClockwise(int side) const { return this->Across[before(side)]; }
};

/// What was done to the triangles to glue them.
struct GluingReport
{
  Index NumberOfRepeatedPoints = 0;   ///< triangles dropped because they name a point twice
  Index NumberOfDuplicates = 0;       ///< triangles dropped because another has their points
  Index NumberOfNonManifoldEdges = 0; ///< of more than two triangles, of the whole mesh
  Index NumberOfTurnedTriangles = 0;  ///< of the largest part
  Index NumberOfPartsRemoved = 0;
  Index NumberOfTrianglesRemoved = 0; ///< of these parts
  double AreaRemoved = 0.0;           ///< of these parts, as a share of all
};

/// Glue triangles to the largest surface that they make.
///
/// 1. Triangles that name a point twice, or the same points as one before, are dropped.
/// 2. The two sides of an edge are glued. Of more than two, those are glued that agree in
///    orientation and go on most straight; bodies that only touch come apart. What is left has a
///    boundary there.
/// 3. In each part triangles are turned to agree with the most.
/// 4. The part of the largest area is kept.
///
/// Points, also the copies of those where fans of triangles met, have the order of the input, as
/// have triangles.
/// @param[in] points     finite
/// @param[in] triangles  #F by 3 ids of them
/// @throws std::invalid_argument if the largest part is not orientable
GluedSurface glueTriangles(
  const PointView& points, const Triangles& triangles, GluingReport& report, const Run& run = {});

/// The boundary as loops of sides, each of which ends where the next begins.
std::vector<std::vector<int>> openLoops(const GluedSurface& surface);

/// Corners of a loop of sides, in the order in which a cap has to turn around them.
Points cornersOfCap(const GluedSurface& surface, const std::vector<int>& loop);

/// A cap that fits a loop of sides: no edge of it joins vertices that are joined already.
LoopCap capFor(const GluedSurface& surface, const std::vector<int>& loop);

/// Close a loop of open sides: two are glued to each other, more get the cap.
/// @param[in] cap         of cornersOfCap()
/// @param[in] triangleId  Added or Temporary
void closeLoop(GluedSurface& surface, const std::vector<int>& loop, const LoopCap& cap,
  int triangleId = GluedSurface::Added);

/// Cut along a loop of glued sides that passes no vertex twice. What lies to the right of it gets
/// vertices of its own.
/// @return the loop of open sides on the right
std::vector<int> cutAlong(GluedSurface& surface, const std::vector<int>& loop);

/// Where several glued edges join the same two vertices, put a vertex into all of them but one, so
/// that triangles tell by their vertices alone how they are glued.
/// @return the number of vertices put in
Index splitDoubleEdges(GluedSurface& surface);
}

#endif
