// What differs between versions of VTK.
#ifndef GlueCompatibility_h
#define GlueCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkIdList.h"
#include "vtkPolygon.h"
#include "vtkVersionMacros.h"

namespace glue
{
/// Somebody wants the algorithm to stop: its AbortExecute is set, or since VTK 9.3 that of one it
/// reads from. The pipeline is told then, which marks the outputs as aborted.
inline bool IsAbortWanted(vtkAlgorithm* self)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230111) // what ParaView 5.11 has
  return self->CheckAbort();
#else
  return self->GetAbortExecute() != 0;
#endif
}

/// Cuts a polygon into triangles whose ids count its own points. Returns 0 if it cannot.
inline int Triangulate(vtkPolygon* polygon, vtkIdList* triangles)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617) // what ParaView 5.13 has
  return polygon->TriangulateLocalIds(0, triangles);
#else
  return polygon->Triangulate(triangles);
#endif
}
}

#endif
