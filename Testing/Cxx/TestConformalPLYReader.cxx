#include "vtkConformalPLYReader.h"

#include "../CommaLocale.h"
#include "../Formats/PLY/PLYSamples.h"
#include "../TemporaryFolder.h"
#include "FilterContract.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace
{
// Reads a file, and keeps what was said.
struct Reading
{
  explicit Reading(const std::string& path)
    : Observed(this->Reader)
  {
    this->Reader->SetFileName(path.c_str());
    this->Reader->Update();
    this->Output = this->Reader->GetOutput();
  }
  vtkNew<vtkConformalPLYReader> Reader;
  contract::Observed Observed;
  vtkPolyData* Output = nullptr;
};

void ExpectRefused(const std::string& path, unsigned long code, const std::string& part)
{
  const Reading reading(path);
  EXPECT_EQ(reading.Reader->GetErrorCode(), code) << path;
  EXPECT_TRUE(reading.Observed.Error()) << path;
  EXPECT_NE(reading.Observed.ErrorMessage().find(part), std::string::npos)
    << reading.Observed.ErrorMessage();
  EXPECT_EQ(reading.Output->GetNumberOfPoints(), 0);
  EXPECT_EQ(reading.Output->GetNumberOfCells(), 0);
}

void ExpectWarned(const Reading& reading, const char* array, vtkIdType count)
{
  EXPECT_FALSE(reading.Observed.Error());
  EXPECT_TRUE(reading.Observed.Warning());
  EXPECT_NE(
    reading.Observed.WarningMessage().find(" " + std::to_string(count) + " "), std::string::npos);
  contract::ExpectArray(reading.Output->GetFieldData(), array, VTK_ID_TYPE, 1, 1);
  EXPECT_EQ(reading.Output->GetFieldData()->GetArray(array)->GetComponent(0, 0), count);
}

std::vector<std::array<vtkIdType, 3>> TrianglesOf(vtkPolyData* surface)
{
  std::vector<std::array<vtkIdType, 3>> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    std::array<vtkIdType, 3> corners = { ids->GetId(0), ids->GetId(1), ids->GetId(2) };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  return triangles;
}
}

TEST(ConformalPLYReader, WritesTheContractsArrays)
{
  const TemporaryFolder folder;
  const Reading reading(folder.write("mesh.ply", samples::AsciiMesh()));
  ASSERT_FALSE(reading.Observed.Error() || reading.Observed.Warning());
  EXPECT_EQ(reading.Reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  vtkPolyData* mesh = reading.Output;
  vtkPointData* points = mesh->GetPointData();
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 4);
  EXPECT_EQ(mesh->GetNumberOfVerts(), 0);
  contract::ExpectArray(points, "Normals", VTK_FLOAT, 3, 4);
  contract::ExpectArray(points, "RGB", VTK_UNSIGNED_CHAR, 3, 4);
  contract::ExpectArray(points, "TCoords", VTK_FLOAT, 2, 4);
  contract::ExpectArray(points, "confidence", VTK_DOUBLE, 1, 4);
  contract::ExpectArray(points, "label", VTK_SHORT, 1, 4);
  contract::ExpectArray(mesh->GetCellData(), "group", VTK_INT, 1, 4);
  EXPECT_EQ(points->GetNormals(), points->GetArray("Normals"));
  EXPECT_EQ(points->GetTCoords(), points->GetArray("TCoords"));
  EXPECT_EQ(points->GetScalars(), points->GetArray("RGB"));
  EXPECT_EQ(points->GetArray("RGB")->GetComponent(3, 2), 252);
  EXPECT_EQ(TrianglesOf(mesh)[3], (std::array<vtkIdType, 3>{ 0, 3, 2 }));
}

TEST(ConformalPLYReader, ReadsTheSameFromEveryFormat)
{
  const TemporaryFolder folder;
  const Reading ascii(folder.write("ascii.ply", samples::AsciiMesh()));
  for (const bool isBig : { false, true })
  {
    const Reading binary(folder.write("binary.ply", samples::BinaryMesh(isBig)));
    ASSERT_FALSE(binary.Observed.Error());
    EXPECT_EQ(TrianglesOf(binary.Output), TrianglesOf(ascii.Output));
    for (vtkIdType i = 0; i < 4; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_EQ(binary.Output->GetPoint(i)[c], ascii.Output->GetPoint(i)[c]);
      }
      EXPECT_EQ(binary.Output->GetPointData()->GetArray("confidence")->GetComponent(i, 0),
        ascii.Output->GetPointData()->GetArray("confidence")->GetComponent(i, 0));
    }
  }
}

TEST(ConformalPLYReader, MakesACloudVisibleAndKeepsItsDoubles)
{
  const TemporaryFolder folder;
  const CommaLocale locale;
  const Reading reading(folder.write("cloud.ply", samples::AsciiCloud()));
  ASSERT_FALSE(reading.Observed.Error());
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 3);
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(reading.Output->GetPoint(1)[0], 1234567.123456789);
  vtkNew<vtkIdList> ids;
  reading.Output->GetVerts()->GetCellAtId(2, ids);
  EXPECT_EQ(ids->GetNumberOfIds(), 1);
  EXPECT_EQ(ids->GetId(0), 2);
}

