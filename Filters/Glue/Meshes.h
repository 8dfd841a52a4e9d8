// Convert vtkPolyData to conformal::Mesh, the triangle mesh of the numerical core
// (Filters/Numerics).
#ifndef GlueMeshes_h
#define GlueMeshes_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Types.h"           // for Points, Triangles
#include "Mesh/Mesh.h"            // for MappedMesh

#include "vtkType.h" // for vtkIdType

#include <vector> // for maps of ids

class vtkObject;
class vtkPolyData;

namespace glue
{
/// Return the triangles of a surface. Polygons and strips are triangulated. Lines, vertices and
/// polygons of fewer than three points are skipped. Triangles of strips with repeated points, which
/// join strips, are skipped, too.
/// @param[out] cellIds  source cell of each triangle
/// @throws std::invalid_argument if a cell contains an invalid point id
/// @throws std::length_error if ids exceed the range of int
conformal::Triangles ToTriangles(vtkPolyData* surface, std::vector<vtkIdType>& cellIds);
conformal::Triangles ToTriangles(vtkPolyData* surface);

/// Return whether a surface has polygons or strips; false for null.
bool HasTriangles(vtkPolyData* surface);

/// Return whether all cells contain valid point ids only.
bool HasCellIds(vtkPolyData* surface);

/// Closed surface of genus zero, valid for the numerical core. Positions are finite, in coordinates
/// of the frame given to ToClosedMesh(). Each vertex belongs to a triangle. Triangles have three
/// distinct vertices and consistent orientation.
struct ClosedMesh : conformal::Mesh
{
  std::vector<vtkIdType> PointIds; ///< point of the source surface for each vertex
  /// Whether triangles are clockwise seen from outside. They are stored like that; Outward()
  /// reverses them.
  bool InsideOut = false;
};

/// Convert a surface to a closed mesh. Defects that can be repaired without loss are repaired.
/// `self` issues one warning for each kind of repair:
/// - Coincident points of open edges (polygon soups) are merged.
/// - Triangles with a repeated point are removed.
/// - Triangles are oriented consistently with the majority.
/// - Isolated points are removed.
///
/// @param[in] frame  coordinate frame of the result, computed from the surface or from it and other
///   data
/// @throws std::invalid_argument if coordinates are not finite, or if the surface is open, not
///   manifold, disconnected, or not of genus zero; the message contains the number of defects
ClosedMesh ToClosedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run = {});

/// Return a closed mesh as a mesh whose triangles are counter-clockwise seen from outside.
conformal::Mesh Outward(const ClosedMesh& mesh);

/// Set the output to the source surface of a closed mesh. If the surface was repaired, set the
/// output to the repaired mesh instead, with the point data of the remaining points.
void PassClosedMesh(vtkPolyData* surface, const ClosedMesh& mesh,
  const conformal::CoordinateFrame& frame, vtkPolyData* output);

/// Return a surface as a mesh, counter-clockwise seen from outside. If ToClosedMesh() would throw,
/// or if the surface has isolated points or invalid point ids, return an empty mesh. No warnings
/// are issued.
conformal::Mesh ToMeshIfClosed(
  vtkPolyData* surface, const conformal::CoordinateFrame& frame, const conformal::Run& run = {});

/// Copy a surface's triangles, its points converted to a frame, and its map to the sphere. The mesh
/// is not checked.
/// @throws std::invalid_argument if ToTriangles() or ToSpherePositions() throws it
conformal::MappedMesh CopyMapped(vtkPolyData* surface, const conformal::CoordinateFrame& frame);

/// Convert a surface to a closed mesh, counter-clockwise seen from outside, with the map to the
/// sphere in its point array "SpherePosition".
/// @param[in] frame  coordinate frame of the result
/// @throws std::invalid_argument if ToClosedMesh() or ToSpherePositions() throws it
conformal::MappedMesh ToMappedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run = {});
}

#endif
