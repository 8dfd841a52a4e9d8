/// Freudenthal triangulation of a cubic grid, on which sets of nodes have an unambiguous topology.
/// Triangulation of \cite Freudenthal1942.

#ifndef ConformalFreudenthalGrid_h
#define ConformalFreudenthalGrid_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace conformal
{
/// Freudenthal triangulation of space.
///
/// Each cube of the grid is divided into six tetrahedra. Each tetrahedron follows a path from the
/// lowest to the highest corner of the cube, one axis at a time. Corner s of a cube, s in [0, 8),
/// is the lowest corner shifted by one along the axes of the bits of s. Two nodes share an edge if
/// one is a corner of the cube above the other.
///
/// A set of nodes represents all simplices whose nodes are in the set. A set and its complement are
/// dual to each other and use the same 14 neighbors.
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
  /// Convert spatial coordinates to grid coordinates, in which nodes are integers.
  Vector3 toGrid(const Vector3& x) const { return (x - this->Origin) / this->Spacing; }

  /// Return the differences in node id from the lowest corner of a cube to its corners 0 to 7.
  std::array<int, 8> cornerSteps() const;
  /// Return the differences in node id to the 14 neighbors of a node. Neighbors 0 to 6 are corners
  /// 1 to 7 of the cube above the node. Neighbors 7 to 13 are the nodes for which it is corner 1 to
  /// 7.
  std::array<int, 14> neighborSteps() const;
};

/// Run body(first, last) for the nodes [first, last) of every row inside the faces of the grid.
/// Each of these nodes has all 14 neighbors.
void forInnerRows(const FreudenthalGrid& grid, const Run& run,
  const std::function<void(int first, int last)>& body);

/// Mark the connected component of a node among the nodes with an equal mark.
///
/// @param[in,out] marks  of each node; marks on the faces of the grid must differ from that of
///   start
/// @param[in] mark       new mark, different from the old one
/// @param[out] reached   marked nodes, start first
void markPiece(const FreudenthalGrid& grid, std::vector<std::uint8_t>& marks, int start,
  std::uint8_t mark, std::vector<int>& reached, const Run& run = {});

/// Compute the Euler number (vertices - edges + triangles - tetrahedra) of a set of nodes.
/// @param[in] inside  1 for the nodes of the set, else 0; 0 on the faces of the grid
Index eulerNumber(
  const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside, const Run& run = {});

/// Compute the contribution to the Euler number of all simplices that contain a given node. If only
/// the given nodes join or leave the set, the Euler number and this contribution change equally.
/// @param[in] nodes  none on the faces of the grid
Index eulerNumberAround(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<int>& nodes);

/// Return whether a node can join or leave a set without changing the topology of the set or of its
/// complement. The neighbors inside the set must be connected, and so must be those outside.
///
/// @param[in] neighbors  bit i is 1 if neighbor i of neighborSteps() is in the set
bool isSimpleNode(unsigned int neighbors);
}

#endif
