/// Find unsupported area of a learned surface, far from all samples.
/// Own construction: the mismatch error does not detect unsupported area.

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
/// holes in the data. The mismatch error E_mis does not detect them.
///
/// The number of patterns around a vertex is compared with the number expected for the area. The
/// neighborhood grows until about a hundred patterns are expected. A vertex is unsupported if it
/// has less than a quarter of those.
///
/// @param[in] positions  #V by 3
/// @param[in] triangles  #F by 3
/// @param[in] neighbors  vertexNeighbors() of the triangles
/// @param[in] masses     #F, number of patterns with foot points in each triangle
/// @return #V
std::vector<bool> unsupportedVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses);

/// Find vertices without samples: those whose triangles have less than a twentieth of the mean
/// number of patterns per vertex.
std::vector<bool> idleVertices(
  const Triangles& triangles, const std::vector<double>& masses, Index numberOfVertices);

/// Find unsupported vertices, and vertices without samples that connect them to the border of the
/// data. Together they cover a whole web, whereas unsupportedVertices() covers its center.
/// Parameters are those of unsupportedVertices().
std::vector<bool> bareVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses);

/// Select marked vertices that are far from patterns: at least twice as far from the nearest
/// pattern as that is from its sixth neighbor. Vertices in sparse but evenly sampled regions, such
/// as between scan lines, are not selected.
/// @param[in] marked    #V
/// @param[in] patterns  all patterns, or an unbiased selection; not empty
std::vector<bool> farFromPatterns(
  const Points& positions, const std::vector<bool>& marked, const Points& patterns);

/// Compute the fraction of the surface area at marked vertices, in [0, 1]. Each triangle
/// contributes a third of its area to each corner.
double areaFraction(
  const Points& positions, const Triangles& triangles, const std::vector<bool>& vertices);

/// Compute the fraction of unsupported area: vertices in bareVertices() and farFromPatterns(). All
/// ranks return the same value.
/// @param[in] masses  as for unsupportedVertices()
double unsupportedFraction(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const std::vector<double>& masses);

/// Compute the support of each vertex by nearby patterns. The support is 1 if the nearest pattern
/// is closer than twice the local spacing, and 0 beyond four times. It is smooth in between, and
/// smoothed over the mesh. The spacing includes that across scan lines. All ranks return the same
/// values.
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @return #V values in [0, 1]
/// @throws Aborted
std::vector<double> supportOfVertices(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const Run& run = {});

/// Compute the fraction of triangles with an angle above 90 degrees. It indicates that a mesh of
/// nearly equilateral triangles was stretched over limbs and edges.
double obtuseFraction(const Points& positions, const Triangles& triangles);
}

#endif
