// What all writers do alike, tried with every one of them.
#include "vtkSurfaceFileWriter.h"

#include "WriterContract.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkConformalOFFWriter.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalPLYWriter.h"
#include "vtkFreeSurferWriter.h"
#include "vtkGIFTIWriter.h"
#include "vtkGuMeshWriter.h"
#include "vtkStripper.h"
#include "vtkTextCloudWriter.h"

#include <limits>

namespace
{
std::vector<vtkSmartPointer<vtkSurfaceFileWriter>> Writers()
{
  return { vtkSmartPointer<vtkConformalOFFWriter>::New(),
    vtkSmartPointer<vtkConformalPLYWriter>::New(), vtkSmartPointer<vtkFreeSurferWriter>::New(),
    vtkSmartPointer<vtkGIFTIWriter>::New(), vtkSmartPointer<vtkGuMeshWriter>::New(),
    vtkSmartPointer<vtkTextCloudWriter>::New() };
}
}

TEST(SurfaceFileWriter, EveryWriterRefusesWhatItCannotWriteAndLeavesNoFile)
{
  const TemporaryFolder folder;
  for (const vtkSmartPointer<vtkSurfaceFileWriter>& writer : Writers())
  {
    SCOPED_TRACE(writer->GetClassName());
    const auto refuse = [&](vtkPolyData* surface, const std::string& path, unsigned long code)
    {
      contract::Observed observed(writer);
      writer->SetInputData(surface);
      writer->SetFileName(path.c_str());
      EXPECT_EQ(writer->Write(), 0);
      EXPECT_TRUE(observed.Error());
      EXPECT_EQ(writer->GetErrorCode(), code) << observed.ErrorMessage();
    };
    const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
    refuse(sphere, "", vtkErrorCode::NoFileNameError);
    refuse(sphere, folder.file("missing/a"), vtkErrorCode::CannotOpenFileError);
    vtkNew<vtkPolyData> empty;
    refuse(empty, folder.file("a"), vtkErrorCode::UserError);
    sphere->GetPoints()->SetPoint(3, 0, std::numeric_limits<double>::quiet_NaN(), 0);
    refuse(sphere, folder.file("a"), vtkErrorCode::UserError);
    const vtkSmartPointer<vtkPolyData> broken = contract::RichSphere();
    const vtkIdType ids[] = { 0, 1, 1000000 };
    vtkNew<vtkCellArray> polygons;
    polygons->InsertNextCell(3, ids);
    broken->SetPolys(polygons);
    refuse(broken, folder.file("a"), vtkErrorCode::UserError);
    EXPECT_EQ(folder.numberOfFiles(), 0u);
    contract::ExpectPrints(writer, "FileName");
  }
}

TEST(SurfaceFileWriter, EveryWriterStopsWhenAskedWithoutAWordAndLeavesTheInputAlone)
{
  const TemporaryFolder folder;
  for (const vtkSmartPointer<vtkSurfaceFileWriter>& writer : Writers())
  {
    SCOPED_TRACE(writer->GetClassName());
    const std::string path = folder.write("a", "before");
    const contract::Observed observed(writer);
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
    writer->AddObserver(vtkCommand::ProgressEvent, abort);
    const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
    const vtkMTimeType before = sphere->GetMTime();
    writer->SetInputData(sphere);
    writer->SetFileName(path.c_str());
    writer->Write();
    EXPECT_FALSE(observed.Error());
    EXPECT_EQ(folder.read("a"), "before");
    EXPECT_EQ(sphere->GetMTime(), before);
  }
}

TEST(SurfaceFileWriter, WritesStripsAsTriangles)
{
  const TemporaryFolder folder;
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(contract::RichSphere());
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  vtkNew<vtkConformalPLYWriter> writer;
  const contract::Reading read =
    contract::WrittenAndRead<vtkConformalPLYReader>(writer, stripper->GetOutput(), folder);
  contract::ExpectRead(read);
  EXPECT_EQ(read.Output->GetNumberOfPolys(), contract::RichSphere()->GetNumberOfPolys());
}
