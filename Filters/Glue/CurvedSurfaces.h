/// Build curved seamless surfaces from meshes, for vtkCurvedSeamlessMap and for the filter
/// vtkCurvedSeamlessSurface, which samples the map.
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

/// Properties of vtkCurvedSeamlessSurface that determine the surface, with their defaults.
struct CurvedSeamlessProperties
{
  conformal::CurvedSeamlessSurfaceOptions Options; ///< all options; Options.VertexShift is ignored
  /// Value of the property; negative to use the mesh's field array "VertexShift".
  double VertexShift = -1.0;
};

/// Curved seamless surface, and the coordinate frame of its points.
struct BuiltSurface
{
  conformal::CurvedSeamlessSurface Surface;
  conformal::CoordinateFrame Frame;
};

/// Build the same surface on all ranks, from the mesh of the first rank that has one. `self` issues
/// the warnings.
/// @param[in] cloud  points of this rank's part of the cloud, or null; used only for Fitted domes
/// @throws std::invalid_argument if no rank has a valid surface
/// @throws conformal::Aborted
std::shared_ptr<const BuiltSurface> BuildSurface(const CurvedSeamlessProperties& properties,
  vtkObject* self, vtkPolyData* surface, vtkPointSet* cloud, const conformal::Run& run,
  Processes& processes);
}

#endif
