#include "vtkConformalOFFReader.h"

#include "../Formats/OFF/OFFSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase ConformalOFFReader()
{
  return CaseOfReader<vtkConformalOFFReader>(samples::OFFFiles(), samples::BadOFFFiles());
}
}
