/// Check whether a triangle mesh is a closed surface of genus zero, and list its faults. Also
/// repair faults without loss: weld, orient consistently, drop unused points. Own construction:
/// counts of edges, vertex fans and components, so that one pass finds every fault.

#ifndef ConformalGenusZeroCheck_h
#define ConformalGenusZeroCheck_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <array>
#include <string>
#include <vector>

namespace conformal
{
using Edge = std::array<int, 2>; ///< two vertex ids

/// Result of checkGenusZero(). Triangles that repeat a vertex are listed as degenerate and excluded
/// from all other figures.
struct GenusZeroReport
{
  std::vector<Edge> BoundaryEdges;    ///< edges of one triangle, directed as in that triangle
  std::vector<Edge> NonManifoldEdges; ///< edges of more than two triangles, smaller id first
  /// Edges with one direction in both triangles, smaller id first
  std::vector<Edge> InconsistentEdges;
  std::vector<int> NonManifoldVertices; ///< vertices where several fans of triangles touch
  std::vector<int> DegenerateTriangles; ///< triangles with a repeated vertex or without area
  std::vector<int> IsolatedPoints;      ///< points without triangles
  std::vector<int> NonFinitePoints;     ///< points with a coordinate that is NaN or infinite
  Index NumberOfTriangles = 0;          ///< excluding triangles that repeat a vertex
  Index NumberOfVertices = 0;           ///< number of vertices of the counted triangles
  Index NumberOfEdges = 0;
  Index NumberOfBoundaryLoops = 0; ///< connected sets of boundary edges
  Index NumberOfComponents = 0;    ///< sets of triangles connected by shared vertices
  Index EulerNumber = 0;           ///< vertices - edges + triangles
  bool Orientable = true;
  bool InsideOut = false; ///< whether the mesh is consistently oriented with negative volume

  bool closed() const { return this->NumberOfTriangles > 0 && this->BoundaryEdges.empty(); }
  bool manifold() const
  {
    return this->NonManifoldEdges.empty() && this->NonManifoldVertices.empty();
  }
  /// Test whether the mesh is closed, manifold, connected and of Euler number 2. Such a surface is
  /// orientable, but its triangles may be oriented inconsistently: see InconsistentEdges.
  bool isGenusZero() const
  {
    return this->closed() && this->manifold() && this->NumberOfComponents == 1 &&
      this->EulerNumber == 2;
  }
};

/// Check the topology of a mesh and, if points are given, its areas and volume.
///
/// @param[in] triangles         #F by 3 vertex ids
/// @param[in] numberOfVertices  #V, including isolated vertices
/// @param[in] points            #V by 3, or empty
/// @throws std::invalid_argument if an id is not in [0, #V)
GenusZeroReport checkGenusZero(const Triangles& triangles, Index numberOfVertices,
  const PointView& points = {}, const Run& run = {});

/// Describe a report in words: one statement of what the mesh is, then one for each fault.
std::vector<std::string> describe(const GenusZeroReport& report);

/// Throw unless the triangles form a consistently oriented closed surface of genus zero without
/// repeated vertices in a triangle.
/// @throws std::invalid_argument with the description of the faults
void requireGenusZero(const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Compute the volume enclosed by a closed mesh, positive if triangles are counter-clockwise seen
/// from outside.
double signedVolume(const PointView& points, const Triangles& triangles);

/// Compute the sum of the areas of the triangles.
double surfaceArea(const PointView& points, const Triangles& triangles);

/// Weld an open mesh: replace points of boundary edges with equal coordinates by the one of
/// smallest id. Polygon soups need this step. Interior points are not welded, so that surfaces that
/// only touch stay separate.
///
/// @param[in,out] triangles  ids are replaced; no triangle is dropped
/// @return the number of points that were replaced
Index mergeCoincidentBoundaryPoints(
  Triangles& triangles, const PointView& points, const GenusZeroReport& report);

/// Drop triangles that repeat a vertex.
/// @return the number of triangles dropped
Index dropRepeatedVertices(Triangles& triangles);

/// Reverse triangles until neighbors run their common edge in opposite directions. In each
/// connected set the smaller part is reversed; on a tie, the part without its first triangle.
/// @pre orientable; otherwise some edges stay inconsistent
/// @return the number of triangles reversed
Index orientConsistently(Triangles& triangles);

/// Renumber the vertices so that none is isolated, keeping their order.
/// @param[in,out] triangles  #F by 3 ids in [0, numberOfVertices)
/// @return the old id of each new id
std::vector<int> dropIsolatedPoints(Triangles& triangles, Index numberOfVertices);
}

#endif
