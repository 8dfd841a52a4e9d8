// Convert vtkPolyData to the triangle meshes of the core.
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
/// Return the triangles of a surface, with polygons and strips triangulated. Lines, vertices,
/// polygons of fewer than three points and triangles with repeated points, which join strips, are
/// skipped.
/// @param[out] cellIds  source cell of each triangle
/// @throws std::invalid_argument if a cell contains an invalid point id
/// @throws std::length_error if ids exceed the range of int
conformal::Triangles ToTriangles(vtkPolyData* surface, std::vector<vtkIdType>& cellIds);
conformal::Triangles ToTriangles(vtkPolyData* surface);

/// Return whether there are polygons or strips; false for null.
bool HasTriangles(vtkPolyData* surface);

/// Return whether all cells contain valid point ids only.
bool HasCellIds(vtkPolyData* surface);

/// Closed surface of genus zero, ready for the core. Positions are finite and in the frame, and
/// each belongs to a triangle. Triangles have three distinct vertices and consistent orientation.
struct ClosedMesh : conformal::Mesh
{
  std::vector<vtkIdType> PointIds; ///< for each vertex, its point in the source surface
  bool InsideOut = false;          ///< clockwise seen from outside; the triangles are not reversed
};

/// Convert a surface to a closed mesh. Lossless repairs are made, each with one warning of the
/// object:
/// - Coincident points of open edges (polygon soups) are merged.
/// - Triangles with a repeated point are removed.
/// - Triangles are oriented consistently with the majority.
/// - Isolated points are removed.
///
/// @param[in] frame  of the surface, possibly with other data
/// @throws std::invalid_argument with counts, if coordinates are not finite or the surface is open,
///   not manifold, disconnected, or of another genus
ClosedMesh ToClosedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run = {});

/// Return the mesh with triangles counter-clockwise seen from outside.
conformal::Mesh Outward(const ClosedMesh& mesh);

/// Set the output to the source surface of a closed mesh. If the surface was repaired, set it to
/// the mesh with the data of the remaining points.
void PassClosedMesh(vtkPolyData* surface, const ClosedMesh& mesh,
  const conformal::CoordinateFrame& frame, vtkPolyData* output);

/// Return a surface as a mesh, counter-clockwise seen from outside, if it is closed, valid for
/// ToClosedMesh() and without isolated points. Return an empty mesh otherwise, including for
/// invalid point ids. No warnings are issued.
conformal::Mesh ToMeshIfClosed(
  vtkPolyData* surface, const conformal::CoordinateFrame& frame, const conformal::Run& run = {});

/// Copy the triangles, the points in a frame and the map to the sphere of a surface, unchecked.
/// @throws std::invalid_argument as ToTriangles() and ToSpherePositions() do
conformal::MappedMesh CopyMapped(vtkPolyData* surface, const conformal::CoordinateFrame& frame);

/// Convert a surface to a closed mesh, counter-clockwise seen from outside, with its map to the
/// sphere from the point array "SpherePosition".
/// @param[in] frame  of the result; may differ from that of the surface
/// @throws std::invalid_argument as ToClosedMesh() and ToSpherePositions() do
conformal::MappedMesh ToMappedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run = {});
}

#endif
