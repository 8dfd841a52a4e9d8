// Convert surfaces and pictures of VTK for writers of formats, and surfaces of parsers for VTK.
#ifndef GlueSurfaceConversions_h
#define GlueSurfaceConversions_h

#include "Bytes/SurfaceData.h" // for SurfaceData

#include "vtkPolyData.h"     // for vtkSmartPointer<vtkPolyData>
#include "vtkSmartPointer.h" // for OnlyTriangles

class vtkImageData;
class vtkUnsignedCharArray;

namespace glue
{
/// Return a surface itself if all its cells are triangles, else a triangulated copy without other
/// cells.
/// @pre the surface passed Glue/Checks.h
vtkSmartPointer<vtkPolyData> OnlyTriangles(vtkPolyData* input);

/// Copy points, polygons and named arrays of numbers. The active normals, texture coordinates and
/// colors (3 or 4 unsigned chars) are named "Normals", "TCoords" and "RGB" or "RGBA". Strips become
/// triangles. Vertices and lines are skipped, and so are cell arrays unless all cells are polygons.
/// @pre the surface passed Glue/Checks.h
/// @throws WriteError (FileErrors.h) for a surface without points, or a coordinate that is not
///   finite
conformal::SurfaceData ToSurfaceData(vtkPolyData* input);

/// Move points, polygons and arrays of a parser into an empty surface. Arrays named "Normals",
/// "TCoords", "RGB" or "RGBA" become active. A surface without polygons is a cloud, with a vertex
/// for each point.
/// @param[in,out] data  moved from
void SetSurfaceData(vtkPolyData* surface, conformal::SurfaceData& data);

/// Return the pixels of a picture that can be a texture: one slice of unsigned char, RGB or RGBA.
/// @throws WriteError for any other picture, and for null
vtkUnsignedCharArray* PixelsOf(vtkImageData* picture);
}

#endif
