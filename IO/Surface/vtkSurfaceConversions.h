// From vtkPolyData to what the makers of bytes take. Private.
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
/// Why nothing was written, with an error code of vtkErrorCode.
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

/// The error code of vtkErrorCode for how reading a file ended; none where it was aborted.
unsigned long ErrorCodeOf(conformal::ParseCode code);

/// The surface itself if all its cells are triangles, else a triangulated copy without others.
/// @pre the surface passed Glue/Checks.h
vtkSmartPointer<vtkPolyData> OnlyTriangles(vtkPolyData* input);

/// Points, polygons and named arrays of numbers. The active normals, texture coordinates and
/// colors (3 or 4 unsigned chars) are named "Normals", "TCoords" and "RGB" or "RGBA". Strips
/// become triangles; vertices and lines are left out, and so are cell arrays unless all cells are
/// polygons.
/// @pre the surface passed Glue/Checks.h
/// @throws WriteError for a surface without points, or a coordinate that is not finite
conformal::SurfaceData ToSurfaceData(vtkPolyData* input);

/// The pixels of a picture that can be a texture: one slice of unsigned char, RGB or RGBA.
/// @throws WriteError for another one, and for null
vtkUnsignedCharArray* PixelsOf(vtkImageData* picture);
}

#endif
