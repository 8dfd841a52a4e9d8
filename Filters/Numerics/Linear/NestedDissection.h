/// Nested dissection: an elimination order for the unknowns of a surface mesh, \cite George1973.

#ifndef ConformalNestedDissection_h
#define ConformalNestedDissection_h

#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Elimination order in which each part, a separator, follows the parts it separates \cite
/// George1973.
struct NestedDissection
{
  struct Part
  {
    int Begin, End;            ///< range of positions in Order
    int Level;                 ///< 0 for the last part, one more for the parts it separates
    std::vector<int> Children; ///< the parts it separates, none or two
  };
  std::vector<int> Order;     ///< unknown at each position
  std::vector<int> Positions; ///< position of each unknown
  std::vector<Part> Parts;    ///< each after its children
};

/// Bisect the unknowns recursively by the median along the longest side of the bounding box. The
/// separator is the set of unknowns of one half with neighbors in the other.
/// @param[in] graph   symmetric, without loops
/// @param[in] places  a point for each unknown
NestedDissection dissect(const Adjacency& graph, const Points& places);
}

#endif
