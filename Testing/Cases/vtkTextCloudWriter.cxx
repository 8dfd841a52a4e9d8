#include "vtkTextCloudWriter.h"

#include "Files.h"
#include "vtkTextCloudReader.h"

namespace cases
{
Case TextCloudWriter()
{
  Case all = CaseOf<vtkTextCloudWriter>("vtkTextCloudWriter");
  all.Modes = { Writes(".xyz", Reading<vtkTextCloudReader>) };
  return all;
}
}
