// What all readers do alike, tried with every one of them.
#include "vtkSurfaceFileReader.h"

#include "../AddressSanitizer.h"
#include "../Cases/ReaderCase.h"
#include "../CommaLocale.h"
#include "../TemporaryFolder.h"
#include "ReaderContract.h"

#include "vtkCallbackCommand.h"
#include "vtkConformalPLYReader.h"
#include "vtkFreeSurferReader.h"
#include "vtkGIFTIReader.h"
#include "vtkPCDReader.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <random>

#ifndef _WIN32
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

using contract::ExpectRefused;
using contract::Reading;

namespace
{
// While it lives, this process has no more than so many bytes of addresses.
class MemoryLimit
{
public:
  explicit MemoryLimit([[maybe_unused]] std::uint64_t bytes)
  {
#ifndef _WIN32
    getrlimit(RLIMIT_AS, &this->Before);
    rlimit limit = this->Before;
    if (!hasAddressSanitizer)
    {
      limit.rlim_cur = std::min<rlim_t>(bytes, this->Before.rlim_max);
    }
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit()
  {
    setrlimit(RLIMIT_AS, &this->Before);
  }

private:
  rlimit Before = {};
#else
  }
#endif
};

std::string PLYOf(int properties)
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                     "property float y\nproperty float z\n";
  std::string values = "1 2 3";
  for (int i = 0; i < properties; ++i)
  {
    text += "property float p" + std::to_string(i) + "\n";
    values += " " + std::to_string(i);
  }
  return text + "end_header\n" + values + "\n";
}
}

TEST(SurfaceFileReader, EveryReaderRefusesAnEndlessFile)
{
#ifndef _WIN32 // where the file would not be sparse
  const TemporaryFolder folder;
  const std::string path = folder.write("endless", "");
  std::filesystem::resize_file(std::filesystem::u8path(path), std::uintmax_t(16) << 30);
  const MemoryLimit limit(std::uint64_t(4) << 30);
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    EXPECT_EQ(test.CanReadFile(path.c_str()), 0);
    const Reading reading(test.Make(), path);
    const unsigned long code = reading.Reader->GetErrorCode();
    EXPECT_TRUE(
      code == vtkErrorCode::FileFormatError || code == vtkErrorCode::UnrecognizedFileTypeError)
      << code << reading.Seen.ErrorMessage();
    EXPECT_EQ(reading.Output->GetNumberOfPoints(), 0);
  }
#endif
}

TEST(SurfaceFileReader, EveryReaderNamesTheFilesItReads)
{
  using Names = std::vector<std::string>;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    const vtkSmartPointer<vtkSurfaceFileReader> reader = test.Make();
    EXPECT_EQ(contract::ReadFileNames(reader), Names());
    reader->SetFileName("no such file");
    const vtkMTimeType time = reader->GetMTime();
    EXPECT_EQ(contract::ReadFileNames(reader).front(), "no such file");
    EXPECT_EQ(contract::ReadFileNames(reader), contract::ReadFileNames(reader));
    EXPECT_EQ(reader->GetMTime(), time);
    reader->SetFileName(nullptr);
    EXPECT_EQ(contract::ReadFileNames(reader), Names());
  }
  vtkNew<vtkFreeSurferReader> surfer;
  surfer->SetFileName("lh.white");
  EXPECT_EQ(contract::ReadFileNames(surfer), Names{ "lh.white" });
  surfer->SetCurvatureFileName("lh.curv");
  EXPECT_EQ(contract::ReadFileNames(surfer), (Names{ "lh.white", "lh.curv" }));
  surfer->SetSphereFileName("lh.sphere");
  EXPECT_EQ(contract::ReadFileNames(surfer), (Names{ "lh.white", "lh.sphere", "lh.curv" }));
  vtkNew<vtkGIFTIReader> gifti;
  gifti->SetFileName("a.surf.gii");
  gifti->SetSphereFileName("b.surf.gii");
  gifti->SetShapeFileName("c.shape.gii");
  EXPECT_EQ(contract::ReadFileNames(gifti), (Names{ "a.surf.gii", "b.surf.gii", "c.shape.gii" }));
}

