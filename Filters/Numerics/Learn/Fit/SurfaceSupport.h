/// Finds the parts of a learned surface that no samples support.
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
/// Vertices that have next to no patterns near where their share of them would be due: on webs
/// between limbs, and on lids over holes in the data. E_mis cannot see them.
///
/// Patterns and areas are gathered from around each vertex, as far as it takes to expect about
/// a hundred patterns; a vertex is unsupported if there are less than a quarter of those expected.
///
/// @param[in] positions  #V by 3
/// @param[in] triangles      #F by 3
/// @param[in] neighbors  vertexNeighbors of the triangles
/// @param[in] masses     #F, the patterns that have their foot points in each triangle
/// @return #V
std::vector<bool> unsupportedVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses);

/// Vertices around which lie less than a twentieth of the patterns due to a vertex.
std::vector<bool> idleVertices(
  const Triangles& triangles, const std::vector<double>& masses, Index numberOfVertices);

/// Unsupported vertices, and the idle ones that reach from them to the rim of the data: all of a
/// web, where the unsupported ones are its middle. Parameters as above.
std::vector<bool> bareVertices(const Points& positions, const Triangles& triangles,
  const Adjacency& neighbors, const std::vector<double>& masses);

/// Of the vertices marked, those twice as far from the nearest pattern as its sixth neighbor is
/// from that: where patterns are only sparser than elsewhere, the surface has them all the same.
/// So it has between rows of patterns, such as scan lines, that are far apart but evenly so.
/// @param[in] marked    #V
/// @param[in] patterns  all of them, or a fair selection; not empty
std::vector<bool> farFromPatterns(
  const Points& positions, const std::vector<bool>& marked, const Points& patterns);

/// Share of such vertices in the surface's area, a third of each triangle's going to each corner;
/// in [0, 1].
double areaFraction(
  const Points& positions, const Triangles& triangles, const std::vector<bool>& vertices);

/// Share of the area that has no patterns where some are due: bareVertices() that are
/// farFromPatterns(). The same on all processes.
/// @param[in] masses  as of unsupportedVertices()
double unsupportedFraction(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const std::vector<double>& masses);

/// How far each vertex has patterns nearby: 1 where the nearest lies no farther than twice the
/// spacing of those around it, 0 where it lies farther than four times, smooth between and over the
/// mesh. The spacing is that across scan lines too. The same on all processes.
/// @param[in] positions  #V by 3, in the samples' unit
/// @param[in] triangles  #F by 3
/// @return #V values in [0, 1]
/// @throws Aborted
std::vector<double> supportOfVertices(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const Run& run = {});

/// Share of the triangles that have an angle of more than a right one: a lattice of nearly
/// equilateral triangles that has been stretched over limbs and edges shows in it.
double obtuseFraction(const Points& positions, const Triangles& triangles);
}

#endif
