#include "vtkSPHARMSurfaceReader.h"

#include "../Formats/SPHARM/SPHARMMeshSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase SPHARMSurfaceReader()
{
  return CaseOfReader<vtkSPHARMSurfaceReader>(samples::SPHARMMeshFiles(),
    samples::BadSPHARMMeshFiles(), { { "a file_para", samples::SPHARMSphere() } });
}
}
