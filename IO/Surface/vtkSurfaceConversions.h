// Convert vtkPolyData to the data structures of IO/Formats. Private.
#ifndef vtkSurfaceConversions_h
#define vtkSurfaceConversions_h

#include "Bytes/ParseStatus.h"
#include "Bytes/SurfaceData.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <stdexcept>
#include <string>

class vtkImageData;
class vtkUnsignedCharArray;

namespace vtkSurfaceConversions
{
/// Failure to write, with an error code of vtkErrorCode and a message.
class WriteError : public std::runtime_error
{
public:
  WriteError(unsigned long code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }
  const unsigned long Code;
};

/// Return the error code of vtkErrorCode for the result of a parser; NoError if it was aborted.
unsigned long ErrorCodeOf(conformal::ParseCode code);

/// Return the surface itself if all its cells are triangles, else a triangulated copy without
/// other cells.
/// @pre the surface passed Glue/Checks.h
vtkSmartPointer<vtkPolyData> OnlyTriangles(vtkPolyData* input);

/// Return points, polygons and named numeric arrays. The active normals, texture coordinates and
/// colors (3 or 4 unsigned chars) are named "Normals", "TCoords" and "RGB" or "RGBA". Strips
/// become triangles. Vertices and lines are left out, and so are cell arrays unless all cells are
/// polygons.
/// @pre the surface passed Glue/Checks.h
/// @throws WriteError for a surface without points, or a coordinate that is not finite
conformal::SurfaceData ToSurfaceData(vtkPolyData* input);

/// Return the pixels of a picture that can be a texture: one slice of unsigned char, RGB or RGBA.
/// @throws WriteError for any other picture, and for null
vtkUnsignedCharArray* PixelsOf(vtkImageData* picture);
}

#endif
