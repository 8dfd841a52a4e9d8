/// Extracts and smooths the surface of a set of grid nodes.

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
/// The surface between a set of nodes and the others, by marching tetrahedra: one vertex on each
/// edge with one node in the set. Always closed and manifold; of the topology of the set.
///
/// A vertex lies where the values pass the level if they rise through it from inside to outside,
/// else, as where the set was cut, in the middle of its edge.
///
/// @param[in] inside  1 for the nodes of the set, else 0; 0 on the grid's faces
/// @param[in] values  of each node
Mesh makeLevelSetSurface(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, double level, const Run& run = {});

/// Smooth a closed surface without shrinking it: each pass moves vertices towards the centroid of
/// their neighbors and back a little farther, \cite Taubin1995.
void smoothSurface(Points& positions, const Triangles& triangles, int passes, const Run& run = {});
}

#endif
