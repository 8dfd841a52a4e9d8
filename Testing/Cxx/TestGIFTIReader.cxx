#include "vtkGIFTIReader.h"

#include "../Formats/GIFTI/GIFTISamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkPointData.h"

using contract::Reading;

namespace
{
Reading Read(const std::string& surface, const std::string& sphere, const std::string& shape)
{
  auto reader = vtkSmartPointer<vtkGIFTIReader>::New();
  reader->SetSphereFileName(sphere.c_str());
  reader->SetShapeFileName(shape.c_str());
  return Reading(reader, surface);
}
}

TEST(GIFTIReader, PairsASurfaceWithItsSphereAndItsArrays)
{
  const TemporaryFolder folder;
  const Reading reading = Read(folder.write("a.surf.gii", samples::BinaryGIFTI(false, true, 0.5)),
    folder.write("sphere.surf.gii", samples::BinaryGIFTI(true, false)),
    folder.write("a.shape.gii", samples::ShapeGIFTI()));
  contract::ExpectRead(reading);
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 4);
  EXPECT_EQ(reading.Output->GetPoint(0)[2], -50.0);
  contract::ExpectSpherePosition(reading.Output);
  contract::ExpectArray(reading.Output->GetPointData(), "sulc & depth", VTK_SHORT, 1, 4);
  contract::ExpectArray(reading.Output->GetPointData(), "None", VTK_UNSIGNED_CHAR, 1, 4);
  contract::ExpectPrints(reading.Reader, "SphereFileName");
  contract::ExpectPrints(reading.Reader, "ShapeFileName");
}

TEST(GIFTIReader, KeepsArraysOfOneNameAndTakesTheSphereThatWasAskedFor)
{
  const TemporaryFolder folder;
  const std::string ascii = samples::AsciiGIFTI();
  const Reading twice =
    Read(folder.write("a.surf.gii", ascii), "", folder.write("a.shape.gii", samples::ShapeGIFTI()));
  contract::ExpectRead(twice);
  contract::ExpectArray(twice.Output->GetPointData(), "sulc & depth", VTK_FLOAT, 1, 4);
  contract::ExpectArray(twice.Output->GetPointData(), "sulc & depth2", VTK_SHORT, 1, 4);
  const Reading mapped =
    Read(folder.write("b.surf.gii", samples::replaced(ascii, "sulc &amp; depth", "SpherePosition")),
      folder.write("sphere.surf.gii", samples::BinaryGIFTI(true, false)), "");
  contract::ExpectRead(mapped);
  contract::ExpectSpherePosition(mapped.Output);
  EXPECT_EQ(mapped.Output->GetPointData()->GetNumberOfArrays(), 1);
}

TEST(GIFTIReader, RefusesFilesThatDoNotBelongTogether)
{
  const TemporaryFolder folder;
  const std::string surface = folder.write("a.surf.gii", samples::AsciiGIFTI());
  const std::string shape = folder.write("a.shape.gii", samples::ShapeGIFTI(5));
  contract::ExpectRefused(Read(surface, "", shape), vtkErrorCode::FileFormatError, "5 values");
  contract::ExpectRefused(Read(surface, shape, ""), vtkErrorCode::FileFormatError, "POINTSET");
  contract::ExpectRefused(
    Read(surface, folder.file("missing"), ""), vtkErrorCode::FileNotFoundError, "missing");
}
