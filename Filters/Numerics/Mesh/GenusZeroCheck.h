/// Checks whether a triangle mesh is a closed surface of genus zero, and lists its faults.
/// Also the repairs that lose nothing: welding, consistent orientation, dropping what is unused.

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

/// What checkGenusZero found. Triangles that name a vertex twice have no place in the topology:
/// they are listed as degenerate and take no part in any other figure.
struct GenusZeroReport
{
  std::vector<Edge> BoundaryEdges;      ///< of one triangle only, in that triangle's direction
  std::vector<Edge> NonManifoldEdges;   ///< of more than two triangles, smaller id first
  std::vector<Edge> InconsistentEdges;  ///< run the same way by both triangles, smaller id first
  std::vector<int> NonManifoldVertices; ///< where several fans of triangles touch
  std::vector<int> DegenerateTriangles; ///< a repeated vertex or no area
  std::vector<int> IsolatedPoints;      ///< of no triangle
  std::vector<int> NonFinitePoints;     ///< a coordinate is NaN or infinite
  Index NumberOfTriangles = 0;          ///< without those of a repeated vertex
  Index NumberOfVertices = 0;           ///< of these triangles
  Index NumberOfEdges = 0;
  Index NumberOfBoundaryLoops = 0; ///< connected sets of boundary edges
  Index NumberOfComponents = 0;    ///< sets of triangles connected by shared vertices
  Index EulerNumber = 0;           ///< vertices - edges + triangles
  bool Orientable = true;
  bool InsideOut = false; ///< consistently oriented and of negative volume

  bool closed() const { return this->NumberOfTriangles > 0 && this->BoundaryEdges.empty(); }
  bool manifold() const
  {
    return this->NonManifoldEdges.empty() && this->NonManifoldVertices.empty();
  }
  /// Closed, manifold, in one piece, Euler number 2: such a surface is a sphere, hence orientable;
  /// whether its triangles agree on an orientation is another question (InconsistentEdges).
  bool isGenusZero() const
  {
    return this->closed() && this->manifold() && this->NumberOfComponents == 1 &&
      this->EulerNumber == 2;
  }
};

/// Topology of a mesh and, where points are given, areas and volume.
///
/// @param[in] triangles         #F by 3 vertex ids
/// @param[in] numberOfVertices  #V, isolated ones included
/// @param[in] points            #V by 3, or empty
/// @throws std::invalid_argument if an id is not in [0, #V)
GenusZeroReport checkGenusZero(const Triangles& triangles, Index numberOfVertices,
  const PointView& points = {}, const Run& run = {});

/// The report in words: one statement of what the mesh is, then one for each fault.
std::vector<std::string> describe(const GenusZeroReport& report);

/// Let only pass what a map to the sphere can be made of: a closed surface of genus zero, its
/// triangles consistently oriented and without repeated vertices.
/// @throws std::invalid_argument with the report in words otherwise
void requireGenusZero(const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Volume enclosed by a closed mesh, positive where triangles are counter-clockwise seen from
/// outside.
double signedVolume(const PointView& points, const Triangles& triangles);

/// Sum of the areas of the triangles.
double surfaceArea(const PointView& points, const Triangles& triangles);

/// Weld an open mesh: points of boundary edges with equal coordinates become the one of smallest
/// id, as polygon soups need it. Points inside the mesh are left alone, since surfaces that only
/// touch must not be glued.
///
/// @param[in,out] triangles  ids are replaced; no triangle is dropped
/// @return the number of points that were replaced
Index mergeCoincidentBoundaryPoints(
  Triangles& triangles, const PointView& points, const GenusZeroReport& report);

/// Drop triangles that name a vertex twice. @return how many
Index dropRepeatedVertices(Triangles& triangles);

/// Turn triangles until neighbors run their common edge in opposite directions. Of each connected
/// set the smaller part is turned (on a tie, the part without its first triangle).
/// @pre orientable; otherwise some edges stay inconsistent
/// @return the number of triangles turned
Index orientConsistently(Triangles& triangles);

/// Renumber the vertices so that none is isolated, keeping their order.
/// @param[in,out] triangles  #F by 3 ids in [0, numberOfVertices)
/// @return for each new id the old one
std::vector<int> dropIsolatedPoints(Triangles& triangles, Index numberOfVertices);
}

#endif