// 16 times as many arrays take 16 times as long, or 256 times where each is compared with all.
TEST(SurfaceFileReader, ArraysCostInProportionToTheirNumber)
{
  const TemporaryFolder folder;
  const auto secondsOf = [&](int properties)
  {
    const std::string path = folder.write("a.ply", PLYOf(properties));
    double best = std::numeric_limits<double>::max();
    for (int i = 0; i < 3; ++i)
    {
      const std::clock_t begin = std::clock(); // of this process, whatever else the machine does
      const Reading reading = contract::Read<vtkConformalPLYReader>(path);
      best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      EXPECT_EQ(reading.Output->GetPointData()->GetNumberOfArrays(), properties);
    }
    return best;
  };
  const double few = secondsOf(3000);
  EXPECT_LT(secondsOf(48000), 64.0 * std::max(few, 1e-3));
}

TEST(SurfaceFileReader, ColorsOfBothKindsAreKept)
{
  const TemporaryFolder folder;
  const Reading reading = contract::Read<vtkPCDReader>(folder.write("a.pcd",
    "FIELDS x y z rgb rgba\nTYPE F F F U U\nSIZE 4 4 4 4 4\nPOINTS 1\nDATA ascii\n"
    "1 2 3 66051 66051\n"));
  contract::ExpectRead(reading);
  vtkPointData* data = reading.Output->GetPointData();
  contract::ExpectArray(data, "RGB", VTK_UNSIGNED_CHAR, 3, 1);
  contract::ExpectArray(data, "RGBA", VTK_UNSIGNED_CHAR, 4, 1);
  EXPECT_EQ(data->GetScalars(), data->GetArray("RGBA"));
}

TEST(SurfaceFileReader, EveryReaderReadsItsFilesInEveryLocale)
{
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    folder.write(test.Beside);
    ASSERT_FALSE(test.Files.empty());
    for (const std::string& file : test.Files)
    {
      const std::string path = folder.write("a file", file);
      const Reading expected(test.Make(), path);
      contract::ExpectRead(expected);
      EXPECT_GT(expected.Output->GetNumberOfPoints(), 0);
      EXPECT_GT(expected.Output->GetNumberOfCells(), 0);
      const CommaLocale locale;
      const Reading reading(test.Make(), path);
      contract::ExpectRead(reading);
      ASSERT_EQ(reading.Output->GetNumberOfPoints(), expected.Output->GetNumberOfPoints());
      for (vtkIdType i = 0; i < reading.Output->GetNumberOfPoints(); ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_EQ(reading.Output->GetPoint(i)[c], expected.Output->GetPoint(i)[c]);
        }
      }
    }
  }
}

TEST(SurfaceFileReader, EveryReaderKnowsItsOwnFilesAndNoOthers)
{
  const TemporaryFolder folder;
  const std::vector<cases::ReaderCase>& readers = cases::AllReaders();
  for (const cases::ReaderCase& owner : readers)
  {
    folder.write(owner.Beside);
    for (const std::string& file : owner.Files)
    {
      const std::string path = folder.write("a file", file);
      for (const cases::ReaderCase& reader : readers)
      {
        EXPECT_EQ(reader.CanReadFile(path.c_str()), reader.Name == owner.Name ? 1 : 0)
          << reader.Name << " and a file of " << owner.Name << ":\n"
          << file.substr(0, 300);
      }
    }
  }
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i)
  {
    std::string bytes(random() % 2000, '\0');
    const bool isText = i % 2 == 0;
    for (char& byte : bytes)
    {
      byte = static_cast<char>(isText ? ' ' + random() % 95 : random());
    }
    const std::string path = folder.write("a file", bytes);
    for (const cases::ReaderCase& reader : readers)
    {
      EXPECT_EQ(reader.CanReadFile(path.c_str()), 0) << reader.Name << " and random file " << i;
    }
  }
}

