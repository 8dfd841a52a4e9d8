#include "vtkConformalLASReader.h"

#include "../Formats/LAS/LASSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase ConformalLASReader()
{
  return CaseOfReader<vtkConformalLASReader>(samples::LASFiles(), samples::BadLASFiles());
}
}
