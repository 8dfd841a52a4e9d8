/// Nested dissection: an elimination order for the unknowns of a surface mesh, \cite George1973.

#ifndef ConformalNestedDissection_h
#define ConformalNestedDissection_h

#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Elimination order of unknowns, divided into parts, \cite George1973. Each part is a separator:
/// it separates two other parts, and follows them in the order. Some parts separate nothing.
struct NestedDissection
{
  struct Part
  {
    int Begin, End; ///< range of positions in Order
    int Level; ///< 0 for the last part; one more than the level of the separator for other parts
    std::vector<int> Children; ///< the two parts that this part separates, or none
  };
  std::vector<int> Order;     ///< unknown at each position of the order
  std::vector<int> Positions; ///< position of each unknown in the order
  std::vector<Part> Parts;    ///< parts; each comes after its children
};

/// Compute an elimination order by recursive bisection. The unknowns are divided at the median
/// along the longest side of their bounding box. The separator consists of the unknowns in one half
/// that have neighbors in the other half. It is one unknown if there are none, as between pieces
/// that are not connected.
/// @param[in] graph   neighbors of each unknown; symmetric, without loops
/// @param[in] places  one position for each unknown
NestedDissection dissect(const Adjacency& graph, const Points& places);
}

#endif
