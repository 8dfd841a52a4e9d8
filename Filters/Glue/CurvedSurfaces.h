/// Build a curved seamless surface from a triangle mesh with a map to the sphere. A curved patch,
/// called a dome, replaces each flat triangle of the mesh. Seamless means that there is no gap
/// between neighboring domes. Curved seamless surfaces are used by vtkCurvedSeamlessMap and by the
/// filter vtkCurvedSeamlessSurface.
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

/// Properties of vtkCurvedSeamlessSurface that determine the shape of the surface.
struct CurvedSeamlessProperties
{
  /// Options of the surface. Options.VertexShift is ignored; the member VertexShift is used
  /// instead.
  conformal::CurvedSeamlessSurfaceOptions Options;
  /// Factor of the vertex shift, which moves vertices before domes are built (property
  /// VertexShift). If the value is negative, the mesh's field array "VertexShift" is used instead.
  /// If this array is missing, the factor is 0.
  double VertexShift = -1.0;
};

/// Curved seamless surface, and the coordinate frame of its points. Coordinates in the frame are
/// divided by the unit of the frame.
struct BuiltSurface
{
  conformal::CurvedSeamlessSurface Surface;
  conformal::CoordinateFrame Frame;
};

/// Build the same surface on all ranks (processes), from the mesh of the first rank that has a
/// mesh.
/// @param[in] self     object that issues warnings
/// @param[in] surface  mesh of this rank, possibly empty
/// @param[in] cloud    points on this rank, or null. If the option DomeHeight is Fitted, domes are
///   fitted to the points. Otherwise, the points are not used.
/// @throws std::invalid_argument if no rank has a valid mesh
/// @throws conformal::Aborted
std::shared_ptr<const BuiltSurface> BuildSurface(const CurvedSeamlessProperties& properties,
  vtkObject* self, vtkPolyData* surface, vtkPointSet* cloud, const conformal::Run& run,
  Processes& processes);
}

#endif
