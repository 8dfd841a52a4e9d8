#include "vtkConformalPLYReader.h"

#include "../Formats/PLY/PLYSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase ConformalPLYReader()
{
  return CaseOfReader<vtkConformalPLYReader>(samples::PLYFiles(), samples::BadPLYFiles());
}
}
