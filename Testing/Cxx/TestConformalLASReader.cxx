#include "vtkConformalLASReader.h"

#include "../Formats/LAS/LASSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

using contract::Read;
using contract::Reading;

TEST(ConformalLASReader, WritesTheContractsArrays)
{
  const TemporaryFolder folder;
  const Reading reading =
    Read<vtkConformalLASReader>(folder.write("a.las", samples::LASFileOf(8, 4)));
  contract::ExpectRead(reading);
  vtkPointData* points = reading.Output->GetPointData();
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 3);
  contract::ExpectArray(points, "RGB", VTK_UNSIGNED_CHAR, 3, 3);
  contract::ExpectArray(points, "Intensity", VTK_UNSIGNED_SHORT, 1, 3);
  contract::ExpectArray(points, "ReturnNumber", VTK_UNSIGNED_CHAR, 1, 3);
  contract::ExpectArray(points, "NumberOfReturns", VTK_UNSIGNED_CHAR, 1, 3);
  contract::ExpectArray(points, "Classification", VTK_UNSIGNED_CHAR, 1, 3);
  contract::ExpectArray(points, "PointSourceId", VTK_UNSIGNED_SHORT, 1, 3);
  contract::ExpectArray(points, "GPSTime", VTK_DOUBLE, 1, 3);
  contract::ExpectArray(points, "NearInfrared", VTK_UNSIGNED_SHORT, 1, 3);
  EXPECT_EQ(points->GetScalars(), points->GetArray("RGB"));
}

TEST(ConformalLASReader, PointsAndTheShiftAreTheCoordinatesOfTheFile)
{
  const TemporaryFolder folder;
  const std::string file = folder.write("a.las", samples::LASFromLaspy());
  const Reading shifted = Read<vtkConformalLASReader>(file);
  auto reader = vtkSmartPointer<vtkConformalLASReader>::New();
  reader->ShiftCoordinatesOff();
  const Reading kept(reader, file);
  contract::ExpectRead(shifted);
  contract::ExpectRead(kept);
  EXPECT_EQ(shifted.Output->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(kept.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
  contract::ExpectArray(shifted.Output->GetFieldData(), "CoordinateShift", VTK_DOUBLE, 3, 1);
  EXPECT_FALSE(kept.Output->GetFieldData()->HasArray("CoordinateShift"));
  const double* shift = shifted.Output->GetFieldData()->GetArray("CoordinateShift")->GetTuple3(0);
  for (vtkIdType i = 0; i < 3; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(kept.Output->GetPoint(i)[c], shifted.Output->GetPoint(i)[c] + shift[c]);
    }
  }
}

TEST(ConformalLASReader, StatesHowToConvertCompressedFiles)
{
  const TemporaryFolder folder;
  std::string bytes = samples::LASFileOf(3, 2);
  bytes[104] = static_cast<char>(0x83);
  const std::string file = folder.write("a.laz", bytes);
  EXPECT_EQ(vtkConformalLASReader::CanReadFile(file.c_str()), 1);
  contract::ExpectRefused(Read<vtkConformalLASReader>(file), vtkErrorCode::FileFormatError,
    "pdal translate scan.laz scan.las");
}
