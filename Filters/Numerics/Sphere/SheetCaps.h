/// Close a sheet and its map to the sphere by caps, so that algorithms for closed surfaces can be
/// used. A sheet is a connected surface with a border and without handles, see mapSheet(). The caps
/// are our own construction, not from a publication.

#ifndef ConformalSheetCaps_h
#define ConformalSheetCaps_h

#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Sheet with caps. Vertices and triangles of the sheet come first.
struct CappedSheet : MappedMesh
{
  Index NumberOfCapVertices = 0;
  Index NumberOfCapTriangles = 0; ///< 0 for a surface that was closed before
};

/// Close all borders of a mapped sheet. The longest border is closed by triangles around a new
/// vertex, on the sphere opposite to the sheet. The other borders are closed by triangles between
/// their vertices, which do not overlap on the sphere.
/// @param[in] sheet  manifold and consistently oriented, for example with the map of mapSheet(). A
///   closed surface is returned without a change.
CappedSheet withCaps(const MappedMesh& sheet);
}

#endif
