#include "vtkFreeSurferReader.h"

#include "../Formats/FreeSurfer/FreeSurferSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase FreeSurferReader()
{
  return CaseOfReader<vtkFreeSurferReader>(
    samples::FreeSurferFiles(), samples::BadFreeSurferFiles());
}
}
