#include "vtkE57Reader.h"

#include "../Formats/E57/E57Samples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase E57Reader()
{
  return CaseOfReader<vtkE57Reader>(samples::E57Files(), samples::BadE57Files());
}
}
