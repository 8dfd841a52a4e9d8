/// Cut a sheet out of a closed mesh along border curves. The cut is our own construction, not from
/// a publication.

#ifndef ConformalSheetCut_h
#define ConformalSheetCut_h

#include "Border/BorderCurve.h"

#include <vector>

namespace conformal
{
/// Vertex of a sheet: a vertex of the closed mesh, or a vertex on one of its edges.
struct CutVertex
{
  int First = -1, Second = -1; ///< ends of the edge; equal for a vertex of the mesh
  double Weight = 0.0;         ///< weight of the second end; the first has 1 - Weight
};

/// Sheet that was cut out of a closed mesh.
struct CutSheet : Mesh
{
  std::vector<CutVertex> Vertices; ///< #V, for the interpolation of vertex values
  double DroppedFraction = 0.0;    ///< area of separate parts that were dropped, of the whole area
};

/// Cut a closed mesh along border curves, and keep the largest connected part. Triangles crossed by
/// a curve are split. To avoid thin triangles, vertices near a curve are moved to it.
///
/// @param[in] surface  surface on which the curves were fitted; its mesh is cut
/// @param[in] open     #V, 1 for vertices beyond the borders before they were fitted
/// @param[in] borders  result of fitBorders()
/// @return sheet; without triangles if the curves cut no manifold sheet without handles
CutSheet cutSheet(const BorderSurface& surface, const std::vector<char>& open,
  const std::vector<BorderCurve>& borders);
}

#endif
