// Fuzzes the class named by the environment variable CONFORMALSOM_FUZZED_CLASS, by its case:
// filters by what the case makes of bytes, writers in each of their modes, readers by a file of the
// bytes. A reader needs no program of its own; those of the parsers are faster, without a file.
#include "../Cases/Case.h"
#include "../Cases/FuzzFilter.h"
#include "../Cases/ReaderCase.h"
#include "../Hostile/Folder.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkSurfaceFileWriter.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace
{
using cases::Verdict;

// What is not written must leave nothing, and what is written must be read back with as many
// points.
void WriteAndRead(const cases::Case& of, fuzz::FilterSource& source)
{
  const cases::Mode& mode = of.Modes[source.below(static_cast<int>(of.Modes.size()))];
  const auto surface = source.surface();
  const hostile::Folder folder;
  const std::string path = folder.file("file" + mode.File.Ending);
  const cases::Algorithm made = of.make(mode, 0, surface);
  for (int port = 1; port < static_cast<int>(mode.Ports.size()); ++port)
  {
    vtkInformation* information = made->GetInputPortInformation(port);
    const bool isOptional = information->Has(vtkAlgorithm::INPUT_IS_OPTIONAL()) != 0;
    const bool isGiven = !isOptional || source.flag();
    made->SetInputDataObject(port, isGiven ? source.picture().Get() : nullptr);
  }
  auto* writer = vtkSurfaceFileWriter::SafeDownCast(made);
  const cases::Messages messages;
  writer->SetFileName(path.c_str());
  const bool isWritten = writer->Write() == 1;
  const auto require = [&](bool condition, const std::string& what)
  {
    fuzz::require({ condition ? Verdict::Fine : Verdict::Wrong, what + ": " + messages.first() },
      writer->GetClassName());
  };
  require(isWritten == (messages.errors() == 0), "result and message differ");
  require(isWritten != folder.contents().empty(), "result and file differ");
  if (isWritten && mode.File.WhatIsWrong)
  {
    require(mode.File.WhatIsWrong(path).empty(), mode.File.WhatIsWrong(path));
  }
  if (isWritten && mode.File.Read)
  {
    const cases::Algorithm reader = mode.File.Read(path);
    reader->Update();
    auto* read = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
    require(
      !read || !mode.File.KeepsPoints || read->GetNumberOfPoints() == surface->GetNumberOfPoints(),
      "its file has another number of points");
    fuzz::require(cases::JudgeData(reader->GetOutputDataObject(0), {}), "what was read back");
  }
  require(messages.errors() == 0 || !isWritten, "its file cannot be read");
}

// A file is read whole, or refused with a message and no points.
void Read(const cases::ReaderCase& of, const std::uint8_t* bytes, std::size_t size)
{
  const hostile::Folder folder;
  for (const auto& [name, content] : of.Beside)
  {
    std::ofstream(folder.file(name), std::ios::binary) << content;
  }
  const std::string path = folder.file("a file");
  std::ofstream(path, std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  const vtkSmartPointer<vtkSurfaceFileReader> reader = of.Make();
  reader->SetFileName(path.c_str());
  fuzz::run(reader);
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static const char* const name = std::getenv("CONFORMALSOM_FUZZED_CLASS");
  static const cases::ReaderCase* const reader = cases::FindReader(name ? name : "");
  if (reader)
  {
    Read(*reader, bytes, size);
    return 0;
  }
  static const cases::Case& of = cases::Of(name ? name : "");
  fuzz::FilterSource source(bytes, size);
  if (of.isWriter())
  {
    WriteAndRead(of, source);
  }
  else if (of.Fuzz)
  {
    of.Fuzz(source);
  }
  else
  {
    std::fprintf(stderr, "%s: write the function Fuzz of its case\n", of.Class.c_str());
    std::abort();
  }
  return 0;
}
