#include "vtkSPHARMSurfaceWriter.h"

#include "Files.h"
#include "vtkSPHARMSurfaceReader.h"

namespace cases
{
Case SPHARMSurfaceWriter()
{
  Case all = CaseOf<vtkSPHARMSurfaceWriter>("vtkSPHARMSurfaceWriter");
  all.Modes = { Writes("_surf.vtk", Reading<vtkSPHARMSurfaceReader>, BadIds | BadPoints | BadMap) };
  all.Modes.front().File.EndingsBeside = { "_para.vtk" };
  return all;
}
}
