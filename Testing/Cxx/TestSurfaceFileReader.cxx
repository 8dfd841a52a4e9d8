// What all readers do alike, tried with every one of them.
#include "vtkSurfaceFileReader.h"

#include "../CommaLocale.h"
#include "../TemporaryFolder.h"
#include "ReaderCases.h"
#include "ReaderContract.h"

#include "vtkCallbackCommand.h"

#include <algorithm>
#include <random>

#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

using contract::ExpectRefused;
using contract::Reading;

TEST(SurfaceFileReader, EveryReaderReadsItsFilesInEveryLocale)
{
  const TemporaryFolder folder;
  for (const contract::ReaderCase& test : contract::ReaderCases())
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
  const std::vector<contract::ReaderCase> cases = contract::ReaderCases();
  for (const contract::ReaderCase& owner : cases)
  {
    for (const std::string& file : owner.Files)
    {
      const std::string path = folder.write("a file", file);
      for (const contract::ReaderCase& reader : cases)
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
    for (const contract::ReaderCase& reader : cases)
    {
      EXPECT_EQ(reader.CanReadFile(path.c_str()), 0) << reader.Name << " and random file " << i;
    }
  }
}

TEST(SurfaceFileReader, EveryReaderRefusesWhatIsNoFile)
{
  const TemporaryFolder folder;
  for (const contract::ReaderCase& test : contract::ReaderCases())
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
  for (const contract::ReaderCase& test : contract::ReaderCases())
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
    reader->Modified();
    reader->Update();
    EXPECT_GT(reader->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(SurfaceFileReader, EveryReaderRecoversFromAnErrorAndRunsOnlyWhenModified)
{
  const TemporaryFolder folder;
  for (const contract::ReaderCase& test : contract::ReaderCases())
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
  for (const contract::ReaderCase& test : contract::ReaderCases())
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
  for (const contract::ReaderCase& test : contract::ReaderCases())
  {
    contract::ExpectPrints(test.Make(), "Controller");
  }
}
