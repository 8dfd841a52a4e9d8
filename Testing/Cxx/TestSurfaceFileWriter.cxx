// What all writers do alike, tried with every one of them.
#include "vtkSurfaceFileWriter.h"

#include "../FullDisk.h"
#include "../OtherUser.h"
#include "WriterCases.h"
#include "WriterContract.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConformalOFFReader.h"
#include "vtkConformalOFFWriter.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalPLYWriter.h"
#include "vtkGuMeshReader.h"
#include "vtkGuMeshWriter.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkStripper.h"
#include "vtkTextCloudReader.h"
#include "vtkTextCloudWriter.h"

#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <limits>

namespace
{
namespace fs = std::filesystem;

using contract::WriterSetUp;
using contract::WriterSetUps;

// A writer that is asked to stop at its first sign of life.
void AbortAtOnce(vtkAlgorithm* writer)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  writer->AddObserver(vtkCommand::ProgressEvent, abort);
}

// Return the sphere with inactive arrays before the active ones, which have names of the format.
vtkSmartPointer<vtkPolyData> SphereWithDecoys()
{
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->DeepCopy(contract::RichSphere());
  vtkPointData* data = sphere->GetPointData();
  const vtkNew<vtkPointData> active;
  active->ShallowCopy(data);
  data->Initialize();
  const auto add = [&](vtkDataArray* array, const char* decoy, const char* name)
  {
    const auto inactive = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    inactive->DeepCopy(array);
    inactive->SetName(decoy);
    inactive->Fill(0.0);
    data->AddArray(inactive);
    array->SetName(name);
    data->AddArray(array);
  };
  add(active->GetScalars(), "RGB", "Painted");
  data->SetActiveScalars("Painted");
  add(active->GetNormals(), "Normals", "MyNormals");
  data->SetActiveNormals("MyNormals");
  add(active->GetTCoords(), "TCoords", "UV");
  data->SetActiveTCoords("UV");
  return sphere;
}

template <typename Reader, typename Writer>
void ExpectActiveArrays(bool hasTextureCoordinates)
{
  const TemporaryFolder folder;
  vtkNew<Writer> writer;
  SCOPED_TRACE(writer->GetClassName());
  const auto sphere = SphereWithDecoys();
  const contract::Reading read = contract::WrittenAndRead<Reader>(writer, sphere, folder);
  contract::ExpectRead(read);
  vtkPointData* points = read.Output->GetPointData();
  contract::ExpectSameArray(points->GetScalars(), sphere->GetPointData()->GetScalars());
  contract::ExpectSameArray(points->GetNormals(), sphere->GetPointData()->GetNormals());
  if (hasTextureCoordinates)
  {
    contract::ExpectSameArray(points->GetTCoords(), sphere->GetPointData()->GetTCoords());
  }
}
}

TEST(SurfaceFileWriter, WritesActiveArraysAsThoseOfTheFormat)
{
  ExpectActiveArrays<vtkConformalPLYReader, vtkConformalPLYWriter>(true);
  ExpectActiveArrays<vtkConformalOFFReader, vtkConformalOFFWriter>(true);
  ExpectActiveArrays<vtkGuMeshReader, vtkGuMeshWriter>(true);
  ExpectActiveArrays<vtkTextCloudReader, vtkTextCloudWriter>(false);
}

TEST(SurfaceFileWriter, WritesArraysOfPolygonsAfterOtherCells)
{
  const TemporaryFolder folder;
  const auto sphere = contract::RichSphere();
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(sphere->GetPoints());
  surface->SetPolys(sphere->GetPolys());
  vtkNew<vtkCellArray> vertices, lines;
  vertices->InsertNextCell({ 0 });
  lines->InsertNextCell({ 0, 1 });
  surface->SetVerts(vertices);
  surface->SetLines(lines);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    numbers->InsertNextValue(static_cast<int>(cell));
  }
  surface->GetCellData()->AddArray(numbers);
  vtkNew<vtkConformalPLYWriter> writer;
  const contract::Reading read =
    contract::WrittenAndRead<vtkConformalPLYReader>(writer, surface, folder);
  contract::ExpectRead(read);
  vtkDataArray* kept = read.Output->GetCellData()->GetArray("Number");
  ASSERT_NE(kept, nullptr);
  ASSERT_EQ(kept->GetNumberOfTuples(), surface->GetNumberOfPolys());
  EXPECT_EQ(kept->GetComponent(0, 0), 2.0);
}

