#include "vtkGIFTIReader.h"

#include "../Formats/GIFTI/GIFTISamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase GIFTIReader()
{
  return CaseOfReader<vtkGIFTIReader>(samples::GIFTIFiles(), samples::BadGIFTIFiles());
}
}
