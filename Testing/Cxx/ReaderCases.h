// Every reader of the module with files of its own.
#ifndef ReaderCases_h
#define ReaderCases_h

#include "../Parsers/OFFSamples.h"
#include "../Parsers/PCDSamples.h"
#include "../Parsers/PLYSamples.h"
#include "../Parsers/TextCloudSamples.h"

#include "vtkConformalOFFReader.h"
#include "vtkConformalPLYReader.h"
#include "vtkPCDReader.h"
#include "vtkSmartPointer.h"
#include "vtkTextCloudReader.h"

#include <functional>
#include <string>
#include <vector>

namespace contract
{
struct ReaderCase
{
  std::string Name;
  std::function<vtkSmartPointer<vtkSurfaceFileReader>()> Make;
  std::function<int(const char*)> CanReadFile;
  std::vector<std::string> Files;
};

template <typename Reader>
ReaderCase CaseOf(std::vector<std::string> files)
{
  ReaderCase result;
  result.Make = []() { return vtkSmartPointer<Reader>::New(); };
  result.CanReadFile = [](const char* name) { return Reader::CanReadFile(name); };
  result.Files = std::move(files);
  result.Name = result.Make()->GetClassName();
  return result;
}

inline std::vector<ReaderCase> ReaderCases()
{
  return { CaseOf<vtkConformalPLYReader>(samples::PLYFiles()),
    CaseOf<vtkConformalOFFReader>(samples::OFFFiles()), CaseOf<vtkPCDReader>(samples::PCDFiles()),
    CaseOf<vtkTextCloudReader>(samples::TextCloudFiles()) };
}
}

#endif
