/// Divide the cubes of a grid into tetrahedra by the triangulation of \cite Freudenthal1942. The
/// connected components and handles of every set of grid nodes are then unambiguous.

#ifndef ConformalFreudenthalGrid_h
#define ConformalFreudenthalGrid_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace conformal
{
/// Represent a grid of cubes with its Freudenthal triangulation.
///
/// Each cube of the grid is divided into six tetrahedra. The corners of a tetrahedron are the nodes
/// of a path along three edges of the cube. The path leads from the lowest corner of the cube
/// (lowest x, y and z) to the highest corner.
///
/// The corners of a cube are numbered 0 to 7. Bits 0, 1 and 2 of the number are the offsets from
/// the lowest corner along x, y and z. The lowest corner of a cube is joined by an edge to each
/// other corner of the cube. Each node therefore has 14 neighbors. Seven neighbors are the other
/// corners of the cube whose lowest corner is the node. The other seven are in the opposite
/// directions.
///
/// A set of nodes represents all simplices (nodes, edges, triangles and tetrahedra) whose nodes are
/// in the set. The topology of the complement follows from the topology of the set. For example, a
/// cavity of the set is a connected component of the complement. The same 14 neighbors are used for
/// connectivity in the set and in the complement.
struct FreudenthalGrid
{
  Vector3 Origin = Vector3::Zero();      ///< position of node 0
  double Spacing = 1.0;                  ///< side of a cube
  std::array<int, 3> Size = { 0, 0, 0 }; ///< number of nodes along x, y and z

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

  /// Return the differences in node id between the corners 0 to 7 of a cube and its lowest corner.
  std::array<int, 8> cornerSteps() const;
  /// Return the differences in node id between the 14 neighbors of a node and the node. Neighbors 0
  /// to 6 are corners 1 to 7 of the cube whose lowest corner is the node. Neighbors 7 to 13 are in
  /// the directions opposite to neighbors 0 to 6.
  std::array<int, 14> neighborSteps() const;
};

/// Call body(node) for every node within a distance of a position. Nodes in the outer layers of the
/// grid are skipped.
/// @param[in] x  position, in grid coordinates
/// @param[in] distance  maximum distance, in units of the grid spacing
/// @param[in] layers  number of outer layers to skip
template <typename Body>
void forNodesNear(
  const FreudenthalGrid& grid, const Vector3& x, double distance, int layers, const Body& body)
{
  const Eigen::Map<const Eigen::Vector3i> size(grid.Size.data());
  const Eigen::Vector3i low = (x.array() - distance).ceil().cast<int>().max(layers);
  const Eigen::Vector3i high =
    (x.array() + distance).floor().cast<int>().min(size.array() - 1 - layers);
  Eigen::Vector3i at;
  for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
  {
    for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
    {
      for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
      {
        if ((at.cast<double>() - x).squaredNorm() <= distance * distance)
        {
          body(grid.node(at[0], at[1], at[2]));
        }
      }
    }
  }
}

/// Call body(first, last) for every row of nodes along x, without nodes on the faces of the grid.
/// The row consists of the nodes first to last - 1. Each node of the row has all 14 neighbors.
void forInnerRows(const FreudenthalGrid& grid, const Run& run,
  const std::function<void(int first, int last)>& body);

/// Replace the mark of a connected component of nodes. The component consists of `start` and all
/// nodes that are connected to it by nodes with the same mark.
///
/// @param[in,out] marks  mark of each node; marks on the faces of the grid must differ from the
///   mark of `start`
/// @param[in] mark  new mark, different from the old mark
/// @param[out] reached  nodes with the new mark, beginning with `start`
void markPiece(const FreudenthalGrid& grid, std::vector<std::uint8_t>& marks, int start,
  std::uint8_t mark, std::vector<int>& reached, const Run& run = {});

/// Compute the Euler number (vertices - edges + triangles - tetrahedra) of a set of nodes.
/// @param[in] inside  1 for the nodes of the set, else 0; must be 0 on the faces of the grid
Index eulerNumber(
  const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside, const Run& run = {});

/// Compute the part of the Euler number that is due to simplices with at least one of the given
/// nodes. Use this function before and after some nodes are added to the set or removed from it.
/// The result and the Euler number of the whole set change by the same amount.
/// @param[in] nodes  given nodes, none of which is on the faces of the grid
Index eulerNumberAround(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<int>& nodes);

/// Return whether a node is simple. If a simple node is added to a set, or removed from it, the
/// topology of set and complement is preserved. A node is simple if two conditions hold:
/// - At least one neighbor is in the set, and the neighbors in the set are connected.
/// - At least one neighbor is in the complement, and the neighbors in the complement are connected.
///
/// @param[in] neighbors  bit i is 1 if neighbor i of FreudenthalGrid::neighborSteps() is in the set
bool isSimpleNode(unsigned int neighbors);
}

#endif
