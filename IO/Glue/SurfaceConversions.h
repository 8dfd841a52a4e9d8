// Convert VTK surfaces to SurfaceData, the input of writers, and SurfaceData of parsers to VTK
// surfaces. Also return the pixels of a VTK image.
#ifndef GlueSurfaceConversions_h
#define GlueSurfaceConversions_h

#include "Bytes/ScalarType.h"  // for VTKTypeOf
#include "Bytes/SurfaceData.h" // for SurfaceData

#include "vtkPolyData.h"     // for vtkSmartPointer<vtkPolyData>
#include "vtkSmartPointer.h" // for OnlyTriangles

class vtkImageData;
class vtkUnsignedCharArray;

namespace glue
{
/// Return the type of VTK, such as VTK_FLOAT, for a type of numbers in files.
int VTKTypeOf(conformal::ScalarType type);

/// Return a surface whose polygons are all triangles. If the input has only triangles as polygons,
/// and no strips, the result is the input itself. Otherwise, the result is a triangulated copy
/// without vertex cells and line cells.
/// @pre array sizes and point ids were checked by the functions of Glue/Checks.h
vtkSmartPointer<vtkPolyData> OnlyTriangles(vtkPolyData* input);

/// Copy the points, polygons and numeric arrays of a VTK surface. The active normals and texture
/// coordinates are named "Normals" and "TCoords". Active scalars of 3 or 4 unsigned chars are
/// colors, named "RGB" or "RGBA". Strips become triangles. Vertex cells and line cells are skipped.
/// If the surface has cells that are not polygons, its cell arrays are skipped.
/// @pre array sizes and point ids were checked by the functions of Glue/Checks.h
/// @throws WriteError (FileErrors.h) if the surface has no points, or a coordinate is not finite
conformal::SurfaceData ToSurfaceData(vtkPolyData* input);

/// Move the points, polygons and arrays of a parsed file into an empty VTK surface. The arrays
/// "Normals", "TCoords", "RGB" and "RGBA" become the active normals, texture coordinates and
/// scalars. The position of the scanner becomes the field array "ScannerPosition". If the file has
/// no polygons, each point gets a vertex cell.
/// @param[in,out] data  parsed data; the contents are moved into the surface
void SetSurfaceData(vtkPolyData* surface, conformal::SurfaceData& data);

/// Return the pixels of a picture that can be a texture. The picture must be a 2D image of unsigned
/// chars, RGB or RGBA.
/// @throws WriteError (FileErrors.h) if the picture is null or of another kind
vtkUnsignedCharArray* PixelsOf(vtkImageData* picture);
}

#endif
