#include "vtkPlateModelReader.h"
#include "vtkTextCloudReader.h"

#include "../Formats/PlateModel/PlateModelSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

using contract::Read;
using contract::Reading;

TEST(PlateModelReader, ReadsPlates)
{
  const TemporaryFolder folder;
  for (const std::string& text :
    { samples::NumberedPlates(), samples::VerPlates(), samples::TaggedPlates() })
  {
    const std::string name = folder.write("a.tab", text);
    EXPECT_TRUE(vtkPlateModelReader::CanReadFile(name.c_str()));
    const Reading reading = Read<vtkPlateModelReader>(name);
    contract::ExpectRead(reading);
    EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(reading.Output->GetNumberOfPoints(), 4);
    EXPECT_EQ(reading.Output->GetNumberOfPolys(), 4);
    EXPECT_EQ(reading.Output->GetPoint(1)[0], 1.5);
  }
}

TEST(PlateModelReader, RefusesBrokenFilesSayingWhere)
{
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& bytes, const char* part)
  {
    contract::ExpectRefused(Read<vtkPlateModelReader>(folder.write("broken.tab", bytes)),
      vtkErrorCode::FileFormatError, part);
  };
  const std::string& ver = samples::VerPlates();
  refuse(samples::replaced(ver, "1.5", "1.2.3"), "line 3: ");
  refuse(samples::replaced(ver, "1 2 4", "1 2 5"), "line 9: ");
  refuse(samples::replaced(ver, "  4   4", "  4   3"), "line 12: ");
}

TEST(PlateModelReader, WarnsOfWhatItLeavesOut)
{
  const TemporaryFolder folder;
  const Reading reading = Read<vtkPlateModelReader>(
    folder.write("a.ver", samples::replaced(samples::VerPlates(), "1 2 4", "1 2 2")));
  contract::ExpectWarned(reading, "NumberOfDroppedPolygons", 1);
}

TEST(PlateModelReader, ReadsGridsOnTheSidesOfACube)
{
  const TemporaryFolder folder;
  const std::string name = folder.write("a.txt", samples::CubeModel(5));
  EXPECT_TRUE(vtkPlateModelReader::CanReadFile(name.c_str()));
  EXPECT_FALSE(vtkTextCloudReader::CanReadFile(name.c_str()));
  const Reading reading = Read<vtkPlateModelReader>(name);
  contract::ExpectRead(reading);
  EXPECT_EQ(reading.Output->GetNumberOfPoints(), 6 * 25 + 2);
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 12 * 25);
}

TEST(PlateModelReader, LeavesOBJToOtherReaders)
{
  const TemporaryFolder folder;
  const std::string name = folder.write("a.OBJ", samples::TaggedPlates());
  EXPECT_FALSE(vtkPlateModelReader::CanReadFile(name.c_str()));
}

TEST(PlateModelReader, ReadsTheLabelBesideTheTable)
{
  const TemporaryFolder folder;
  const std::string table = folder.write("body.tab", samples::TaggedPlates());
  const auto read = [&]()
  { return Read<vtkPlateModelReader>(table).Output->GetFieldData()->GetNumberOfArrays(); };
  EXPECT_EQ(read(), 0);
  const vtkNew<vtkPlateModelReader> reader;
  reader->SetFileName(table.c_str());
  EXPECT_EQ(reader->GetReadFileNames()->GetNumberOfValues(), 1);
  const std::string label =
    folder.write("body.lbl", "TARGET_NAME = \"433 EROS\"\nUNIT = KILOMETER\n");
  ASSERT_EQ(reader->GetReadFileNames()->GetNumberOfValues(), 2);
  EXPECT_EQ(reader->GetReadFileNames()->GetValue(1), label);
  const Reading reading = Read<vtkPlateModelReader>(table);
  contract::ExpectRead(reading);
  vtkFieldData* data = reading.Output->GetFieldData();
  ASSERT_EQ(data->GetNumberOfArrays(), 2);
  EXPECT_EQ(data->GetArray("MetersPerUnit")->GetComponent(0, 0), 1000.0);
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(data->GetAbstractArray("TargetName"))->GetValue(0), "433 EROS");
  folder.write("body.lbl", "nothing of interest\n");
  EXPECT_EQ(read(), 0);
}

TEST(PlateModelReader, WarnsOfALabelWithTwoUnits)
{
  const TemporaryFolder folder;
  folder.write("body.xml", "<a><unit>km</unit><unit>m</unit></a>");
  const Reading reading = Read<vtkPlateModelReader>(folder.write("body.tab", samples::VerPlates()));
  EXPECT_EQ(reading.Output->GetNumberOfPoints(), 4);
  EXPECT_EQ(reading.Output->GetFieldData()->GetNumberOfArrays(), 0);
  reading.Seen.ExpectWarning("both kilometers and meters");
}
