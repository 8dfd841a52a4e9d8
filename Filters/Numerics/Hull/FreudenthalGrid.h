/// Grid of cubes with the triangulation of \cite Freudenthal1942. Sets of its nodes have an
/// unambiguous topology.

#ifndef ConformalFreudenthalGrid_h
#define ConformalFreudenthalGrid_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace conformal
{
/// Grid of cubes with its Freudenthal triangulation.
///
/// Each cube of the grid is divided into six tetrahedra. The corners of a tetrahedron are the nodes
/// of a path along edges of the cube, from its lowest to its highest corner. The bits of the number
/// s of a corner, s in [0, 8), are its offsets from the lowest corner along the three axes. Two
/// nodes share an edge if one is a corner of the cube whose lowest corner is the other.
///
/// A set of nodes represents all simplices whose nodes are in the set. The topology of a set and
/// that of its complement are dual to each other. Both are defined by the same 14 neighbors of each
/// node.
struct FreudenthalGrid
{
  Vector3 Origin = Vector3::Zero();
  double Spacing = 1.0;
  std::array<int, 3> Size = { 0, 0, 0 };

  Index numberOfNodes() const
  {
    return static_cast<Index>(this->Size[0]) * this->Size[1] * this->Size[2];
  }
  int node(int x, int y, int z) const { return x + this->Size[0] * (y + this->Size[1] * z); }
  Vector3 position(int node) const
  {
    return this->Origin + this->Spacing * this->coordinates(node).cast<double>();
  }
  Eigen::Vector3i coordinates(int node) const
  {
    const int row = node / this->Size[0];
    return { node % this->Size[0], row % this->Size[1], row / this->Size[1] };
  }
  /// Convert spatial coordinates to grid coordinates. Nodes have integer grid coordinates.
  Vector3 toGrid(const Vector3& x) const { return (x - this->Origin) / this->Spacing; }

  /// Return the differences in node id from the lowest corner of a cube to its corners 0 to 7.
  std::array<int, 8> cornerSteps() const;
  /// Return the differences in node id to the 14 neighbors of a node. Neighbors 0 to 6 are corners
  /// 1 to 7 of the cube whose lowest corner is the node. Neighbors 7 to 13 are the nodes of whose
  /// cubes the node is corner 1 to 7.
  std::array<int, 14> neighborSteps() const;
};

/// Call body(first, last) for every row of nodes, without the nodes on the faces of the grid. The
/// row consists of nodes first to last - 1, and each of them has all 14 neighbors.
void forInnerRows(const FreudenthalGrid& grid, const Run& run,
  const std::function<void(int first, int last)>& body);

/// Replace the mark of a node, and of all nodes connected to it by nodes with the same mark.
///
/// @param[in,out] marks  mark of each node; marks on the faces of the grid must differ from the
///   mark of `start`
/// @param[in] mark       new mark, different from the old mark
/// @param[out] reached   nodes with the new mark, beginning with `start`
void markPiece(const FreudenthalGrid& grid, std::vector<std::uint8_t>& marks, int start,
  std::uint8_t mark, std::vector<int>& reached, const Run& run = {});

/// Compute the Euler number (vertices - edges + triangles - tetrahedra) of a set of nodes.
/// @param[in] inside  1 for the nodes of the set, else 0; 0 on the faces of the grid
Index eulerNumber(
  const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside, const Run& run = {});

/// Compute the part of the Euler number due to simplices that contain at least one of the given
/// nodes. If only the given nodes join or leave the set, the Euler number changes by as much as
/// this part.
/// @param[in] nodes  given nodes, none of them on the faces of the grid
Index eulerNumberAround(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<int>& nodes);

/// Return whether a node can join or leave a set without changing the topology of the set or of its
/// complement. This requires that the neighbors inside the set are connected, and that the
/// neighbors outside of it are connected.
///
/// @param[in] neighbors  bit i is 1 if neighbor i of neighborSteps() is in the set
bool isSimpleNode(unsigned int neighbors);
}

#endif
