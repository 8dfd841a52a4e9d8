#include "vtkConformalPLYWriter.h"

#include "Files.h"
#include "vtkConformalPLYReader.h"

namespace cases
{
Case ConformalPLYWriter()
{
  Case all = CaseOf<vtkConformalPLYWriter>("vtkConformalPLYWriter");
  all.Modes = { Writes(".ply", Reading<vtkConformalPLYReader>) };
  return all;
}
}