TEST(ConformalPLYReader, JoinsNeighborsOfARangeGrid)
{
  const TemporaryFolder folder;
  const Reading reading(folder.write("grid.ply", samples::AsciiGrid()));
  ASSERT_FALSE(reading.Observed.Error());
  EXPECT_EQ(reading.Reader->GetMaximumEdgeLength(), 0.0);
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 3);
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 0);
  reading.Reader->SetMaximumEdgeLength(100.0);
  reading.Reader->Update();
  EXPECT_EQ(reading.Output->GetNumberOfPolys(), 7);
  reading.Reader->SetMaximumEdgeLength(-1.0);
  EXPECT_EQ(reading.Reader->GetMaximumEdgeLength(), 0.0);
  reading.Reader->SetMaximumEdgeLength(std::numeric_limits<double>::quiet_NaN());
  reading.Reader->Update();
  EXPECT_TRUE(reading.Observed.Error());
  EXPECT_EQ(reading.Reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_EQ(reading.Output->GetNumberOfPoints(), 0);
}

TEST(ConformalPLYReader, ReadsIgeasStripsAsTheClosedMeshsTriangles)
{
  const std::string scans = CONFORMALSOM_SCAN_DIR;
  if (!std::filesystem::exists(scans + "/igea.ply") ||
    !std::filesystem::exists(scans + "/igea-closed.ply"))
  {
    GTEST_SKIP() << "igea.ply and igea-closed.ply are not in CONFORMALSOM_SCAN_DIR";
  }
  const Reading strips(scans + "/igea.ply");
  const Reading closed(scans + "/igea-closed.ply");
  ASSERT_FALSE(strips.Observed.Error() || closed.Observed.Error());
  EXPECT_EQ(strips.Output->GetNumberOfPoints(), 134345);
  auto triangles = TrianglesOf(strips.Output);
  auto expected = TrianglesOf(closed.Output);
  EXPECT_EQ(triangles.size(), 268686u);
  EXPECT_TRUE(triangles == expected) << "in order";
  std::sort(triangles.begin(), triangles.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_TRUE(triangles == expected) << "as a set";
}

TEST(ConformalPLYReader, KnowsItsFilesByTheirContent)
{
  const TemporaryFolder folder;
  const auto canRead = [](const std::string& path)
  { return vtkConformalPLYReader::CanReadFile(path.c_str()); };
  EXPECT_EQ(canRead(folder.write("mesh.xyz", samples::AsciiMesh())), 1);
  EXPECT_EQ(canRead(folder.write("binary", samples::BinaryMesh(true))), 1);
  EXPECT_EQ(canRead(folder.write("solid.ply", "solid cube\nfacet normal 0 0 1\n")), 0);
  EXPECT_EQ(canRead(folder.write("empty.ply", "")), 0);
  EXPECT_EQ(canRead(folder.file("missing.ply")), 0);
  EXPECT_EQ(canRead(folder.file("")), 0);
  EXPECT_EQ(vtkConformalPLYReader::CanReadFile(nullptr), 0);
  vtkNew<vtkConformalPLYReader> reader;
  EXPECT_STREQ(reader->GetFileExtensions(), ".ply");
  EXPECT_STRNE(reader->GetDescriptiveName(), "");
}

TEST(ConformalPLYReader, RefusesWhatIsNoFile)
{
  const TemporaryFolder folder;
  ExpectRefused("", vtkErrorCode::NoFileNameError, "FileName");
  ExpectRefused(folder.file("missing.ply"), vtkErrorCode::FileNotFoundError, "no such file");
  ExpectRefused(folder.file(""), vtkErrorCode::CannotOpenFileError, "regular");
#ifndef _WIN32
  mkfifo(folder.file("pipe.ply").c_str(), 0600);
  ExpectRefused(folder.file("pipe.ply"), vtkErrorCode::CannotOpenFileError, "regular");
  ExpectRefused("/dev/zero", vtkErrorCode::CannotOpenFileError, "regular");
  if (geteuid() != 0) // nothing is forbidden to root
  {
    const std::string secret = folder.write("secret.ply", samples::AsciiMesh());
    std::filesystem::permissions(secret, std::filesystem::perms::none);
    ExpectRefused(secret, vtkErrorCode::CannotOpenFileError, "opened");
  }
#endif
  vtkNew<vtkConformalPLYReader> reader;
  const contract::Observed observed(reader);
  reader->Update();
  EXPECT_TRUE(observed.Error());
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
}

TEST(ConformalPLYReader, RefusesBrokenFilesSayingWhere)
{
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& bytes, unsigned long code, const char* part)
  { ExpectRefused(folder.write("broken.ply", bytes), code, part); };
  const std::string& mesh = samples::AsciiMesh();
  const std::string binary = samples::BinaryMesh(false);
  refuse("", vtkErrorCode::PrematureEndOfFileError, "line 1: ");
  refuse("OFF\n", vtkErrorCode::UnrecognizedFileTypeError, "line 1: found \"OFF\"");
  refuse(mesh.substr(0, mesh.size() / 2), vtkErrorCode::PrematureEndOfFileError, "line ");
  refuse(binary.substr(0, binary.size() - 7), vtkErrorCode::PrematureEndOfFileError, "byte ");
  refuse(samples::replaced(mesh, "vertex 4", "vertex 4000000000"), vtkErrorCode::FileFormatError,
    "4000000000");
  refuse(
    samples::replaced(mesh, "vertex 4", "vertex -4"), vtkErrorCode::FileFormatError, "line 8: ");
  refuse(samples::replaced(mesh, "1 0 0  0 1 0", "1.2.3 0 0  0 1 0"), vtkErrorCode::FileFormatError,
    "line 28: found \"1.2.3\"");
  refuse(samples::replaced(mesh, "1 0 0  0 1 0", "nan 0 0  0 1 0"), vtkErrorCode::FileFormatError,
    "line 28: ");
  refuse(samples::replaced(mesh, "8 3 0 1 3", "8 3 0 1 4"), vtkErrorCode::FileFormatError,
    "line 32: found id 4");
  refuse(
    samples::replaced(mesh, "8 3 0 1 3", "8 -3 0 1 3"), vtkErrorCode::FileFormatError, "line 32: ");
  refuse(samples::replaced(mesh, "list uchar int", "list float int"), vtkErrorCode::FileFormatError,
    "line 24: ");
}

