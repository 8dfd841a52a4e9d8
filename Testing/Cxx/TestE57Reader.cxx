#include "vtkE57Reader.h"

#include "../Formats/E57/E57Samples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

using contract::Read;
using contract::Reading;

namespace
{
Reading ReadScan(const std::string& file, int id)
{
  auto reader = vtkSmartPointer<vtkE57Reader>::New();
  reader->SetScanId(id);
  reader->ShiftCoordinatesOff();
  return Reading(reader, file);
}
}

TEST(E57Reader, WritesTheContractsArrays)
{
  const TemporaryFolder folder;
  const Reading reading = Read<vtkE57Reader>(folder.write("a.e57", samples::E57FromPye57()));
  contract::ExpectRead(reading); // points without a measurement are no reason to warn
  vtkPointData* points = reading.Output->GetPointData();
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 3);
  contract::ExpectArray(points, "RGB", VTK_UNSIGNED_CHAR, 3, 3);
  contract::ExpectArray(points, "Normals", VTK_FLOAT, 3, 3);
  contract::ExpectArray(points, "Intensity", VTK_FLOAT, 1, 3);
  contract::ExpectArray(points, "rowIndex", VTK_UNSIGNED_CHAR, 1, 3);
  EXPECT_EQ(points->GetScalars(), points->GetArray("RGB"));
  EXPECT_EQ(points->GetNormals(), points->GetArray("Normals"));
  contract::ExpectArray(reading.Output->GetFieldData(), "ScannerPosition", VTK_DOUBLE, 3, 1);
  EXPECT_FALSE(reading.Output->GetFieldData()->HasArray("CoordinateShift"));
}

TEST(E57Reader, ReadsOneScanInTheCoordinatesOfTheFile)
{
  const TemporaryFolder folder;
  const std::string pose = samples::E57Pose({ "1", "0", "0", "0", "412000", "5318000", "500" });
  const std::string file = folder.write("a.e57",
    samples::E57FileOf({ samples::E57FloatScan(3, pose), samples::E57FloatScan(2, pose) }));
  const Reading all = Read<vtkE57Reader>(file);
  contract::ExpectRead(all);
  contract::ExpectArray(all.Output->GetPointData(), "ScanId", VTK_INT, 1, 5);
  contract::ExpectArray(all.Output->GetFieldData(), "CoordinateShift", VTK_DOUBLE, 3, 1);
  const double* shift = all.Output->GetFieldData()->GetArray("CoordinateShift")->GetTuple3(0);
  const Reading one = ReadScan(file, 1);
  contract::ExpectRead(one);
  EXPECT_EQ(one.Output->GetNumberOfPoints(), 2);
  EXPECT_FALSE(one.Output->GetPointData()->HasArray("ScanId"));
  EXPECT_FALSE(one.Output->GetFieldData()->HasArray("CoordinateShift"));
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(one.Output->GetPoint(1)[c], all.Output->GetPoint(4)[c] + shift[c]);
  }
  contract::ExpectRefused(ReadScan(file, 2), vtkErrorCode::UserError, "the file has 2 scans");
}
