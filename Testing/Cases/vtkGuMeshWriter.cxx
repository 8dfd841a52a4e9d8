#include "vtkGuMeshWriter.h"

#include "Files.h"
#include "vtkGuMeshReader.h"

namespace cases
{
Case GuMeshWriter()
{
  Case all = CaseOf<vtkGuMeshWriter>("vtkGuMeshWriter");
  all.Modes = { Writes(".m", Reading<vtkGuMeshReader>) };
  return all;
}
}
