#include "vtkConformalOFFReader.h"
#include "vtkConformalOFFWriter.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalPLYWriter.h"
#include "vtkFreeSurferReader.h"
#include "vtkFreeSurferWriter.h"
#include "vtkGIFTIReader.h"
#include "vtkGIFTIWriter.h"
#include "vtkGuMeshReader.h"
#include "vtkGuMeshWriter.h"
#include "vtkSPHARMSurfaceReader.h"
#include "vtkSPHARMSurfaceWriter.h"
#include "vtkSurfacePageWriter.h"
#include "vtkTextCloudReader.h"
#include "vtkTextCloudWriter.h"
#include "vtkTexturedSurfaceWriter.h"

#include "../Hostile/Folder.h"
#include "FuzzFilter.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <fstream>
#include <iterator>

namespace
{
// What is not written must leave nothing. What is written is judged by read(path, require).
template <typename Writer, typename Read>
void WriteAndJudge(Writer* writer, vtkPolyData* surface, const char* ending, Read read)
{
  const hostile::Folder folder;
  const std::string path = folder.file(std::string("file") + ending);
  const hostile::Messages messages;
  writer->SetInputDataObject(0, surface);
  writer->SetFileName(path.c_str());
  const bool isWritten = writer->Write() == 1;
  const auto require = [&](bool condition, const char* what)
  {
    fuzz::require({ condition ? hostile::Verdict::Fine : hostile::Verdict::Wrong,
                    what + (": " + messages.first()) },
      writer->GetClassName());
  };
  require(isWritten == (messages.errors() == 0), "result and message differ");
  require(isWritten != folder.contents().empty(), "result and file differ");
  if (isWritten)
  {
    read(path, require);
    require(messages.errors() == 0, "its file cannot be read");
  }
}

// What is written must be read back with as many points.
template <typename Writer, typename Reader>
void WriteAndRead(Writer* writer, vtkPolyData* surface, const char* ending)
{
  const auto read = [&](const std::string& path, const auto& require)
  {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    require(reader->GetOutput()->GetNumberOfPoints() == surface->GetNumberOfPoints(),
      "its file has another number of points");
    fuzz::require(hostile::JudgeData(reader->GetOutput(), {}), "what was read back");
  };
  WriteAndJudge(writer, surface, ending, read);
}

// A page must be whole, and none of its numbers may be one that JSON does not have.
void WritePage(vtkPolyData* surface, fuzz::FilterSource& source)
{
  vtkNew<vtkSurfacePageWriter> writer;
  writer->SetThreeJSFileName(CONFORMALSOM_THREE_STAND_IN);
  if (source.flag())
  {
    writer->SetInputDataObject(1, source.picture());
  }
  const auto judge = [](const std::string& path, const auto& require)
  {
    std::ifstream file(path, std::ios::binary);
    const std::string page{ std::istreambuf_iterator<char>(file), {} };
    const std::size_t begin = page.find("id=\"description\">");
    const std::size_t end = page.find("</script>", begin);
    require(begin < end && end < page.size() && page.find("</html>", end) < page.size(),
      "the page is not whole");
    const std::string description = page.substr(begin, end - begin);
    const std::size_t number = description.find(":["); // names stand behind the numbers
    const std::string numbers = description.substr(number, description.find("\"arrays\"") - number);
    require(numbers.find("nan") == std::string::npos && numbers.find("inf") == std::string::npos,
      "the page has a number that is not finite");
  };
  WriteAndJudge(writer.Get(), surface, ".html", judge);
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  const int format = source.below(10);
  const auto surface = source.surface();
  if (format == 0)
  {
    WriteAndRead<vtkConformalPLYWriter, vtkConformalPLYReader>(
      vtkNew<vtkConformalPLYWriter>(), surface, ".ply");
  }
  else if (format == 1)
  {
    WriteAndRead<vtkConformalOFFWriter, vtkConformalOFFReader>(
      vtkNew<vtkConformalOFFWriter>(), surface, ".off");
  }
  else if (format == 2)
  {
    WriteAndRead<vtkGIFTIWriter, vtkGIFTIReader>(vtkNew<vtkGIFTIWriter>(), surface, ".surf.gii");
  }
  else if (format == 3)
  {
    WriteAndRead<vtkGuMeshWriter, vtkGuMeshReader>(vtkNew<vtkGuMeshWriter>(), surface, ".m");
  }
  else if (format == 4)
  {
    WriteAndRead<vtkTextCloudWriter, vtkTextCloudReader>(
      vtkNew<vtkTextCloudWriter>(), surface, ".xyz");
  }
  else if (format <= 6)
  {
    vtkNew<vtkFreeSurferWriter> writer;
    writer->SetContent(format == 5 ? vtkFreeSurferWriter::SURFACE : vtkFreeSurferWriter::SPHERE);
    WriteAndRead<vtkFreeSurferWriter, vtkFreeSurferReader>(writer, surface, ".white");
  }
  else if (format == 7)
  {
    WriteAndRead<vtkSPHARMSurfaceWriter, vtkSPHARMSurfaceReader>(
      vtkNew<vtkSPHARMSurfaceWriter>(), surface, "_surf.vtk");
  }
  else if (format == 8)
  {
    vtkNew<vtkTexturedSurfaceWriter> writer;
    writer->SetInputDataObject(1, source.picture());
    WriteAndRead<vtkTexturedSurfaceWriter, vtkConformalPLYReader>(writer, surface, ".ply");
  }
  else
  {
    WritePage(surface, source);
  }
  return 0;
}
