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
/// \cite Gueziec2001. The surface has one vertex on each edge that joins a node of the set to a
/// node outside of it. The surface is always closed and manifold, and has the topology of the set's
/// boundary.
///
/// If the values rise through the level from the inside node to the outside node, the vertex lies
/// where linear interpolation reaches the level. Otherwise, for example at a cut, the vertex is the
/// midpoint of its edge.
///
/// @param[in] inside  1 for the nodes of the set, else 0; 0 on the faces of the grid
/// @param[in] values  value of each node
Mesh makeLevelSetSurface(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, double level, const Run& run = {});

/// Smooth a closed surface without shrinkage \cite Taubin1995. Each pass moves vertices toward the
/// centroid of their neighbors, and then slightly farther in the opposite direction.
void smoothSurface(Points& positions, const Triangles& triangles, int passes, const Run& run = {});
}

#endif
