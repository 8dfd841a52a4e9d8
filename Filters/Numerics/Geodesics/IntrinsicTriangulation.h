/// Triangulate a surface by its vertices and geodesic edges, \cite Fisher2007. Equations on such a
/// triangulation do not suffer from thin triangles of the mesh.

#ifndef ConformalIntrinsicTriangulation_h
#define ConformalIntrinsicTriangulation_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Triangulation of a surface, whose edges are shortest lines on the surface that are known by
/// their lengths only. Two vertices can share several edges, and a triangle can have a vertex
/// twice.
struct IntrinsicTriangulation
{
  conformal::Triangles Triangles; ///< #F by 3 ids of vertices
  Points Lengths;   ///< #F by 3; column k is the length of the edge from corner k to corner k + 1
  Points Positions; ///< of the vertices: those of the mesh, and then those that were added
  std::vector<int> Parts; ///< connected part of each vertex: the smallest id of the part's vertices
};

/// Sides of the triangles of each connected part. Sums belong to the first vertex of the part.
struct SidesOfParts
{
  std::vector<double> Lengths, Counts; ///< #V, total length and number of the sides
};

/// Sum the sides of the triangles of each connected part.
SidesOfParts sidesOfParts(const IntrinsicTriangulation& surface);

/// Return the intrinsic Delaunay triangulation of a mesh: both angles opposite an edge have a sum
/// of at most pi, so that cotangent weights are not negative, \cite Bobenko2007. Edges are flipped
/// within the surface until all have this property, \cite Fisher2007.
///
/// Edges of one triangle, of more than two, and edges between triangles of opposite orientation are
/// not flipped. If their cotangent weight is negative, vertices are added to them, as for segments
/// in \cite Ruppert1995, but at the foot of the opposite vertex, and no more vertices than the mesh
/// has. All edges of a connected part are lengthened by the same small amount if some of its
/// triangles has no area, \cite Sharp2020.
/// @param[in] mesh  any triangles; no triangle repeats a vertex
/// @throws Aborted
IntrinsicTriangulation intrinsicDelaunay(const Mesh& mesh, const Run& run = {});

/// Cotangents of the angles at the corners of a triangle with edges of given lengths.
/// @param[in] lengths  length of the edge from corner k to corner k + 1
Vector3 cotangentsOf(const Vector3& lengths);

/// Compute the area of a triangle from the lengths of its edges.
double areaOf(const Vector3& lengths);
}

#endif
