// From vtkPolyData to the triangle meshes of the core.
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
/// The triangles of a surface: polygons and strips cut up, lines, vertices and polygons of fewer
/// than three points left out, as are the triangles of a repeated point that join strips.
/// @param[out] cellIds  for each triangle the cell it comes from
/// @throws std::invalid_argument if a cell names a point that is not there
/// @throws std::length_error if ids do not fit into an int
conformal::Triangles ToTriangles(vtkPolyData* surface, std::vector<vtkIdType>& cellIds);
conformal::Triangles ToTriangles(vtkPolyData* surface);

/// Whether there are polygons or strips; false for null.
bool HasTriangles(vtkPolyData* surface);

/// Whether each cell names only points that are there.
bool HasCellIds(vtkPolyData* surface);

/// A closed surface of genus zero, ready for the core: positions are finite and in the frame, each
/// of a triangle; no triangle has a vertex twice, all are consistently oriented.
struct ClosedMesh : conformal::Mesh
{
  std::vector<vtkIdType> PointIds; ///< for each vertex its point in the surface it was made from
  bool InsideOut = false;          ///< clockwise seen from outside; nothing was done about it
};

/// Make a closed mesh of a surface, or say why not. Repairs what can be repaired without a loss,
/// each with one warning of the object: coincident points of open edges are merged (polygon
/// soups), triangles of a repeated point dropped, triangles turned to agree with the most,
/// isolated points dropped.
/// @param[in] frame  of the surface, perhaps with other data
/// @throws std::invalid_argument with the figures, if coordinates are not finite or the surface is
///   open, not manifold, in several pieces, or of another genus
ClosedMesh ToClosedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run = {});

/// The same mesh, counter-clockwise seen from outside.
conformal::Mesh Outward(const ClosedMesh& mesh);

/// Into the output the surface that a closed mesh was made of as it is, or, where it had to be
/// repaired, the mesh with the data of the points that are left.
void PassClosedMesh(vtkPolyData* surface, const ClosedMesh& mesh,
  const conformal::CoordinateFrame& frame, vtkPolyData* output);

/// A surface that ToClosedMesh() would take, each of its points of a triangle, as a mesh
/// counter-clockwise seen from outside; an empty one for another surface, also where a cell names a
/// point that is not there. It warns of nothing.
conformal::Mesh ToMeshIfClosed(
  vtkPolyData* surface, const conformal::CoordinateFrame& frame, const conformal::Run& run = {});

/// A closed mesh, counter-clockwise seen from outside, with its map to the sphere from the point
/// array "SpherePosition".
/// @param[in] frame  in which its points are wanted; it need not be the surface's
/// @throws std::invalid_argument also if that array cannot be used
conformal::MappedMesh ToMappedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run = {});
}

#endif
