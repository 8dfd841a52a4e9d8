/// Find the unsupported area of a learned surface: the area that is far from all samples. Samples
/// are called patterns, as in \cite Liou2008. Each pattern is projected to its closest point on the
/// surface.
///
/// Own construction, not from a publication: patterns per area are counted. The mismatch error
/// E_mis of \cite Liou2008 does not detect unsupported area. E_mis is measured from the patterns to
/// the surface, but not from the surface to the patterns.

#ifndef ConformalSurfaceSupport_h
#define ConformalSurfaceSupport_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Find unsupported vertices. Unsupported vertices are on webs (spurious membranes) between limbs
/// (thin parts), or on fillings of holes in the data.
///
/// The number of patterns in a neighborhood of each vertex is compared with an expected number. If
/// patterns were spread evenly over the surface, the neighborhood would contain the expected
/// number. The neighborhood of the vertex is enlarged until the expected number is about a hundred.
/// If the neighborhood contains less than a quarter of the expected number, the vertex is
/// unsupported.
///
/// @param[in] positions  #V by 3
/// @param[in] triangles  #F by 3
/// @param[in] neighbors  adjacent vertices of each vertex: the result of vertexNeighbors()
/// @param[in] masses     #F, total weight of the patterns projected to each triangle
/// @return #V, true for unsupported vertices
std::vector<bool> unsupportedVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses);

/// Find vertices without patterns. Let m be the total weight of patterns in the triangles around a
/// vertex. A vertex is without patterns if m is less than 5 percent of the mean of m over all
/// vertices.
/// @param[in] masses  #F, total weight of the patterns projected to each triangle
/// @return #V, true for vertices without patterns
std::vector<bool> idleVertices(
  const Triangles& triangles, const std::vector<double>& masses, Index numberOfVertices);

/// Find unsupported vertices, and all vertices without patterns (idleVertices()) that are connected
/// to unsupported vertices. On a web, unsupportedVertices() finds only the center. This function
/// finds the whole web. For the parameters, see unsupportedVertices().
std::vector<bool> bareVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses);

/// Select those of the marked vertices that are far from patterns. Let x be the pattern nearest to
/// a vertex. Let h be the distance from x to the sixth nearest neighbor of x. The vertex is far
/// from patterns if its distance to x is above 2 h. Vertices between evenly spaced rows of
/// patterns, such as scan lines, are not selected.
/// @param[in] marked    #V, true for vertices to test
/// @param[in] patterns  all patterns, or an unbiased selection of them; not empty
/// @return #V, true for selected vertices
std::vector<bool> farFromPatterns(
  const Points& positions, const std::vector<bool>& marked, const Points& patterns);

/// Compute the fraction of the surface area at marked vertices, in [0, 1]. Each triangle
/// contributes a third of its area to each of its corners.
/// @param[in] vertices  #V, true for marked vertices
double areaFraction(
  const Points& positions, const Triangles& triangles, const std::vector<bool>& vertices);

/// Compute the unsupported area as a fraction of the surface area. To find the unsupported area,
/// vertices are marked by bareVertices(), and selected by farFromPatterns(). All ranks (processes)
/// return the same value.
/// @param[in] masses  #F, total weight of the patterns projected to each triangle
double unsupportedFraction(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const std::vector<double>& masses);

/// Compute the fraction of triangles with an angle above 90 degrees. If learning began with nearly
/// equilateral triangles, a large fraction indicates that the mesh was stretched over limbs or
/// edges.
double obtuseFraction(const Points& positions, const Triangles& triangles);
}

#endif
