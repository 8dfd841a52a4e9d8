/// Nested dissection: an elimination order for the unknowns of a surface mesh.

#ifndef ConformalNestedDissection_h
#define ConformalNestedDissection_h

#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Unknowns in an order in which each part follows the parts that it keeps apart \cite George1973.
struct NestedDissection
{
  struct Part
  {
    int Begin, End;            ///< of Order
    int Level;                 ///< 0 for the last one, one more for the parts it keeps apart
    std::vector<int> Children; ///< the parts that it keeps apart, none or two
  };
  std::vector<int> Order;     ///< the unknown at each place
  std::vector<int> Positions; ///< the place of each unknown
  std::vector<Part> Parts;    ///< children first
};

/// Cut in halves by the median of the longest side of the bounding box, again and again; a half's
/// points with neighbors in the other one are what keeps both apart.
/// @param[in] graph   symmetric, without loops
/// @param[in] places  a point for each unknown
NestedDissection dissect(const Adjacency& graph, const Points& places);
}

#endif
