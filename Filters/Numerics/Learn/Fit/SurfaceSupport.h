/// Find the unsupported area of a learned surface, which is far from all samples. Own construction:
/// samples per area are counted, because the mismatch error of \cite Liou2008 does not detect
/// unsupported area.

#ifndef ConformalSurfaceSupport_h
#define ConformalSurfaceSupport_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Find unsupported vertices: those on webs (spurious membranes) between limbs, and on fillings of
/// holes in the data. The mismatch error E_mis of \cite Liou2008 does not detect them.
///
/// The number of patterns around a vertex is compared with the number expected for an area of that
/// size. The neighborhood of the vertex is enlarged until about a hundred patterns are expected. A
/// vertex is unsupported if its neighborhood has less than a quarter of the expected patterns.
///
/// @param[in] positions  #V by 3
/// @param[in] triangles  #F by 3
/// @param[in] neighbors  vertexNeighbors() of the triangles
/// @param[in] masses     #F, number of patterns with foot points in each triangle
/// @return #V, true for unsupported vertices
std::vector<bool> unsupportedVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses);

/// Find vertices without samples. A vertex counts as without samples if its triangles have less
/// than a twentieth of the number of patterns that a vertex's triangles have on average.
std::vector<bool> idleVertices(
  const Triangles& triangles, const std::vector<double>& masses, Index numberOfVertices);

/// Find unsupported vertices, and all vertices without samples that are connected to them. The
/// result covers a whole web, while unsupportedVertices() covers the center of the web. Parameters
/// are those of unsupportedVertices().
std::vector<bool> bareVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses);

/// Select the marked vertices that are far from patterns. Such a vertex is at least twice as far
/// from its nearest pattern as this pattern is from its own sixth neighbor. Vertices in sparse but
/// evenly sampled regions, such as between scan lines, are not selected.
/// @param[in] marked    #V
/// @param[in] patterns  all patterns, or an unbiased selection of them; not empty
std::vector<bool> farFromPatterns(
  const Points& positions, const std::vector<bool>& marked, const Points& patterns);

/// Compute the fraction of the surface area at marked vertices, in [0, 1]. Each triangle
/// contributes a third of its area to each corner.
double areaFraction(
  const Points& positions, const Triangles& triangles, const std::vector<bool>& vertices);

/// Compute the unsupported area as a fraction of the surface area. It consists of the vertices that
/// farFromPatterns() selects from bareVertices(). All ranks return the same value.
/// @param[in] masses  #F, number of patterns with foot points in each triangle
double unsupportedFraction(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const std::vector<double>& masses);

/// Compute the support of each vertex by nearby patterns. The support is 1 if the nearest pattern
/// is closer than twice the local spacing of patterns, and 0 beyond four times this spacing. It
/// changes smoothly in between, and is then smoothed over the mesh. Between scan lines, the local
/// spacing is that of the lines. All ranks return the same values.
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @return #V values in [0, 1]
/// @throws Aborted
std::vector<double> supportOfVertices(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const Run& run = {});

/// Compute the fraction of triangles with an angle above 90 degrees. A large fraction indicates
/// that a mesh of nearly equilateral triangles was stretched over limbs and edges.
double obtuseFraction(const Points& positions, const Triangles& triangles);
}

#endif
