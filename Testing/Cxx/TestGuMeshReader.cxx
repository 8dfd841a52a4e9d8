#include "vtkGuMeshReader.h"

#include "../Formats/GuMesh/GuMeshSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

using contract::Read;
using contract::Reading;

TEST(GuMeshReader, WritesTheContractsArrays)
{
  const TemporaryFolder folder;
  const Reading reading = Read<vtkGuMeshReader>(folder.write("a.m", samples::RichGuMesh()));
  contract::ExpectRead(reading);
  vtkPointData* points = reading.Output->GetPointData();
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 3);
  contract::ExpectSpherePosition(reading.Output);
  contract::ExpectArray(points, "Normals", VTK_DOUBLE, 3, 4);
  contract::ExpectArray(points, "TCoords", VTK_DOUBLE, 2, 4);
  contract::ExpectArray(points, "RGB", VTK_UNSIGNED_CHAR, 3, 4);
  contract::ExpectArray(reading.Output->GetCellData(), "RGB", VTK_UNSIGNED_CHAR, 3, 3);
  EXPECT_EQ(points->GetNormals(), points->GetArray("Normals"));
  EXPECT_EQ(points->GetTCoords(), points->GetArray("TCoords"));
  EXPECT_EQ(points->GetScalars(), points->GetArray("RGB"));
}

TEST(GuMeshReader, RefusesBrokenFilesSayingWhere)
{
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& bytes, const char* part)
  {
    contract::ExpectRefused(
      Read<vtkGuMeshReader>(folder.write("broken.m", bytes)), vtkErrorCode::FileFormatError, part);
  };
  const std::string& plain = samples::PlainGuMesh();
  refuse(samples::replaced(plain, "1.5", "1.2.3"), "line 3: ");
  refuse(samples::replaced(plain, "Vertex 3", "Vertex 2"), "line 4: ");
  refuse(samples::replaced(plain, "Face 2 1 2 4", "Face 2 1 2 5"), "line 7: ");
}

TEST(GuMeshReader, WarnsOfWhatItLeavesOut)
{
  const TemporaryFolder folder;
  const Reading reading = Read<vtkGuMeshReader>(
    folder.write("a.m", samples::replaced(samples::PlainGuMesh(), "Face 1 1 3 2", "Face 1 1 3")));
  contract::ExpectWarned(reading, "NumberOfDroppedPolygons", 1);
}
