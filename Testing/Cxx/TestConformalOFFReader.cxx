#include "vtkConformalOFFReader.h"

#include "../Formats/OFF/OFFSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

using contract::Read;
using contract::Reading;

TEST(ConformalOFFReader, WritesTheContractsArrays)
{
  const TemporaryFolder folder;
  const Reading reading = Read<vtkConformalOFFReader>(folder.write("a.off", samples::RichOFF()));
  contract::ExpectRead(reading);
  vtkPointData* points = reading.Output->GetPointData();
  vtkCellData* cells = reading.Output->GetCellData();
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 3);
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 0);
  contract::ExpectArray(points, "Normals", VTK_DOUBLE, 3, 4);
  contract::ExpectArray(points, "TCoords", VTK_DOUBLE, 2, 4);
  contract::ExpectArray(points, "RGBA", VTK_UNSIGNED_CHAR, 4, 4);
  contract::ExpectArray(cells, "RGB", VTK_UNSIGNED_CHAR, 3, 3);
  contract::ExpectArray(cells, "ColorIndex", VTK_INT, 1, 3);
  EXPECT_EQ(points->GetNormals(), points->GetArray("Normals"));
  EXPECT_EQ(points->GetTCoords(), points->GetArray("TCoords"));
  EXPECT_EQ(points->GetScalars(), points->GetArray("RGBA"));
  EXPECT_EQ(cells->GetScalars(), cells->GetArray("RGB"));
}

TEST(ConformalOFFReader, ReadsBinaryFilesAndVisibleClouds)
{
  const TemporaryFolder folder;
  const Reading binary = Read<vtkConformalOFFReader>(folder.write("a.off", samples::BinaryOFF()));
  contract::ExpectRead(binary);
  EXPECT_EQ(binary.Output->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(binary.Output->GetNumberOfPolys(), 1);
  const Reading cloud = Read<vtkConformalOFFReader>(folder.write("a.off", samples::OFFFiles()[3]));
  contract::ExpectRead(cloud);
  EXPECT_EQ(cloud.Output->GetNumberOfVerts(), 2);
}

TEST(ConformalOFFReader, RefusesBrokenFilesSayingWhere)
{
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& bytes, unsigned long code, const char* part)
  {
    contract::ExpectRefused(
      Read<vtkConformalOFFReader>(folder.write("broken.off", bytes)), code, part);
  };
  const std::string& plain = samples::PlainOFF();
  const std::string binary = samples::BinaryOFF();
  refuse(plain.substr(0, plain.size() / 2), vtkErrorCode::PrematureEndOfFileError, "line ");
  refuse(binary.substr(0, binary.size() - 3), vtkErrorCode::PrematureEndOfFileError, "byte ");
  refuse(samples::replaced(plain, "1.5", "1.2.3"), vtkErrorCode::FileFormatError, "line 4: ");
  refuse(samples::replaced(plain, "3 1 2 3", "3 1 2 4"), vtkErrorCode::FileFormatError, "line 9: ");
}

TEST(ConformalOFFReader, WarnsOfWhatItLeavesOut)
{
  const TemporaryFolder folder;
  const Reading reading = Read<vtkConformalOFFReader>(
    folder.write("a.off", samples::replaced(samples::PlainOFF(), "3 1 2 3\n", "2 1 2\n")));
  contract::ExpectWarned(reading, "NumberOfDroppedPolygons", 1);
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 3);
}
