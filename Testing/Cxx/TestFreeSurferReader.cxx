#include "vtkFreeSurferReader.h"

#include "../Formats/FreeSurfer/FreeSurferSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkPointData.h"

using contract::Reading;

namespace
{
struct Names
{
  std::string Surface;
  std::string Sphere;
  std::string Curvature;
};

Reading Read(const Names& names)
{
  auto reader = vtkSmartPointer<vtkFreeSurferReader>::New();
  reader->SetSphereFileName(names.Sphere.c_str());
  reader->SetCurvatureFileName(names.Curvature.c_str());
  return Reading(reader, names.Surface);
}
}

TEST(FreeSurferReader, PairsASurfaceWithItsSphereAndItsCurvature)
{
  const TemporaryFolder folder;
  const Names names = { folder.write("lh.white", samples::FreeSurferTriangles(0.5F)),
    folder.write("lh.sphere", samples::FreeSurferTriangles()),
    folder.write("lh.curv", samples::FreeSurferCurv(false)) };
  const Reading reading = Read(names);
  contract::ExpectRead(reading);
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 4);
  EXPECT_EQ(reading.Output->GetPoint(0)[2], -50.0);
  contract::ExpectSpherePosition(reading.Output);
  EXPECT_EQ(reading.Output->GetPointData()->GetArray("SpherePosition")->GetComponent(0, 2), -1.0);
  contract::ExpectArray(reading.Output->GetPointData(), "Curvature", VTK_FLOAT, 1, 4);
  EXPECT_EQ(reading.Output->GetPointData()->GetArray("Curvature")->GetComponent(3, 0), 0.25);
  contract::ExpectPrints(reading.Reader, "SphereFileName");
  contract::ExpectPrints(reading.Reader, "CurvatureFileName");
}

TEST(FreeSurferReader, RefusesFilesThatDoNotBelongTogether)
{
  const TemporaryFolder folder;
  const std::string white = folder.write("lh.white", samples::FreeSurferTriangles());
  const std::string other = folder.write("lh.other", samples::FreeSurferQuads(true));
  const std::string center = folder.write("lh.center", samples::FreeSurferTriangles(0.0F));
  const std::string curv = folder.write("lh.curv", samples::FreeSurferCurv(true, 5));
  const auto refuse = [&](const Names& names, unsigned long code, const char* part)
  { contract::ExpectRefused(Read(names), code, part); };
  refuse({ white, other, "" }, vtkErrorCode::FileFormatError, "lh.other");
  refuse({ white, center, "" }, vtkErrorCode::FileFormatError, "center");
  refuse({ white, "", curv }, vtkErrorCode::FileFormatError, "5 values");
  refuse({ white, folder.file("missing"), "" }, vtkErrorCode::FileNotFoundError, "missing");
  refuse({ white, "", white }, vtkErrorCode::PrematureEndOfFileError, "lh.white");
  refuse({ folder.file("missing"), white, "" }, vtkErrorCode::FileNotFoundError, "missing");
}