TEST(SurfaceFileWriter, EveryWriterRefusesWhatItCannotWriteAndLeavesNoFile)
{
  for (WriterSetUp& setUp : WriterSetUps())
  {
    SCOPED_TRACE(setUp.label());
    const TemporaryFolder folder;
    const std::string path = folder.file("a" + setUp.Endings.back());
    const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
    setUp.expectRefused(sphere, "", vtkErrorCode::NoFileNameError);
    setUp.expectRefused(sphere, folder.file("missing/a" + setUp.Endings.back()),
      vtkErrorCode::CannotOpenFileError, "missing/a");
    vtkNew<vtkPolyData> empty;
    setUp.expectRefused(empty, path, vtkErrorCode::UserError);
    sphere->GetPoints()->SetPoint(3, 0, std::numeric_limits<double>::quiet_NaN(), 0);
    setUp.expectRefused(sphere, path, vtkErrorCode::UserError);
    const vtkSmartPointer<vtkPolyData> broken = contract::RichSphere();
    const vtkIdType ids[] = { 0, 1, 1000000 };
    vtkNew<vtkCellArray> polygons;
    polygons->InsertNextCell(3, ids);
    broken->SetPolys(polygons);
    setUp.expectRefused(broken, path, vtkErrorCode::UserError);
    EXPECT_EQ(folder.numberOfFiles(), 0u);
    contract::ExpectPrints(setUp.Writer, "FileName");
  }
}

