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
/// Freudenthal's triangulation of space: each cube of the grid is cut into the six tetrahedra
/// that climb from its lowest corner to its highest, one axis at a time. Corner s of a cube, s in
/// [0, 8), is the lowest corner moved by one along the axes of the bits of s; two nodes share an
/// edge where one is a corner of the other's cube.
///
/// A set of nodes stands for all simplices whose nodes are in it. That set and the one of the
/// other nodes are then dual to each other, with one kind of neighborhood for both.
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
  /// From spatial coordinates to those in which nodes are integers.
  Vector3 toGrid(const Vector3& x) const { return (x - this->Origin) / this->Spacing; }

  /// Added to a node's id, gives that of corner s of the cube above it.
  std::array<int, 8> cornerSteps() const;
  /// Added to a node's id, give those of its 14 neighbors: corners 1 to 7 of the cube above it,
  /// then the nodes of whose cubes it is corner 1 to 7.
  std::array<int, 14> neighborSteps() const;
};

/// Run body(first, last) for the nodes [first, last) of every row, the grid's faces left out:
/// there all 14 neighbors exist.
void forInnerRows(const FreudenthalGrid& grid, const Run& run,
  const std::function<void(int first, int last)>& body);

/// Mark all nodes that hang together with a node and bear the same mark.
///
/// @param[in,out] marks  of each node; those on the grid's faces must differ from that of start
/// @param[in] mark       the new one, other than the old
/// @param[out] reached   the nodes marked, start first
void markPiece(const FreudenthalGrid& grid, std::vector<std::uint8_t>& marks, int start,
  std::uint8_t mark, std::vector<int>& reached, const Run& run = {});

/// Euler number (vertices - edges + triangles - tetrahedra) of a set of nodes.
/// @param[in] inside  1 for the nodes of the set, else 0; 0 on the grid's faces
Index eulerNumber(
  const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside, const Run& run = {});

/// The part in the Euler number of a set of nodes that nodes have in it together with those around
/// them: what a change of these nodes changes in it.
/// @param[in] nodes  none of the grid's faces
Index eulerNumberAround(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<int>& nodes);

/// Whether a node can join or leave a set without changing the topology of either the set or its
/// complement: the node's neighbors in the set hang together, and so do the others.
///
/// @param[in] neighbors  bit i for neighbor i of neighborSteps(): whether it is in the set
bool isSimpleNode(unsigned int neighbors);
}

#endif