TEST(SurfaceFileReader, EveryReaderRefusesWhatIsNoFile)
{
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    folder.write(test.Beside);
    const auto refuse = [&](const std::string& path, unsigned long code, const char* part)
    {
      ExpectRefused(Reading(test.Make(), path), code, part);
      EXPECT_EQ(test.CanReadFile(path.c_str()), 0);
    };
    refuse("", vtkErrorCode::NoFileNameError, "FileName");
    refuse(folder.file("missing"), vtkErrorCode::FileNotFoundError, "no such file");
    refuse(folder.file(""), vtkErrorCode::CannotOpenFileError, "regular");
    refuse(folder.write("empty", ""), vtkErrorCode::PrematureEndOfFileError, "empty");
    refuse(folder.write("other", "solid cube\nfacet normal 0 0 1\n"),
      vtkErrorCode::UnrecognizedFileTypeError, "expected");
#ifndef _WIN32
    mkfifo(folder.file("pipe").c_str(), 0600);
    refuse(folder.file("pipe"), vtkErrorCode::CannotOpenFileError, "regular");
    refuse("/dev/zero", vtkErrorCode::CannotOpenFileError, "regular");
    if (geteuid() != 0) // nothing is forbidden to root
    {
      const std::string secret = folder.write("secret", test.Files[0]);
      std::filesystem::permissions(secret, std::filesystem::perms::none);
      refuse(secret, vtkErrorCode::CannotOpenFileError, "opened");
    }
#endif
    EXPECT_EQ(test.CanReadFile(nullptr), 0);
    const vtkSmartPointer<vtkSurfaceFileReader> reader = test.Make();
    const contract::Observed observed(reader);
    reader->Update();
    EXPECT_TRUE(observed.Error());
    EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
  }
}

TEST(SurfaceFileReader, EveryReaderStopsWhenAskedWithoutAWord)
{
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    folder.write(test.Beside);
    const vtkSmartPointer<vtkSurfaceFileReader> reader = test.Make();
    const contract::Observed observed(reader);
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
    const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, abort);
    reader->SetFileName(folder.write("a file", test.Files[0]).c_str());
    reader->Update();
    EXPECT_FALSE(observed.Error() || observed.Warning());
    EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
    reader->RemoveObserver(tag);
    reader->SetAbortExecute(0); // later versions of VTK keep it
    reader->Update();
    EXPECT_GT(reader->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(SurfaceFileReader, EveryReaderRecoversFromAnErrorAndRunsOnlyWhenModified)
{
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    folder.write(test.Beside);
    const vtkSmartPointer<vtkSurfaceFileReader> reader = test.Make();
    contract::Observed observed(reader);
    reader->SetFileName(folder.file("missing").c_str());
    reader->Update();
    EXPECT_TRUE(observed.Error());
    observed.Clear();
    reader->SetFileName(folder.write("a file", test.Files[0]).c_str());
    contract::ExpectRunsOnlyWhenModified(reader, [&]() { reader->Modified(); });
    EXPECT_FALSE(observed.Error());
    EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    contract::ExpectPrints(reader, "FileName");
    EXPECT_STRNE(reader->GetFileExtensions(), "");
    EXPECT_STRNE(reader->GetDescriptiveName(), "");
  }
}

TEST(SurfaceFileReader, PiecesOfEveryReaderMakeTheWhole)
{
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    folder.write(test.Beside);
    for (const std::string& file : test.Files)
    {
      const std::string path = folder.write("a file", file);
      const Reading whole(test.Make(), path);
      for (const int count : { 2, 5 })
      {
        vtkIdType points = 0, cells = 0;
        for (int number = 0; number < count; ++number)
        {
          const vtkSmartPointer<vtkSurfaceFileReader> reader = test.Make();
          contract::Observed observed(reader);
          reader->SetFileName(path.c_str());
          reader->UpdatePiece(number, count, 0);
          EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
          vtkPolyData* piece = reader->GetOutput();
          for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i, ++points)
          {
            ASSERT_LT(points, whole.Output->GetNumberOfPoints());
            double x[3], y[3];
            piece->GetPoint(i, x);
            whole.Output->GetPoint(points, y);
            ASSERT_TRUE(std::equal(x, x + 3, y));
          }
          cells += piece->GetNumberOfCells();
        }
        EXPECT_EQ(points, whole.Output->GetNumberOfPoints());
        EXPECT_EQ(cells, whole.Output->GetNumberOfCells());
      }
    }
  }
}

TEST(SurfaceFileReader, EveryReaderPrintsItsController)
{
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    contract::ExpectPrints(test.Make(), "Controller");
  }
}