TEST(ConformalPLYReader, WarnsOnceOfWhatItLeavesOut)
{
  const TemporaryFolder folder;
  const Reading points(
    folder.write("cloud.ply", samples::replaced(samples::AsciiCloud(), "7 8 9", "7 nan 9")));
  ExpectWarned(points, "NumberOfDroppedPoints", 1);
  EXPECT_EQ(points.Output->GetNumberOfPoints(), 2);
  EXPECT_EQ(points.Output->GetNumberOfVerts(), 2);

  std::string bytes = samples::replaced(samples::AsciiMesh(), "7 3 0 2 1\n", "7 2 0 2\n");
  bytes = samples::replaced(bytes, "9 3 1 2 3\n", "9 3 1 2 1\n");
  const Reading polygons(folder.write("mesh.ply", bytes));
  ExpectWarned(polygons, "NumberOfDroppedPolygons", 2);
  EXPECT_EQ(polygons.Output->GetNumberOfPolys(), 2);
  contract::ExpectArray(polygons.Output->GetCellData(), "group", VTK_INT, 1, 2);

  const Reading values(folder.write(
    "values.ply", samples::replaced(samples::AsciiMesh(), "0.25 0.5 -1", "nan inf -1")));
  ExpectWarned(values, "NumberOfReplacedValues", 2);

  const Reading more(folder.write("more.ply", samples::AsciiCloud() + "1 2 3\n"));
  ExpectWarned(more, "NumberOfUnreadBytes", 6);
  EXPECT_EQ(more.Output->GetNumberOfPoints(), 3);
  contract::ExpectArray(values.Output->GetPointData(), "TCoords", VTK_FLOAT, 2, 4);
}

TEST(ConformalPLYReader, AFileWithoutPointsIsEmpty)
{
  const TemporaryFolder folder;
  const Reading reading(folder.write("none.ply",
    "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nelement face 0\nend_header\n"));
  EXPECT_FALSE(reading.Observed.Error() || reading.Observed.Warning());
  EXPECT_EQ(reading.Output->GetNumberOfPoints(), 0);
  EXPECT_EQ(reading.Output->GetNumberOfCells(), 0);
}

TEST(ConformalPLYReader, StopsWhenAskedWithoutAWord)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("mesh.ply", samples::AsciiMesh());
  vtkNew<vtkConformalPLYReader> reader;
  const contract::Observed observed(reader);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, abort);
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  reader->RemoveObserver(tag);
  reader->SetAbortExecute(0); // later versions of VTK keep it
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 4);
}

TEST(ConformalPLYReader, RecoversFromAnErrorAndRunsOnlyWhenModified)
{
  const TemporaryFolder folder;
  const std::string good = folder.write("good.ply", samples::AsciiMesh());
  vtkNew<vtkConformalPLYReader> reader;
  contract::Observed observed(reader);
  reader->SetFileName(folder.file("missing").c_str());
  reader->Update();
  EXPECT_TRUE(observed.Error());
  observed.Clear();
  reader->SetFileName(good.c_str());
  contract::ExpectRunsOnlyWhenModified(reader, [&]() { reader->Modified(); });
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  contract::ExpectPrints(reader, "FileName");
  contract::ExpectPrints(reader, "MaximumEdgeLength");
}
