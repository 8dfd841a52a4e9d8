// Convert between images of VTK and stacks of pictures in files.
#ifndef GlueStackConversions_h
#define GlueStackConversions_h

#include "TIFF/TIFFStack.h" // for TIFFStack

#include "vtkType.h" // for vtkIdType

#include <string> // for names

class vtkImageData;

namespace glue
{
/// Fill an empty image with a stack. The scalars are named "Intensity". A unit becomes the field
/// data "Unit". Values that are not finite are replaced by 0.
/// @return number of replaced values
vtkIdType SetStack(vtkImageData* image, conformal::TIFFStack& stack);

/// Type of the numbers of a stack.
enum class StackPixels
{
  Automatic, ///< UInt8 and UInt16 as they are, all others Float32
  UInt16,
  Float32
};

/// Copy a point array of an image to a stack.
/// @param[in] name  name of the array; empty for the active scalars
/// @param[in] unit  unit of the spacing; empty for the field data "Unit", if any
/// @param[in] frames  number of time steps that the slices of the image form
/// @throws std::invalid_argument if the image has no points or no such array, if a value is not
///   finite or exceeds the range of the type, or if the slices do not form so many time steps
conformal::TIFFStack ToStack(vtkImageData* image, const std::string& name, const std::string& unit,
  StackPixels pixels, int frames = 1);
}

#endif
