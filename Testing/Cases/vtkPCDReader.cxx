#include "vtkPCDReader.h"

#include "../Formats/PCD/PCDSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase PCDReader()
{
  return CaseOfReader<vtkPCDReader>(samples::PCDFiles(), samples::BadPCDFiles());
}
}
