// Convert vtkPolyData to conformal::Mesh, the triangle mesh of the numerical core
// (Filters/Numerics).
//
// The numerical core computes in a coordinate frame: coordinates are divided by the unit of the
// frame. The unit is a power of two.
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
/// polygons of fewer than three points are skipped. In strips, triangles with a repeated point are
/// also skipped.
/// @param[out] cellIds  for each triangle, the id of the cell from which the triangle was made
/// @throws std::invalid_argument if a cell contains an invalid point id
/// @throws std::length_error if ids exceed the range of int
conformal::Triangles ToTriangles(vtkPolyData* surface, std::vector<vtkIdType>& cellIds);
conformal::Triangles ToTriangles(vtkPolyData* surface);

/// Return whether a surface has polygons or strips. Return false for null.
bool HasTriangles(vtkPolyData* surface);

/// Return whether all cells contain only valid point ids.
bool HasCellIds(vtkPolyData* surface);

/// Return whether two surfaces have equal polygons and strips, by point ids and in equal order.
bool HaveEqualPolygons(vtkPolyData* a, vtkPolyData* b);

/// Which surfaces ToClosedMesh() accepts.
enum class Topology
{
  Closed,        ///< closed surfaces of genus zero
  ClosedOrSheet, ///< also sheets: connected surfaces with borders and without handles
  Mappable       ///< also sheets, and closed surfaces of genus 1
};

/// Closed surface of genus zero, or another surface of a Topology, that satisfies the requirements
/// of the numerical core. Positions are finite, in coordinates of the frame passed to
/// ToClosedMesh(). Each vertex belongs to a triangle. All triangles have three distinct vertices,
/// and consistent orientation.
struct ClosedMesh : conformal::Mesh
{
  /// For each vertex, the id of its point in the source surface, the surface that was converted.
  std::vector<vtkIdType> PointIds;
  /// For each triangle, the id of its cell in the source surface.
  std::vector<vtkIdType> CellIds;
  /// Whether all triangles are clockwise seen from outside, as in the source surface. If true,
  /// Outward() reverses the triangles in its copy.
  bool InsideOut = false;
  int NumberOfBorders = 0; ///< above 0 for a sheet; then InsideOut is false
  int NumberOfHandles = 0; ///< 1 for a surface of genus 1
};

/// Use of a mesh of ToClosedMesh().
enum class MeshUse
{
  Output, ///< the output of the filter has the points and triangles of the mesh
  Copy    ///< the output keeps the points and polygons of the source surface
};

/// Convert a surface to a closed mesh. Defects that can be repaired without loss are repaired. One
/// warning is issued for each kind of repair:
/// - Coincident points of open edges (edges of only one triangle) are merged. In a polygon soup
///   (polygons that share no points), all edges are open.
/// - Triangles with a repeated point are removed.
/// - Triangles are oriented consistently, so that the majority keeps its orientation.
/// - Isolated points are removed.
///
/// @param[in] self   object that issues the warnings
/// @param[in] frame  coordinate frame of the result. The points of the surface must be among the
///   points from which the frame was computed.
/// @param[in] topology  which surfaces are accepted
/// @param[in] use  use of the mesh, for the warnings
/// @throws std::invalid_argument if coordinates are not finite
/// @throws std::invalid_argument if the repaired surface is not accepted, for example open, not
///   manifold, disconnected, or not of genus zero. The message contains the number of defects, such
///   as open edges.
ClosedMesh ToClosedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run = {},
  Topology topology = Topology::Closed, MeshUse use = MeshUse::Output);

/// Return a copy of a closed mesh whose triangles are counter-clockwise seen from outside.
conformal::Mesh Outward(const ClosedMesh& mesh);

/// Set an output to the source surface of a closed mesh. If ToClosedMesh() repaired nothing, the
/// output is a shallow copy of the source surface. Otherwise, the output is the repaired mesh, with
/// the point data of the remaining points, the cell data of the remaining triangles except their
/// active normals, and the field data.
void PassClosedMesh(vtkPolyData* surface, const ClosedMesh& mesh,
  const conformal::CoordinateFrame& frame, vtkPolyData* output);

/// Convert a surface to a mesh whose triangles are counter-clockwise seen from outside. No warnings
/// are issued. The result is empty in three cases: ToClosedMesh() would throw an exception, the
/// surface has isolated points, or a cell contains an invalid point id.
conformal::Mesh ToMeshIfClosed(
  vtkPolyData* surface, const conformal::CoordinateFrame& frame, const conformal::Run& run = {});

/// Copy the triangles, points and sphere positions of a surface to a mesh. Points are converted to
/// a frame. Unlike ToMappedMesh(), this function does not check that the mesh is closed.
/// @throws std::invalid_argument if ToTriangles() or ToSpherePositions() throws this exception
conformal::MappedMesh CopyMapped(vtkPolyData* surface, const conformal::CoordinateFrame& frame);

/// Check a mesh that was copied from a surface.
/// @throws std::invalid_argument if the mesh has no triangles, or a point that is not finite
void RequireFiniteTriangles(const conformal::Mesh& mesh);

/// Like CopyMapped(), but with consistently oriented triangles, on which volume and normals depend.
/// If triangles are reversed, a warning states their number.
conformal::MappedMesh CopyOriented(
  vtkObject* self, vtkPolyData* surface, const conformal::CoordinateFrame& frame);

/// Convert a surface with a map to the sphere to a closed mesh whose triangles are
/// counter-clockwise seen from outside. The map is the point array "SpherePosition".
/// @param[in] self   object that issues warnings
/// @param[in] frame  coordinate frame of the result
/// @throws std::invalid_argument if ToClosedMesh() or ToSpherePositions() throws this exception
conformal::MappedMesh ToMappedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run = {});
}

#endif
