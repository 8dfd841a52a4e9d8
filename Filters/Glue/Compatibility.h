// Wrap VTK functions that differ between versions of VTK.
#ifndef GlueCompatibility_h
#define GlueCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkIdList.h"
#include "vtkPolygon.h"
#include "vtkVersionMacros.h"

namespace glue
{
/// Return whether an algorithm must abort. The algorithm must abort if its flag AbortExecute is
/// set. Since VTK 9.3, two rules are added:
/// - The algorithm must also abort if AbortExecute of an upstream algorithm is set.
/// - If the algorithm must abort, this function marks the outputs as aborted.
inline bool IsAbortWanted(vtkAlgorithm* self)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111) // VTK of ParaView 5.11, before VTK 9.3
  return self->CheckAbort();
#else
  return self->GetAbortExecute() != 0;
#endif
}

/// Triangulate a polygon. In the result, each triangle consists of three indices into the polygon's
/// list of points. Return 0 on failure.
inline int Triangulate(vtkPolygon* polygon, vtkIdList* triangles)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617) // VTK of ParaView 5.13, before VTK 9.4
  return polygon->TriangulateLocalIds(0, triangles);
#else
  return polygon->Triangulate(triangles);
#endif
}
}

#endif
