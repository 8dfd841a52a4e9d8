/// Curved seamless surfaces of meshes, for the map and for the filter that samples it.
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

/// Properties of vtkCurvedSeamlessSurface that the map depends on, with their defaults.
struct CurvedSeamlessProperties
{
  conformal::CurvedSeamlessSurfaceOptions Options; ///< but VertexShift
  double VertexShift = -1.0;                       ///< vtkCurvedSeamlessSurface::GetVertexShift()
};

/// A surface, and the frame of its points.
struct BuiltSurface
{
  conformal::CurvedSeamlessSurface Surface;
  conformal::CoordinateFrame Frame;
};

/// Build the surface of the first process that has a mesh, on all processes. Warnings are of self.
/// @param[in] cloud  of this process, for Fitted domes only
/// @throws std::invalid_argument if there is no such surface
/// @throws conformal::Aborted
std::shared_ptr<const BuiltSurface> BuildSurface(const CurvedSeamlessProperties& properties,
  vtkObject* self, vtkPolyData* surface, vtkPointSet* cloud, const conformal::Run& run,
  Processes& processes);
}

#endif
