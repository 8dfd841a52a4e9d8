#include "vtkPCDReader.h"

#include "../Formats/PCD/PCDSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkPointData.h"

using contract::Read;
using contract::Reading;

TEST(PCDReader, WritesTheContractsArraysFromEveryFormat)
{
  const TemporaryFolder folder;
  for (const std::string& file : { samples::BinaryPCD(), samples::CompressedPCD() })
  {
    const Reading reading = Read<vtkPCDReader>(folder.write("a.pcd", file));
    contract::ExpectRead(reading); // a point that is not finite is no reason to warn
    vtkPointData* points = reading.Output->GetPointData();
    EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_FLOAT);
    EXPECT_EQ(reading.Output->GetNumberOfVerts(), 3);
    contract::ExpectArray(points, "Normals", VTK_FLOAT, 3, 3);
    contract::ExpectArray(points, "RGBA", VTK_UNSIGNED_CHAR, 4, 3);
    contract::ExpectArray(points, "pair", VTK_SHORT, 2, 3);
    contract::ExpectArray(points, "stamp", VTK_TYPE_UINT64, 1, 3);
    EXPECT_EQ(points->GetNormals(), points->GetArray("Normals"));
    EXPECT_EQ(points->GetScalars(), points->GetArray("RGBA"));
  }
  const Reading ascii = Read<vtkPCDReader>(folder.write("a.pcd", samples::AsciiPCD()));
  contract::ExpectRead(ascii);
  contract::ExpectArray(ascii.Output->GetPointData(), "RGB", VTK_UNSIGNED_CHAR, 3, 2);
  contract::ExpectArray(ascii.Output->GetPointData(), "label", VTK_SHORT, 1, 2);
}

TEST(PCDReader, WritesThePositionOfTheScanner)
{
  const TemporaryFolder folder;
  const std::string& ascii = samples::AsciiPCD();
  const auto fieldsOf = [&](const std::string& bytes)
  {
    const Reading reading = Read<vtkPCDReader>(folder.write("a.pcd", bytes));
    contract::ExpectRead(reading);
    return vtkSmartPointer<vtkFieldData>(reading.Output->GetFieldData());
  };
  EXPECT_FALSE(fieldsOf(ascii)->HasArray("ScannerPosition"));
  const auto fields = fieldsOf(samples::replaced(ascii, "VIEWPOINT 0 0 0", "VIEWPOINT 1 -2 3.5"));
  contract::ExpectArray(fields, "ScannerPosition", VTK_DOUBLE, 3, 1);
  const double* position = fields->GetArray("ScannerPosition")->GetTuple3(0);
  EXPECT_EQ(std::vector<double>(position, position + 3), (std::vector<double>{ 1, -2, 3.5 }));
}

TEST(PCDReader, RefusesBrokenFilesSayingWhere)
{
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& bytes, unsigned long code, const char* part)
  { contract::ExpectRefused(Read<vtkPCDReader>(folder.write("broken.pcd", bytes)), code, part); };
  const std::string& ascii = samples::AsciiPCD();
  const std::string compressed = samples::CompressedPCD();
  refuse(ascii.substr(0, ascii.size() - 9), vtkErrorCode::PrematureEndOfFileError, "line 14: ");
  refuse(
    compressed.substr(0, compressed.size() - 1), vtkErrorCode::PrematureEndOfFileError, "byte ");
  refuse(samples::replaced(ascii, "1.5", "1.2.3"), vtkErrorCode::FileFormatError, "line 12: ");
  refuse(samples::replaced(ascii, "WIDTH 3", "WIDTH 4"), vtkErrorCode::FileFormatError, "WIDTH");
}
