/// Compute an elimination order for sparse linear equations on a mesh by nested dissection,
/// \cite George1973.

#ifndef ConformalNestedDissection_h
#define ConformalNestedDissection_h

#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Elimination order of unknowns (the sequence in which a solver eliminates them), divided into
/// parts, \cite George1973. A set of unknowns is divided recursively into two halves and a
/// separator. The halves are not connected to each other. The separator follows both halves in the
/// elimination order. Each separator is a part. Each small set that is not divided further is also
/// a part, called a leaf. The parts form a tree: the children of a separator are the last parts of
/// its two halves.
struct NestedDissection
{
  struct Part
  {
    int Begin, End; ///< first position of the part in Order, and the position after its last one
    /// Depth in the tree of parts: 0 for the last part; for any other part, the level of its parent
    /// plus 1
    int Level;
    /// Indices in Parts of the children: the last parts of both halves; none for a leaf
    std::vector<int> Children;
  };
  std::vector<int> Order;     ///< unknown at each position of the elimination order
  std::vector<int> Positions; ///< position in Order of each unknown
  std::vector<Part> Parts;    ///< parts in elimination order; children precede their parent
};

/// Axis along which a set of unknowns is divided: the longest side of its bounding box, or the axis
/// with the fewest unknowns in the separator. The second choice has small separators also where
/// triangles of a mesh are long, all in the same direction. It needs about three times as long.
enum class CutAxes
{
  LongestSide,
  FewestUnknowns
};

/// Compute an elimination order by recursive bisection. A set of unknowns is divided at the median
/// position along an axis. The separator consists of all unknowns in
/// one half that have neighbors in the other half. If the halves are not connected to each other,
/// the separator is a single unknown.
/// @param[in] graph   neighbors of each unknown: a symmetric relation; no unknown is its own
///   neighbor
/// @param[in] places  position of each unknown in space
NestedDissection dissect(
  const Adjacency& graph, const Points& places, CutAxes axes = CutAxes::LongestSide);
}

#endif
