/// Check whether a triangle mesh is a closed surface of genus zero, and list its faults. Repair
/// faults without loss: weld points, orient triangles consistently, drop unused points. Own
/// construction: counts of edges, vertex fans and components, because they find every fault in one
/// pass.

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

/// Result of checkGenusZero(). Triangles that repeat a vertex are listed as degenerate, and are not
/// counted in any other member.
struct GenusZeroReport
{
  std::vector<Edge> BoundaryEdges;    ///< edges of only one triangle, directed as in that triangle
  std::vector<Edge> NonManifoldEdges; ///< edges of more than two triangles, smaller id first
  /// Edges that have the same direction in both their triangles, smaller id first
  std::vector<Edge> InconsistentEdges;
  std::vector<int> NonManifoldVertices; ///< vertices at which several fans of triangles meet
  std::vector<int> DegenerateTriangles; ///< triangles with a repeated vertex or without area
  std::vector<int> IsolatedPoints;      ///< points without triangles
  std::vector<int> NonFinitePoints;     ///< points with a coordinate that is NaN or infinite
  Index NumberOfTriangles = 0;          ///< number of triangles that do not repeat a vertex
  Index NumberOfVertices = 0;           ///< number of vertices of the counted triangles
  Index NumberOfEdges = 0;
  Index NumberOfBoundaryLoops = 0; ///< number of connected sets of boundary edges
  Index NumberOfComponents = 0;    ///< number of sets of triangles connected by shared vertices
  Index EulerNumber = 0;           ///< number of vertices - edges + triangles
  bool Orientable = true;
  bool InsideOut = false; ///< whether the mesh is consistently oriented with negative volume

  bool closed() const { return this->NumberOfTriangles > 0 && this->BoundaryEdges.empty(); }
  bool manifold() const
  {
    return this->NonManifoldEdges.empty() && this->NonManifoldVertices.empty();
  }
  /// Test whether the mesh is closed, manifold and connected, and has Euler number 2. Such a
  /// surface is orientable, but its triangles may be oriented inconsistently: see
  /// InconsistentEdges.
  bool isGenusZero() const
  {
    return this->closed() && this->manifold() && this->NumberOfComponents == 1 &&
      this->EulerNumber == 2;
  }
};

/// Check the topology of a mesh. If points are given, also check coordinates, areas and volume.
///
/// @param[in] triangles         #F by 3 vertex ids
/// @param[in] numberOfVertices  #V, the number of vertices, including isolated ones
/// @param[in] points            #V by 3 positions, or empty
/// @throws std::invalid_argument if an id is not in [0, #V)
GenusZeroReport checkGenusZero(const Triangles& triangles, Index numberOfVertices,
  const PointView& points = {}, const Run& run = {});

/// Describe a report in words. The first sentence describes the mesh; each other sentence describes
/// one kind of fault.
std::vector<std::string> describe(const GenusZeroReport& report);

/// Throw an exception unless the triangles form a closed surface of genus zero. The triangles must
/// be consistently oriented, and no triangle may repeat a vertex.
/// @throws std::invalid_argument if the surface has faults; the message describes them
void requireGenusZero(const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Compute the volume enclosed by a closed mesh. It is positive if the triangles are
/// counter-clockwise seen from outside.
double signedVolume(const PointView& points, const Triangles& triangles);

/// Compute the sum of the areas of the triangles.
double surfaceArea(const PointView& points, const Triangles& triangles);

/// Weld an open mesh: of points on boundary edges with equal coordinates, keep only the one with
/// the smallest id. Triangles stored without shared points need this step. Points inside a surface
/// are not welded, so that surfaces that only touch stay separate.
///
/// @param[in,out] triangles  triangles; ids are replaced, and no triangle is dropped
/// @return number of points that were replaced
Index mergeCoincidentBoundaryPoints(
  Triangles& triangles, const PointView& points, const GenusZeroReport& report);

/// Drop triangles that repeat a vertex.
/// @return number of triangles dropped
Index dropRepeatedVertices(Triangles& triangles);

/// Reverse triangles until neighboring triangles have opposite directions on their common edge. In
/// each connected set of triangles, the smaller of the two parts is reversed. If both parts have
/// equal size, the part without the first triangle of the set is reversed.
/// @pre the surface is orientable; otherwise some edges stay inconsistent
/// @return number of triangles reversed
Index orientConsistently(Triangles& triangles);

/// Remove isolated vertices from the numbering. The other vertices keep their order.
/// @param[in,out] triangles  #F by 3 ids in [0, numberOfVertices); replaced by new ids
/// @return old id of each remaining vertex, indexed by its new id
std::vector<int> dropIsolatedPoints(Triangles& triangles, Index numberOfVertices);
}

#endif
