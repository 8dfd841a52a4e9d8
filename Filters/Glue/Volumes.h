/// Convert images of VTK with three dimensions to images of the core.
#ifndef GlueVolumes_h
#define GlueVolumes_h

#include "Base/CoordinateFrame.h" // for positions in a frame
#include "Base/Run.h"             // for Run
#include "Volume/VolumeImage.h"   // for the result

#include <string> // for the name of an array

class vtkImageData;
class vtkInformation;

namespace glue
{
/// Request the whole extent of an input image, for filters that need all of it for any output.
void RequestWholeImage(vtkInformation* inputInformation);

/// Copy one component of a point array of an image. Spacing, origin and direction of the image are
/// kept.
/// @param[in] name       name of the point array; empty for the active scalars
/// @param[in] component  number of the component (channel), from 0
/// @param[in] frame      frame to which positions are converted
/// @throws std::invalid_argument if the array or the component does not exist, or if a value is not
///   finite or exceeds the range of floats
conformal::VolumeImage ToVolume(vtkImageData* image, const std::string& name, int component,
  const conformal::CoordinateFrame& frame = {}, const conformal::Run& run = {});
}

#endif
