// Readers with sample files: a file vtkXReader.cxx defines cases::XReader() for the class
// vtkXReader, and no other file of the tests lists that class.
#ifndef CasesReaderCase_h
#define CasesReaderCase_h

#include "vtkSmartPointer.h"
#include "vtkSurfaceFileReader.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace cases
{
/// File names with the bytes of the files.
using NamedFiles = std::vector<std::pair<std::string, std::string>>;

struct ReaderCase
{
  std::string Name; ///< name of the class
  std::function<vtkSmartPointer<vtkSurfaceFileReader>()> Make;
  std::function<int(const char*)> CanReadFile;
  std::vector<std::string> Files;    ///< bytes of valid files
  std::vector<std::string> BadFiles; ///< bytes of files that the reader must refuse
  NamedFiles Beside;                 ///< files that the valid files refer to
};

/// The case of a reader of type Reader.
template <typename Reader>
ReaderCase CaseOfReader(
  std::vector<std::string> files, std::vector<std::string> badFiles, NamedFiles beside = {})
{
  ReaderCase result;
  result.Make = []() { return vtkSmartPointer<Reader>::New(); };
  result.CanReadFile = [](const char* name) { return Reader::CanReadFile(name); };
  result.Files = std::move(files);
  result.BadFiles = std::move(badFiles);
  result.Beside = std::move(beside);
  result.Name = result.Make()->GetClassName();
  return result;
}

/// The cases of all readers of surfaces and clouds, made from the files of this folder.
const std::vector<ReaderCase>& AllReaders();

/// The case of a reader, or null if the class has none.
const ReaderCase* FindReader(const std::string& className);

/// Bytes of files that every reader must refuse.
std::vector<std::string> FilesOfNoReader();
}

#endif
