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
#include "vtkTextCloudReader.h"
#include "vtkTextCloudWriter.h"
#include "vtkTexturedSurfaceWriter.h"

#include "../Hostile/Folder.h"
#include "FuzzFilter.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace
{
// What is written must be read back with as many points; what is not must leave nothing.
template <typename Writer, typename Reader>
void WriteAndRead(Writer* writer, vtkPolyData* surface, const char* ending)
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
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    require(messages.errors() == 0, "its file cannot be read");
    require(reader->GetOutput()->GetNumberOfPoints() == surface->GetNumberOfPoints(),
      "its file has another number of points");
    fuzz::require(hostile::JudgeData(reader->GetOutput(), {}), "what was read back");
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  fuzz::FilterSource source(bytes, size);
  const int format = source.below(9);
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
  else
  {
    vtkNew<vtkTexturedSurfaceWriter> writer;
    writer->SetInputDataObject(1, source.picture());
    WriteAndRead<vtkTexturedSurfaceWriter, vtkConformalPLYReader>(writer, surface, ".ply");
  }
  return 0;
}
