// Convert surfaces and pictures of VTK to the data that writers of file formats read. Convert
// surfaces from parsers to VTK.
#ifndef GlueSurfaceConversions_h
#define GlueSurfaceConversions_h

#include "Bytes/SurfaceData.h" // for SurfaceData

#include "vtkPolyData.h"     // for vtkSmartPointer<vtkPolyData>
#include "vtkSmartPointer.h" // for OnlyTriangles

class vtkImageData;
class vtkUnsignedCharArray;

namespace glue
{
/// Return the surface itself if all its cells are triangles. Otherwise, return a triangulated copy
/// that contains only triangles.
/// @pre the surface passed the checks of Glue/Checks.h
vtkSmartPointer<vtkPolyData> OnlyTriangles(vtkPolyData* input);

/// Copy points, polygons and named arrays of numbers. The active normals, texture coordinates and
/// colors (3 or 4 unsigned chars) are named "Normals", "TCoords" and "RGB" or "RGBA". Strips become
/// triangles. Vertices and lines are skipped. Cell arrays are skipped unless all cells are
/// polygons.
/// @pre the surface passed the checks of Glue/Checks.h
/// @throws WriteError (FileErrors.h) if the surface has no points, or a coordinate is not finite
conformal::SurfaceData ToSurfaceData(vtkPolyData* input);

/// Move the points, polygons and arrays of a parsed file into an empty surface. Arrays named
/// "Normals", "TCoords", "RGB" or "RGBA" become active. A surface without polygons is a cloud, and
/// gets a vertex cell for each point.
/// @param[in,out] data  parsed data; the contents are moved into the surface
void SetSurfaceData(vtkPolyData* surface, conformal::SurfaceData& data);

/// Return the pixels of a picture that can be a texture: one slice of unsigned char, RGB or RGBA.
/// @throws WriteError if the picture is null or of another kind
vtkUnsignedCharArray* PixelsOf(vtkImageData* picture);
}

#endif
