#include "vtkSPHARMSurfaceReader.h"

#include "../Formats/SPHARM/SPHARMMeshSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkPointData.h"
#include "vtkPolyDataWriter.h"

using contract::Reading;

namespace
{
Reading Read(const std::string& surface, const char* sphere = nullptr)
{
  auto reader = vtkSmartPointer<vtkSPHARMSurfaceReader>::New();
  reader->SetSphereFileName(sphere);
  return Reading(reader, surface);
}
}

TEST(SPHARMSurfaceReader, PairsASurfaceWithTheSphereOfItsName)
{
  const TemporaryFolder folder;
  const std::string surface = folder.write("a_surf.vtk", samples::SPHARMMesh());
  EXPECT_EQ(Read(surface).Output->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(vtkSPHARMSurfaceReader::CanReadFile(surface.c_str()), 0); // without its sphere
  const std::string sphere = folder.write("a_para.vtk", samples::SPHARMSphere());
  EXPECT_EQ(vtkSPHARMSurfaceReader::CanReadFile(surface.c_str()), 1);
  const Reading reading = Read(surface);
  contract::ExpectRead(reading);
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 4);
  EXPECT_EQ(reading.Output->GetPoint(1)[0], 1.5);
  contract::ExpectSpherePosition(reading.Output);
  EXPECT_EQ(reading.Output->GetPointData()->GetArray("SpherePosition")->GetComponent(3, 2), 1.0);
  contract::ExpectSpherePosition(Read(surface, "").Output); // as without a name
  // Or with one of any other name.
  const std::string other = folder.write("b.vtk", samples::SPHARMMeshByOffsets());
  contract::ExpectSpherePosition(Read(other, sphere.c_str()).Output);
  EXPECT_EQ(Read(other).Output->GetPointData()->GetNumberOfArrays(), 0);
  contract::ExpectPrints(reading.Reader, "SphereFileName");
}

TEST(SPHARMSurfaceReader, NamesItsSphereAmongTheFilesItReads)
{
  const auto reader = vtkSmartPointer<vtkSPHARMSurfaceReader>::New();
  reader->SetFileName("b/a_surf.vtk");
  using Names = std::vector<std::string>;
  EXPECT_EQ(contract::ReadFileNames(reader), (Names{ "b/a_surf.vtk", "b/a_para.vtk" }));
  reader->SetSphereFileName("other.vtk");
  EXPECT_EQ(contract::ReadFileNames(reader), (Names{ "b/a_surf.vtk", "other.vtk" }));
}

TEST(SPHARMSurfaceReader, RefusesFilesThatDoNotBelongTogether)
{
  const TemporaryFolder folder;
  const std::string surface = folder.write("a_surf.vtk", samples::SPHARMMesh());
  const std::string other =
    folder.write("other.vtk", samples::replaced(samples::SPHARMSphere(), "3 0 2 1", "3 0 1 2"));
  contract::ExpectRefused(Read(surface, other.c_str()), vtkErrorCode::FileFormatError, "other.vtk");
  contract::ExpectRefused(
    Read(surface, surface.c_str()), vtkErrorCode::FileFormatError, "center of the sphere");
  contract::ExpectRefused(
    Read(surface, folder.file("missing").c_str()), vtkErrorCode::FileNotFoundError, "missing");
  folder.write("a_para.vtk", "broken");
  contract::ExpectRefused(Read(surface), vtkErrorCode::UnrecognizedFileTypeError, "a_para.vtk");
}

// Whatever version and encoding VTK's own writer has.
TEST(SPHARMSurfaceReader, ReadsWhatVTKWrites)
{
  const TemporaryFolder folder;
  const Reading sample = Read(folder.write("sample.vtk", samples::SPHARMMesh()));
  for (const int type : { VTK_ASCII, VTK_BINARY })
  {
    for (const int version : { vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_4_2,
           vtkPolyDataWriter::VTK_LEGACY_READER_VERSION_5_1 })
    {
      const std::string path = folder.file("written.vtk");
      vtkNew<vtkPolyDataWriter> writer;
      writer->SetInputData(sample.Output);
      writer->SetFileType(type);
      writer->SetFileVersion(version);
      writer->SetFileName(path.c_str());
      ASSERT_EQ(writer->Write(), 1);
      const Reading reading = Read(path);
      contract::ExpectRead(reading);
      ASSERT_EQ(reading.Output->GetNumberOfPoints(), 4);
      EXPECT_EQ(reading.Output->GetNumberOfPolys(), 4);
      EXPECT_EQ(reading.Output->GetPoint(3)[2], sample.Output->GetPoint(3)[2]);
    }
  }
}
