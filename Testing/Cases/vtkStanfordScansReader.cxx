#include "vtkStanfordScansReader.h"

#include "../Formats/StanfordScans/AlignedScansSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase StanfordScansReader()
{
  return CaseOfReader<vtkStanfordScansReader>(
    samples::AlignedScansFiles(), samples::BadAlignedScansFiles(), samples::SphereScans());
}
}
