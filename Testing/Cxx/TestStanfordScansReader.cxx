#include "vtkStanfordScansReader.h"

#include "../Formats/StanfordScans/AlignedScansSamples.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkPointData.h"

#include <filesystem>

using contract::Read;
using contract::Reading;

namespace fs = std::filesystem;

TEST(StanfordScansReader, AlignsTheScansBesideTheFile)
{
  const TemporaryFolder folder;
  folder.write(samples::SphereScans());
  const Reading reading =
    Read<vtkStanfordScansReader>(folder.write("bun.conf", samples::SphereConf()));
  contract::ExpectRead(reading);
  EXPECT_EQ(reading.Output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(reading.Output->GetNumberOfVerts(), 75);
  contract::ExpectArray(reading.Output->GetPointData(), "ScanId", VTK_INT, 1, 75);
  contract::ExpectArray(reading.Output->GetPointData(), "confidence", VTK_FLOAT, 1, 75);
  for (vtkIdType i = 0; i < 75; ++i)
  {
    const double* p = reading.Output->GetPoint(i);
    ASSERT_NEAR(std::hypot(p[0], p[1], p[2]), 1.0, 1e-6);
  }
}

TEST(StanfordScansReader, DoesAsItsPropertiesSay)
{
  const TemporaryFolder folder;
  const std::string inner = folder.file("inner");
  std::filesystem::create_directories(std::filesystem::u8path(inner));
  folder.write(samples::SphereScans());
  const std::string path = folder.write("inner/a.conf", "mesh ../side.ply 0.5 -1 2 0 0.6 0 0.8\n");
  const auto reader = vtkSmartPointer<vtkStanfordScansReader>::New();
  EXPECT_FALSE(reader->GetAllowExternalFiles());
  EXPECT_FALSE(reader->GetInvertRotation());
  contract::ExpectRefused(Reading(reader, path), vtkErrorCode::FileFormatError, "folder");
  reader->AllowExternalFilesOn();
  const Reading reading(reader, path);
  contract::ExpectRead(reading);
  const double x = reading.Output->GetPoint(0)[0];
  reader->InvertRotationOn();
  reader->Update();
  EXPECT_NE(reading.Output->GetPoint(0)[0], x);
  contract::ExpectPrints(reader, "InvertRotation");
  contract::ExpectPrints(reader, "AllowExternalFiles");
}

TEST(StanfordScansReader, RefusesLinksThatLeadOutOfTheFolder)
{
  const TemporaryFolder folder;
  folder.write(samples::SphereScans());
  const fs::path inner = fs::u8path(folder.file("inner"));
  fs::create_directories(inner);
  std::error_code error;
  fs::create_symlink("../side.ply", inner / "link.ply", error);
  if (error)
  {
    GTEST_SKIP() << "no links here: " << error.message();
  }
  fs::create_directory_symlink("..", inner / "up");
  fs::create_symlink("nothing", inner / "dangling.ply");
  fs::create_symlink("loop.ply", inner / "loop.ply");
  fs::copy_file(fs::u8path(folder.file("front.ply")), inner / "real.ply");
  fs::create_symlink("real.ply", inner / "inside.ply");
  fs::create_directory_symlink("inner", fs::u8path(folder.file("linked folder")));
  const auto read = [&](const std::string& name, bool allows, const char* place = "inner/a.conf")
  {
    const auto reader = vtkSmartPointer<vtkStanfordScansReader>::New();
    reader->SetAllowExternalFiles(allows);
    return Reading(reader, folder.write(place, "mesh " + name + " 0 0 0 0 0 0 1\n"));
  };
  for (const char* name : { "link.ply", "./link.ply", "up/side.ply", "up/inner/link.ply" })
  {
    contract::ExpectRefused(read(name, false), vtkErrorCode::FileFormatError, "outside of");
    contract::ExpectRead(read(name, true));
  }
  contract::ExpectRefused(
    read("dangling.ply", false), vtkErrorCode::FileNotFoundError, "no such file");
  contract::ExpectRefused(read("loop.ply", false), vtkErrorCode::CannotOpenFileError, "opened");
  contract::ExpectRefused(read("up", true), vtkErrorCode::CannotOpenFileError, "regular");
  for (const char* name : { "real.ply", "inside.ply", "up/inner/real.ply" })
  {
    contract::ExpectRead(read(name, false));
    contract::ExpectRead(read(name, false, "linked folder/a.conf"));
  }
}

TEST(StanfordScansReader, ReadsEachFileOnceWhateverItsNames)
{
  const TemporaryFolder folder;
  folder.write(samples::SphereScans());
  const fs::path path = fs::u8path(folder.file(""));
  fs::create_directories(path / "a");
  std::vector<std::string> names = { "./side.ply", "a/../side.ply", ".//./side.ply" };
  std::error_code error;
  fs::create_symlink("side.ply", path / "link.ply", error);
  names.insert(names.end(), error ? 0 : 1, "link.ply");
#ifndef _WIN32
  fs::create_hard_link(path / "side.ply", path / "hard.ply", error);
  names.insert(names.end(), error ? 0 : 1, "hard.ply");
#endif
  for (const std::string& name : names)
  {
    const auto reader = vtkSmartPointer<vtkStanfordScansReader>::New();
    reader->AllowExternalFilesOn();
    const std::string conf = "mesh side.ply 0 0 0 0 0 0 1\nmesh " + name + " 0 0 0 0 0 0 1\n";
    contract::ExpectRefused(
      Reading(reader, folder.write("a.conf", conf)), vtkErrorCode::FileFormatError, "once");
  }
}

TEST(StanfordScansReader, NamesAllScansOfTheListAndOpensNone)
{
  const TemporaryFolder folder;
  const auto reader = vtkSmartPointer<vtkStanfordScansReader>::New();
  const auto namesOf = [&](const std::string& list)
  {
    const std::string path = folder.write("a.conf", list);
    reader->SetFileName(path.c_str());
    std::vector<std::string> names = contract::ReadFileNames(reader);
    EXPECT_FALSE(names.empty());
    EXPECT_EQ(names.front(), path);
    names.erase(names.begin());
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(namesOf("\xEF\xBB\xBF# mesh no.ply\ncamera 0 0 0 0 0 0 1\r\nmesh a.ply 0 0 0 0 0 0 1\r"
                    "\n\tbmesh\vsub/../b\xC2\xA0"
                    "1.ply 0 0 0 0 0 0 1\nmesh /etc/c.ply\nmesh\nmesh d.ply"),
    (Names{ folder.file("a.ply"),
      folder.file("sub/../b\xC2\xA0"
                  "1.ply"),
      "/etc/c.ply", folder.file("d.ply") }));
  EXPECT_EQ(
    namesOf("mesh a.ply 0 0 0 0 0 0 1\nmash b.ply 0 0 0 0 0 0 1\nmesh c.ply 0 0 0 0 0 0 1\n"),
    Names{ folder.file("a.ply") });
  EXPECT_EQ(namesOf("ply\n"), Names());
  EXPECT_EQ(namesOf("mesh " + std::string(std::size_t(17) << 20, 'a')), Names());
}

TEST(StanfordScansReader, SaysWhichScanIsBroken)
{
  const TemporaryFolder folder;
  folder.write(samples::SphereScans());
  contract::ExpectRefused(Read<vtkStanfordScansReader>(folder.write("a.conf",
                            samples::replaced(samples::SphereConf(), "side.ply", "broken.ply"))),
    vtkErrorCode::FileFormatError, "line 3: in \"broken.ply\": line 4");
  const auto reader = vtkSmartPointer<vtkStanfordScansReader>::New();
  reader->RequireAllScansOn();
  contract::ExpectPrints(reader, "RequireAllScans");
  contract::ExpectRefused(
    Reading(reader,
      folder.write("a.conf", samples::replaced(samples::SphereConf(), "side.ply", "missing.ply"))),
    vtkErrorCode::FileNotFoundError, "line 3: in \"missing.ply\"");
}

TEST(StanfordScansReader, GoesWithoutScansThatAreNotThere)
{
  const TemporaryFolder folder;
  folder.write(samples::SphereScans());
  const std::string path =
    folder.write("a.conf", samples::replaced(samples::SphereConf(), "front.ply", "missing.ply"));
  const auto reader = vtkSmartPointer<vtkStanfordScansReader>::New();
  const Reading reading(reader, path);
  contract::ExpectWarned(reading, "NumberOfMissingScans", 1);
  EXPECT_EQ(reading.Output->GetNumberOfPoints(), 50);
  vtkDataArray* ids = reading.Output->GetPointData()->GetArray("ScanId");
  EXPECT_EQ(ids->GetTuple1(0), 1.0); // the file's second
  EXPECT_EQ(ids->GetTuple1(49), 2.0);
  contract::ExpectArray(reading.Output->GetPointData(), "confidence", VTK_FLOAT, 1, 50);

  contract::ExpectRefused(
    Read<vtkStanfordScansReader>(folder.write("b.conf", "mesh missing.ply 0 0 0 0 0 0 1\n")),
    vtkErrorCode::FileNotFoundError, "none of the scans exists");
}
