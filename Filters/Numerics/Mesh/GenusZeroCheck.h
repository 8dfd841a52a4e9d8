/// Check whether a triangle mesh is a closed surface of genus zero, and list its faults. Repair
/// some faults without changing the shape: weld points, orient triangles consistently, drop unused
/// points. The check is our own construction. Every fault is found in one pass, by counts of edges,
/// components and fans (triangles connected by edges at a vertex).

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

/// Result of checkGenusZero(). The member DegenerateTriangles lists triangles with a repeated
/// vertex. All other members ignore triangles with a repeated vertex.
struct GenusZeroReport
{
  std::vector<Edge> BoundaryEdges; ///< edges of exactly one triangle, directed as in that triangle
  std::vector<Edge> NonManifoldEdges; ///< edges of more than two triangles, smaller id first
  /// Edges of two triangles that contain the edge in the same direction, smaller id first
  std::vector<Edge> InconsistentEdges;
  /// Vertices with more than one fan (set of triangles connected by edges at the vertex)
  std::vector<int> NonManifoldVertices;
  std::vector<int> DegenerateTriangles; ///< triangles with a repeated vertex or without area
  std::vector<int> IsolatedPoints;      ///< points without triangles
  std::vector<int> NonFinitePoints;     ///< points with a coordinate that is NaN or infinite
  Index NumberOfTriangles = 0;          ///< number of triangles without a repeated vertex
  /// Number of vertices of triangles without a repeated vertex
  Index NumberOfVertices = 0;
  Index NumberOfEdges = 0;
  Index NumberOfBoundaryLoops = 0; ///< number of connected sets of boundary edges
  Index NumberOfComponents = 0;    ///< number of sets of triangles connected by shared vertices
  Index EulerNumber = 0;           ///< number of vertices minus edges plus triangles
  bool Orientable = true;
  /// Whether the mesh is oriented consistently, but with negative signedVolume()
  bool InsideOut = false;

  bool closed() const { return this->NumberOfTriangles > 0 && this->BoundaryEdges.empty(); }
  bool manifold() const
  {
    return this->NonManifoldEdges.empty() && this->NonManifoldVertices.empty();
  }
  /// Test whether the mesh is closed, manifold and connected, and has Euler number 2. The result
  /// can be true for inconsistently oriented triangles, see InconsistentEdges.
  bool isGenusZero() const
  {
    return this->closed() && this->manifold() && this->NumberOfComponents == 1 &&
      this->EulerNumber == 2;
  }
  /// Test whether the mesh is a sheet: manifold and connected, with a border or several, and
  /// without handles. The result can be true for inconsistently oriented triangles, see
  /// InconsistentEdges.
  bool isSheet() const
  {
    return this->manifold() && this->Orientable && this->NumberOfComponents == 1 &&
      this->NumberOfBoundaryLoops >= 1 && this->EulerNumber == 2 - this->NumberOfBoundaryLoops;
  }
  /// Return the number of handles of a closed, manifold, connected and orientable surface; -1 for
  /// other meshes. A torus has one handle.
  Index numberOfHandles() const
  {
    const bool isSurface =
      this->closed() && this->manifold() && this->Orientable && this->NumberOfComponents == 1;
    return isSurface ? (2 - this->EulerNumber) / 2 : -1;
  }
};

/// Check the topology of a mesh. If points are given, also check for non-finite coordinates, for
/// triangles without area, and for negative volume.
///
/// @param[in] triangles         #F by 3 vertex ids
/// @param[in] numberOfVertices  #V, the number of vertices, including isolated ones
/// @param[in] points            #V by 3 positions, or empty
/// @throws std::invalid_argument if an id is not in [0, #V)
GenusZeroReport checkGenusZero(const Triangles& triangles, Index numberOfVertices,
  const PointView& points = {}, const Run& run = {});

/// Describe a report in sentences for messages. The first sentence describes the mesh. Each other
/// sentence describes one kind of fault.
std::vector<std::string> describe(const GenusZeroReport& report);

/// Throw an exception unless the triangles form a closed surface of genus zero. The triangles must
/// be consistently oriented, and no triangle may repeat a vertex.
/// @throws std::invalid_argument if the surface has faults. The message describes the faults.
void requireGenusZero(const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Compute the volume enclosed by a closed mesh. The volume is positive if the triangles are
/// counter-clockwise seen from outside.
double signedVolume(const PointView& points, const Triangles& triangles);

/// Require that the corners of all triangles are finite.
/// @throws std::invalid_argument otherwise
void requireFiniteTriangles(const Points& points, const Triangles& triangles);

/// Compute the sum of the areas of the triangles.
double surfaceArea(const PointView& points, const Triangles& triangles);

/// Compute the edge length of a closed mesh of equal equilateral triangles.
/// @param[in] area  area of the mesh
double equalEdgeLength(double area, Index numberOfVertices);

/// Weld points of boundary edges: among points with equal coordinates, use only the point with the
/// smallest id. Call this function for triangles from a file that stores three separate points for
/// each triangle. Points that are on no boundary edge are not welded. Closed surfaces that touch
/// each other thus stay separate.
///
/// @param[in,out] triangles  triangles in which the ids of welded points are replaced; no triangle
///   is dropped
/// @return number of points that were replaced
Index mergeCoincidentBoundaryPoints(
  Triangles& triangles, const PointView& points, const GenusZeroReport& report);

/// Drop triangles with a repeated vertex.
/// @return number of triangles dropped
Index dropRepeatedVertices(Triangles& triangles);

/// Reverse triangles until any two neighboring triangles contain their common edge in opposite
/// directions. In each connected set of triangles, the less frequent orientation is reversed. If
/// both orientations are equally frequent, the orientation of the set's first triangle is kept.
/// @pre the surface is orientable; otherwise some edges stay inconsistent
/// @return number of triangles reversed
Index orientConsistently(Triangles& triangles);

/// Renumber the vertices of triangles without gaps. Isolated vertices (vertices of no triangle) get
/// no id. The sequence of the other vertices does not change.
/// @param[in,out] triangles  #F by 3 ids in [0, numberOfVertices); on return, new ids
/// @return old id of each remaining vertex, indexed by its new id
std::vector<int> dropIsolatedPoints(Triangles& triangles, Index numberOfVertices);
}

#endif
