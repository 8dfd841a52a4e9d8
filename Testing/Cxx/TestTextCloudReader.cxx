#include "vtkTextCloudReader.h"

#include "../Formats/Bytes/MadeBytes.h"
#include "../Formats/TextCloud/TextCloudSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkPointData.h"

using contract::Read;
using contract::Reading;

TEST(TextCloudReader, WritesTheContractsArrays)
{
  const TemporaryFolder folder;
  const Reading reading = Read<vtkTextCloudReader>(folder.write("a.csv", samples::NamedCloud()));
  contract::ExpectRead(reading);
  vtkPointData* points = reading.Output->GetPointData();
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 2);
  contract::ExpectArray(points, "Normals", VTK_DOUBLE, 3, 2);
  contract::ExpectArray(points, "RGB", VTK_UNSIGNED_CHAR, 3, 2);
  contract::ExpectArray(points, "Intensity", VTK_DOUBLE, 1, 2);
  contract::ExpectArray(points, "label", VTK_DOUBLE, 1, 2);
  EXPECT_EQ(points->GetNormals(), points->GetArray("Normals"));
  EXPECT_EQ(points->GetScalars(), points->GetArray("RGB"));
  EXPECT_EQ(points->GetScalars()->GetComponent(1, 2), 253);
}

TEST(TextCloudReader, ReadsTheFirstPointOfALaserScan)
{
  const TemporaryFolder folder;
  const Reading reading = Read<vtkTextCloudReader>(folder.write("a.pts", samples::LaserCloud()));
  contract::ExpectRead(reading);
  ASSERT_EQ(reading.Output->GetNumberOfPoints(), 4);
  EXPECT_EQ(reading.Output->GetPoint(0)[0], 0.0);
  EXPECT_EQ(reading.Output->GetPoint(3)[2], 1.0);
}

TEST(TextCloudReader, DoesAsItsPropertiesSay)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "0,5 1 2\nx\n1 1 1\n");
  const auto reader = vtkSmartPointer<vtkTextCloudReader>::New();
  EXPECT_FALSE(reader->GetDecimalComma());
  EXPECT_FALSE(reader->GetSkipMalformedLines());
  reader->DecimalCommaOn();
  contract::ExpectRefused(Reading(reader, path), vtkErrorCode::FileFormatError, "line 2");
  reader->SkipMalformedLinesOn();
  const Reading reading(reader, path);
  contract::ExpectWarned(reading, "NumberOfSkippedLines", 1);
  EXPECT_EQ(reading.Output->GetPoint(0)[0], 0.5);
  contract::ExpectPrints(reader, "DecimalComma");
  contract::ExpectPrints(reader, "SkipMalformedLines");
}

TEST(TextCloudReader, RefusesBrokenFilesSayingWhere)
{
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& bytes, unsigned long code, const char* part)
  {
    contract::ExpectRefused(
      Read<vtkTextCloudReader>(folder.write("broken.xyz", bytes)), code, part);
  };
  const std::string& plain = samples::PlainCloud();
  refuse(samples::replaced(plain, "-1e-3", "1e999"), vtkErrorCode::FileFormatError, "line 2: ");
  refuse(samples::replaced(plain, "7 8 9", "7 8"), vtkErrorCode::FileFormatError, "line 3: ");
  refuse("5\n" + plain, vtkErrorCode::PrematureEndOfFileError, "line 5: ");
  refuse("2000000000\n" + plain, vtkErrorCode::FileFormatError, "2000000000");
  refuse(samples::replaced(plain, " ", ";") + "0,5;1;1\n", vtkErrorCode::FileFormatError,
    "DecimalComma");
}

TEST(TextCloudReader, DropsPointsThatAreNotFinite)
{
  const TemporaryFolder folder;
  const Reading reading =
    Read<vtkTextCloudReader>(folder.write("a.xyz", "0 0 0\nnan 1 1\n2 2 2\n"));
  contract::ExpectWarned(reading, "NumberOfDroppedPoints", 1);
  EXPECT_EQ(reading.Output->GetNumberOfPoints(), 2);
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 2);
}
