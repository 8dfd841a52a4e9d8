#include "vtkPlateModelReader.h"

#include "../Formats/PlateModel/PlateModelSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase PlateModelReader()
{
  return CaseOfReader<vtkPlateModelReader>(
    samples::PlateModelFiles(), samples::BadPlateModelFiles());
}
}
