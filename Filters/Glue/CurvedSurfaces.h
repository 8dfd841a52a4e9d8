/// Curved seamless surfaces of meshes, shared by the map and by the filter that samples it.
#ifndef GlueCurvedSurfaces_h
#define GlueCurvedSurfaces_h

#include "Base/CoordinateFrame.h"          // for CoordinateFrame
#include "Surface/CurvedSeamlessSurface.h" // for the surface and its options

#include <memory> // for std::shared_ptr

class vtkObject;
class vtkPointSet;
class vtkPolyData;

namespace glue
{
class Processes;

/// Properties of vtkCurvedSeamlessSurface that determine the map, with their defaults.
struct CurvedSeamlessProperties
{
  conformal::CurvedSeamlessSurfaceOptions Options; ///< all but VertexShift
  double VertexShift = -1.0;                       ///< vtkCurvedSeamlessSurface::GetVertexShift()
};

/// Curved seamless surface, and the frame of its points.
struct BuiltSurface
{
  conformal::CurvedSeamlessSurface Surface;
  conformal::CoordinateFrame Frame;
};

/// Build the surface of the first rank that has a mesh, on all ranks. Warnings are reported by
/// `self`.
/// @param[in] cloud  of this rank, for Fitted domes only
/// @throws std::invalid_argument if no rank has a valid surface
/// @throws conformal::Aborted
std::shared_ptr<const BuiltSurface> BuildSurface(const CurvedSeamlessProperties& properties,
  vtkObject* self, vtkPolyData* surface, vtkPointSet* cloud, const conformal::Run& run,
  Processes& processes);
}

#endif
