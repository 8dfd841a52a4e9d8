#include "vtkPlateModelReader.h"

#include "../Formats/PlateModel/PlateModelSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

using contract::Read;
using contract::Reading;

TEST(PlateModelReader, ReadsPlates)
{
  const TemporaryFolder folder;
  for (const std::string& text : { samples::NumberedPlates(), samples::VerPlates() })
  {
    const Reading reading = Read<vtkPlateModelReader>(folder.write("a.tab", text));
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
