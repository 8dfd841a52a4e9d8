/// Extract and smooth the surface of a set of grid nodes.

#ifndef ConformalLevelSetSurface_h
#define ConformalLevelSetSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"
#include "Mesh/Mesh.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Extract the surface between a set of nodes and its complement by marching tetrahedra
/// \cite Gueziec2001. An edge of the grid is called cut if one of its nodes is in the set and the
/// other is not. The surface has one vertex on each cut edge. The surface is always closed and
/// manifold. It has the topology of the boundary of the set.
///
/// Each node has a value, for example its distance to a point cloud. Usually, the value is below
/// the level at nodes in the set, and above the level at other nodes. The vertex is then where
/// linear interpolation along the edge reaches the level. Some nodes are exceptions, for example,
/// where a handle of the set was cut or filled. An exception is a node of the set with a value
/// above the level, or another node with a value below the level. On each cut edge of an exception,
/// the vertex is the midpoint of the edge.
///
/// @param[in] inside  1 for the nodes of the set, else 0; must be 0 on the faces of the grid
/// @param[in] values  value of each node
/// @param[in] level  isovalue of the surface
Mesh makeLevelSetSurface(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, double level, const Run& run = {});

/// Smooth a closed surface without shrinkage \cite Taubin1995. Each pass has two steps. The first
/// step moves each vertex halfway to the centroid of its neighbors. The second step moves each
/// vertex away from the centroid of its moved neighbors, by 0.53 times the distance between vertex
/// and centroid. The second step is slightly larger than the first, which compensates the shrinkage
/// of the first step.
void smoothSurface(Points& positions, const Triangles& triangles, int passes, const Run& run = {});
}

#endif
