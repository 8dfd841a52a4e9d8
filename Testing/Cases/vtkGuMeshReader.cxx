#include "vtkGuMeshReader.h"

#include "../Formats/GuMesh/GuMeshSamples.h"
#include "ReaderCase.h"

namespace cases
{
ReaderCase GuMeshReader()
{
  return CaseOfReader<vtkGuMeshReader>(samples::GuMeshFiles(), samples::BadGuMeshFiles());
}
}
