#include "vtkStanfordScansReader.h"

#include "../Parsers/AlignedScansSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkPointData.h"

using contract::Read;
using contract::Reading;

TEST(StanfordScansReader, AlignsTheScansBesideTheFile)
{
  const TemporaryFolder folder;
  folder.write(samples::SphereScans());
  const Reading reading =
    Read<vtkStanfordScansReader>(folder.write("bun.conf", samples::SphereConf()));
  contract::ExpectRead(reading);
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 75);
  contract::ExpectArray(reading.Output->GetPointData(), "ScanId", VTK_INT, 1, 75);
  contract::ExpectArray(reading.Output->GetPointData(), "confidence", VTK_FLOAT, 1, 75);
  for (vtkIdType i = 0; i < 75; ++i)
  {
    const double* p = reading.Output->GetPoint(i);
    ASSERT_NEAR(std::hypot(p[0], p[1], p[2]), 1.0, 1e-6);
  }
}

TEST(StanfordScansReader, DoesAsItsPropertiesSay)
{
  const TemporaryFolder folder;
  const std::string inner = folder.file("inner");
  std::filesystem::create_directories(std::filesystem::u8path(inner));
  folder.write(samples::SphereScans());
  const std::string path = folder.write("inner/a.conf", "mesh ../side.ply 0.5 -1 2 0 0.6 0 0.8\n");
  const auto reader = vtkSmartPointer<vtkStanfordScansReader>::New();
  EXPECT_FALSE(reader->GetAllowExternalFiles());
  EXPECT_FALSE(reader->GetInvertRotation());
  contract::ExpectRefused(Reading(reader, path), vtkErrorCode::FileFormatError, "folder");
  reader->AllowExternalFilesOn();
  const Reading reading(reader, path);
  contract::ExpectRead(reading);
  const double x = reading.Output->GetPoint(0)[0];
  reader->InvertRotationOn();
  reader->Update();
  EXPECT_NE(reading.Output->GetPoint(0)[0], x);
  contract::ExpectPrints(reader, "InvertRotation");
  contract::ExpectPrints(reader, "AllowExternalFiles");
}

TEST(StanfordScansReader, SaysWhichScanIsBroken)
{
  const TemporaryFolder folder;
  folder.write(samples::SphereScans());
  contract::ExpectRefused(Read<vtkStanfordScansReader>(folder.write("a.conf",
                            samples::replaced(samples::SphereConf(), "side.ply", "broken.ply"))),
    vtkErrorCode::FileFormatError, "line 3: in \"broken.ply\": line 4");
  contract::ExpectRefused(Read<vtkStanfordScansReader>(folder.write("a.conf",
                            samples::replaced(samples::SphereConf(), "side.ply", "missing.ply"))),
    vtkErrorCode::FileNotFoundError, "line 3: in \"missing.ply\"");
}
