#include "vtkConformalOFFWriter.h"

#include "Files.h"
#include "vtkConformalOFFReader.h"

namespace cases
{
Case ConformalOFFWriter()
{
  Case all = CaseOf<vtkConformalOFFWriter>("vtkConformalOFFWriter");
  all.Modes = { Writes(".off", Reading<vtkConformalOFFReader>) };
  return all;
}
}
