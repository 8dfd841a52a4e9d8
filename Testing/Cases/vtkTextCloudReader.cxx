#include "vtkTextCloudReader.h"

#include "../Formats/TextCloud/TextCloudSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase TextCloudReader()
{
  return CaseOfReader<vtkTextCloudReader>(samples::TextCloudFiles(), samples::BadTextCloudFiles());
}
}