TEST(SurfaceFileWriter, EveryWriterSaysWhichInputIsMissing)
{
  for (WriterSetUp& setUp : WriterSetUps())
  {
    for (int port = 0; port < setUp.Writer->GetNumberOfInputPorts(); ++port)
    {
      SCOPED_TRACE(setUp.label() + " " + std::to_string(port));
      const bool isOptional =
        setUp.Writer->GetInputPortInformation(port)->Has(vtkAlgorithm::INPUT_IS_OPTIONAL()) != 0;
      const TemporaryFolder folder;
      contract::Observed observed(setUp.Writer);
      setUp.Writer->SetInputData(0, contract::RichSphere());
      const vtkSmartPointer<vtkDataObject> before =
        setUp.Writer->GetNumberOfInputConnections(port) > 0
        ? setUp.Writer->GetInputDataObject(port, 0)
        : nullptr;
      setUp.Writer->SetInputConnection(port, nullptr);
      setUp.Writer->SetFileName(folder.file("a" + setUp.Endings.back()).c_str());
      if (isOptional)
      {
        EXPECT_EQ(setUp.Writer->Write(), 1);
        EXPECT_EQ(folder.numberOfFiles(), setUp.Endings.size());
        continue;
      }
      EXPECT_EQ(setUp.Writer->Write(), 0);
      EXPECT_EQ(setUp.Writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
      observed.ExpectError("input port " + std::to_string(port) + " has no data");
      EXPECT_EQ(folder.numberOfFiles(), 0u);
      setUp.Writer->SetInputDataObject(port, before);
    }
  }
}

TEST(SurfaceFileWriter, EveryWriterStopsWhenAskedWithoutAWordAndLeavesTheInputAlone)
{
  for (WriterSetUp& setUp : contract::WriterSetUps())
  {
    SCOPED_TRACE(setUp.label());
    const TemporaryFolder folder;
    const std::string name = "a" + setUp.Endings.back();
    const std::string path = folder.write(name, "before");
    const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
    const vtkMTimeType before = sphere->GetMTime();
    const contract::Observed observed(setUp.Writer);
    AbortAtOnce(setUp.Writer);
    setUp.Writer->SetInputData(sphere);
    setUp.Writer->SetFileName(path.c_str());
    EXPECT_EQ(setUp.Writer->Write(), 0);
    EXPECT_EQ(
      setUp.Writer->GetErrorCode(), static_cast<unsigned long>(vtkSurfaceFileWriter::AbortedError));
    EXPECT_FALSE(observed.Error() || observed.Warning());
    EXPECT_EQ(folder.read(name), "before");
    EXPECT_EQ(folder.numberOfFiles(), 1u);
    EXPECT_EQ(sphere->GetMTime(), before);
    setUp.Writer->RemoveObservers(vtkCommand::ProgressEvent);
    setUp.Writer->SetAbortExecute(0); // later versions of VTK keep it
    EXPECT_EQ(setUp.Writer->Write(), 1);
    EXPECT_EQ(setUp.Writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    EXPECT_NE(folder.read(name), "before");
  }
}

// At every place that a writer writes to, also that of a picture beside the surface.
TEST(SurfaceFileWriter, EveryWriterReplacesNothingButRegularFiles)
{
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  bool hasDevices = true;
  const auto makeFolder = [](const std::string& path) { fs::create_directory(path); };
  const auto makePipe = [](const std::string& path) { ASSERT_EQ(mkfifo(path.c_str(), 0666), 0); };
  const auto makeDevice = [&](const std::string& path) // that of no driver
  { hasDevices = mknod(path.c_str(), S_IFCHR | 0666, makedev(240, 0)) == 0; };
  const std::pair<std::string, std::function<void(const std::string&)>> kinds[] = {
    { "directory", makeFolder }, { "pipe", makePipe }, { "device", makeDevice }
  };
  for (WriterSetUp& setUp : WriterSetUps())
  {
    for (const std::string& ending : setUp.Endings)
    {
      for (const auto& [kind, make] : kinds)
      {
        SCOPED_TRACE(setUp.label() + " " + ending + " " + kind);
        const TemporaryFolder folder;
        const std::string path = folder.file("a" + setUp.Endings.back());
        make(folder.file("a" + ending));
        if (kind == "device" && !hasDevices)
        {
          continue;
        }
        const fs::file_status before = fs::status(folder.file("a" + ending));
        setUp.expectRefused(sphere, path, vtkErrorCode::CannotOpenFileError,
          folder.file("a" + ending) + " cannot be written: it is a " + kind);
        fs::rename(folder.file("a" + ending), folder.file("thing"));
        fs::create_symlink("thing", folder.file("a" + ending));
        setUp.expectRefused(sphere, path, vtkErrorCode::CannotOpenFileError, "it is a " + kind);
        EXPECT_TRUE(fs::is_symlink(folder.file("a" + ending)));
        EXPECT_EQ(fs::status(folder.file("thing")).type(), before.type());
        EXPECT_EQ(folder.numberOfFiles(), 2u);
      }
    }
  }
  if (!hasDevices)
  {
    GTEST_SKIP() << "All but devices was tried: only root can make one";
  }
}

TEST(SurfaceFileWriter, EveryWriterFollowsLinks)
{
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  for (WriterSetUp& setUp : WriterSetUps())
  {
    SCOPED_TRACE(setUp.label());
    const TemporaryFolder folder;
    fs::create_directory(folder.file("there"));
    for (const bool isDangling : { true, false })
    {
      const std::string name = isDangling ? "dangling" : "link";
      for (const std::string& ending : setUp.Endings)
      {
        folder.write("there/link" + ending, "before");
        fs::create_symlink("there/" + name + ending, folder.file(name + ending));
      }
      EXPECT_EQ(setUp.write(sphere, folder.file(name + setUp.Endings.back())), 1) << setUp.Message;
      for (const std::string& ending : setUp.Endings)
      {
        EXPECT_TRUE(fs::is_symlink(folder.file(name + ending))) << ending;
        EXPECT_GT(folder.read("there/" + name + ending).size(), 50u) << ending;
      }
    }
    EXPECT_EQ(folder.numberOfFiles(), 2 * setUp.Endings.size() + 1);
  }
}

TEST(SurfaceFileWriter, EveryWriterKeepsOwnersModesAndTheFilesOfOthers)
{
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  constexpr unsigned int another = 12345; // of no user, very likely
  bool isAnother = false;
  for (WriterSetUp& setUp : WriterSetUps())
  {
    SCOPED_TRACE(setUp.label());
    const TemporaryFolder folder;
    for (const std::string& ending : setUp.Endings)
    {
      const std::string path = folder.write("a" + ending, "before");
      isAnother = chown(path.c_str(), another, another + 1) == 0; // only root may
      chmod(path.c_str(), 0600);
      folder.write("a" + ending + ".part", "mine");
    }
    EXPECT_EQ(setUp.write(sphere, folder.file("a" + setUp.Endings.back())), 1) << setUp.Message;
    for (const std::string& ending : setUp.Endings)
    {
      EXPECT_GT(folder.read("a" + ending).size(), 50u) << ending;
      EXPECT_EQ(fs::status(folder.file("a" + ending)).permissions(),
        fs::perms::owner_read | fs::perms::owner_write)
        << ending;
      EXPECT_EQ(folder.read("a" + ending + ".part"), "mine") << ending;
      struct stat now = {};
      ASSERT_EQ(stat(folder.file("a" + ending).c_str(), &now), 0);
      EXPECT_EQ(now.st_uid, isAnother ? another : geteuid()) << ending;
      EXPECT_EQ(now.st_gid == another + 1, isAnother) << ending;
    }
    EXPECT_EQ(folder.numberOfFiles(), 2 * setUp.Endings.size());
  }
}

// A file beside a new surface may be somebody's own.
TEST(SurfaceFileWriter, EveryWriterWarnsOfFilesThatItReplacesBesideANewSurface)
{
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  for (WriterSetUp& setUp : WriterSetUps())
  {
    SCOPED_TRACE(setUp.label());
    const TemporaryFolder folder;
    const std::string name = "a" + setUp.Endings.back();
    const auto write = [&]()
    {
      contract::Observed observed(setUp.Writer);
      EXPECT_EQ(setUp.write(sphere, folder.file(name)), 1) << setUp.Message;
      return observed.Warning() ? observed.WarningMessage() : "";
    };
    EXPECT_EQ(write(), "");
    EXPECT_EQ(write(), ""); // its own files
    for (const std::string& ending : setUp.Endings)
    {
      const bool isBeside = ending != setUp.Endings.back();
      for (const std::string& other : setUp.Endings)
      {
        fs::remove(folder.file("a" + other));
      }
      folder.write("a" + ending, "before");
      const std::string warning = write();
      EXPECT_EQ(warning.empty(), !isBeside) << ending << warning;
      EXPECT_EQ(
        warning.find("replaced " + folder.file("a" + ending)) != std::string::npos, isBeside)
        << ending << warning;
      EXPECT_NE(folder.read("a" + ending), "before") << ending;
      EXPECT_EQ(folder.numberOfFiles(), setUp.Endings.size());
    }
  }
}

TEST(SurfaceFileWriter, EveryWriterTakesTheLongestNamesAndNoNewlines)
{
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  for (WriterSetUp& setUp : WriterSetUps())
  {
    SCOPED_TRACE(setUp.label());
    const TemporaryFolder folder;
    const std::string& ending = setUp.Endings.back();
    const std::string longest(255 - ending.size(), 'x');
    EXPECT_EQ(setUp.write(sphere, folder.file(longest + ending)), 1) << setUp.Message;
    EXPECT_EQ(folder.numberOfFiles(), setUp.Endings.size());
    for (const char* name : { "a\nb", "a\r", "\x1B[2J", "sub\n/a" })
    {
      setUp.expectRefused(
        sphere, folder.file(name + ending), vtkErrorCode::UserError, "control character");
    }
    EXPECT_EQ(folder.numberOfFiles(), setUp.Endings.size());
  }
}

TEST(SurfaceFileWriter, EveryWriterReplacesAllFilesOfASurfaceOrNone)
{
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  for (WriterSetUp& setUp : WriterSetUps())
  {
    for (const std::string& ending : setUp.Endings)
    {
      SCOPED_TRACE(setUp.label() + " " + ending);
      const TemporaryFolder folder;
      for (const std::string& other : setUp.Endings)
      {
        folder.write("a" + other, "before");
      }
      fs::remove(folder.file("a" + ending));
      fs::create_symlink("missing/file", folder.file("a" + ending));
      setUp.expectRefused(sphere, folder.file("a" + setUp.Endings.back()),
        vtkErrorCode::CannotOpenFileError, "a" + ending + " cannot");
      fs::remove(folder.file("a" + ending));
      folder.write("a" + ending, "before");
      for (const std::string& other : setUp.Endings)
      {
        EXPECT_EQ(folder.read("a" + other), "before") << other;
      }
      EXPECT_EQ(folder.numberOfFiles(), setUp.Endings.size());
    }
  }
}

TEST(SurfaceFileWriter, EveryWriterLeavesTheOlderFileOnAFullDiskAndInAFolderOfOthers)
{
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  bool isAnother = true;
  for (WriterSetUp& setUp : WriterSetUps())
  {
    SCOPED_TRACE(setUp.label());
    const TemporaryFolder folder;
    const std::string path = folder.file("a" + setUp.Endings.back());
    for (const std::string& ending : setUp.Endings)
    {
      chmod(folder.write("a" + ending, "before").c_str(), 0666);
    }
    {
      const FullDisk disk(100);
      setUp.expectRefused(sphere, path, vtkErrorCode::OutOfDiskSpaceError, "File too large");
    }
    chmod(folder.file("").c_str(), 0555);
    {
      const OtherUser user;
      isAnother = user.isHere(folder.file(""));
      if (isAnother)
      {
        setUp.expectRefused(sphere, path, vtkErrorCode::CannotOpenFileError, "Permission denied");
      }
    }
    chmod(folder.file("").c_str(), 0755);
    for (const std::string& ending : setUp.Endings)
    {
      EXPECT_EQ(folder.read("a" + ending), "before") << ending;
    }
    EXPECT_EQ(folder.numberOfFiles(), setUp.Endings.size());
  }
  if (!isAnother)
  {
    GTEST_SKIP() << "Read-only folders were not tried: nothing is forbidden to root";
  }
}

TEST(SurfaceFileWriter, WritesStripsAsTriangles)
{
  const TemporaryFolder folder;
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(contract::RichSphere());
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  vtkNew<vtkConformalPLYWriter> writer;
  const contract::Reading read =
    contract::WrittenAndRead<vtkConformalPLYReader>(writer, stripper->GetOutput(), folder);
  contract::ExpectRead(read);
  EXPECT_EQ(read.Output->GetNumberOfPolys(), contract::RichSphere()->GetNumberOfPolys());
}

TEST(SurfaceFileWriter, LeavesOutStripsOfFewerThanThreePoints)
{
  const TemporaryFolder folder;
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(contract::RichSphere());
  stripper->Update();
  vtkPolyData* surface = stripper->GetOutput();
  const vtkIdType strips = surface->GetNumberOfStrips();
  surface->GetStrips()->InsertNextCell(0);
  surface->GetStrips()->InsertNextCell({ 0 });
  surface->GetStrips()->InsertNextCell({ 0, 1 });
  surface->GetCellData()->Initialize();
  ASSERT_EQ(surface->GetNumberOfStrips(), strips + 3);
  vtkNew<vtkConformalPLYWriter> writer;
  const contract::Reading read =
    contract::WrittenAndRead<vtkConformalPLYReader>(writer, surface, folder);
  contract::ExpectRead(read);
  EXPECT_EQ(read.Output->GetNumberOfPolys(), contract::RichSphere()->GetNumberOfPolys());
}
