#include "vtkSPHARMCoefficientReader.h"

#include "../Cases/ReaderCase.h"
#include "../Formats/Bytes/Mutations.h"
#include "../Formats/SPHARM/SPHARMSamples.h"
#include "../TemporaryFolder.h"
#include "FilterContract.h"
#include "vtkSurfaceHarmonicsSource.h"

#include "vtkErrorCode.h"
#include "vtkMath.h"
#include "vtkTable.h"

#include <boost/math/special_functions/spherical_harmonic.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
struct TableReading
{
  explicit TableReading(const std::string& path)
    : Seen(this->Reader)
  {
    this->Reader->SetFileName(path.c_str());
    this->Reader->Update();
  }
  vtkNew<vtkSPHARMCoefficientReader> Reader;
  contract::Observed Seen;
};

void ExpectRefused(const TableReading& reading, unsigned long code, const std::string& part)
{
  EXPECT_EQ(reading.Reader->GetErrorCode(), code) << reading.Seen.ErrorMessage();
  reading.Seen.ExpectError(part);
  EXPECT_EQ(reading.Reader->GetOutput()->GetNumberOfColumns(), 0);
}
}

// SPHARM-PDM's sum, with P_lm and its phase by Boost, and a file as its programs print it.
TEST(SPHARMCoefficientReader, SurfaceIsTheOneThatTheFileSays)
{
  constexpr int degree = 6;
  std::vector<std::array<double, 3>> numbers;
  std::string text = "{ 49,";
  for (int i = 0; i < 49; ++i)
  {
    numbers.push_back({ 0.25 * (i % 7) - 0.5, 0.125 * (i % 5), 1.0 / 64.0 * i });
    text += (i > 0 ? ",\n{" : "{") + std::to_string(numbers[i][0]) + ", " +
      std::to_string(numbers[i][1]) + ", " + std::to_string(numbers[i][2]) + "}";
  }
  const TemporaryFolder folder;
  const TableReading reading(folder.write("shape.coef", text + "}"));
  EXPECT_FALSE(reading.Seen.Error()) << reading.Seen.ErrorMessage();
  vtkNew<vtkSurfaceHarmonicsSource> source;
  source->SetInputConnection(reading.Reader->GetOutputPort());
  source->SetFrequency(4);
  source->Update();
  vtkPolyData* surface = source->GetOutput();
  ASSERT_EQ(surface->GetNumberOfPoints(), 162);
  for (vtkIdType i = 0; i < 162; ++i)
  {
    const double* n = surface->GetPointData()->GetArray("SpherePosition")->GetTuple3(i);
    const double theta = std::acos(n[2]), phi = std::atan2(n[1], n[0]);
    double expected[3] = { 0.0, 0.0, 0.0 };
    for (unsigned int l = 0; l <= degree; ++l)
    {
      for (unsigned int m = 0; m <= l; ++m)
      {
        for (int c = 0; c < 3; ++c)
        {
          expected[c] += numbers[l * l + (m == 0 ? 0 : 2 * m - 1)][c] *
            boost::math::spherical_harmonic_r(l, static_cast<int>(m), theta, phi);
          expected[c] += m == 0 ? 0.0
                                : numbers[l * l + 2 * m][c] *
              boost::math::spherical_harmonic_i(l, static_cast<int>(m), theta, phi);
        }
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(surface->GetPoint(i)[c], expected[c], 1e-12);
    }
  }
}

TEST(SPHARMCoefficientReader, TableHasItsColumns)
{
  const TemporaryFolder folder;
  const TableReading reading(folder.write("shape.coef", samples::SPHARMCoefficients()));
  EXPECT_FALSE(reading.Seen.Error() || reading.Seen.Warning());
  vtkTable* table = reading.Reader->GetOutput();
  EXPECT_EQ(table->GetNumberOfColumns(), 5);
  ASSERT_EQ(table->GetNumberOfRows(), 4);
  EXPECT_EQ(table->GetValueByName(1, "Degree").ToInt(), 1);
  EXPECT_EQ(table->GetValueByName(1, "Order").ToInt(), -1);
  EXPECT_EQ(table->GetValueByName(2, "Z").ToDouble(), 3.25);
  EXPECT_NEAR(table->GetValueByName(3, "X").ToDouble(), 4.0 / std::sqrt(2.0), 1e-15);
  contract::ExpectPrints(reading.Reader, "FileName");
}

TEST(SPHARMCoefficientReader, BadFilesAreRefused)
{
  const TemporaryFolder folder;
  ExpectRefused(TableReading(""), vtkErrorCode::NoFileNameError, "FileName is not set");
  ExpectRefused(TableReading(folder.file("missing.coef")), vtkErrorCode::FileNotFoundError, "");
  ExpectRefused(TableReading(folder.file("")), vtkErrorCode::CannotOpenFileError, "");
  ExpectRefused(
    TableReading(folder.write("empty.coef", "")), vtkErrorCode::PrematureEndOfFileError, "line 1");
  ExpectRefused(TableReading(folder.write("cut.coef", samples::SPHARMCoefficients().substr(0, 60))),
    vtkErrorCode::PrematureEndOfFileError, "line 2: the file ends");
  ExpectRefused(TableReading(folder.write("many.coef", "{ 1050625,{1,2,3}}")),
    vtkErrorCode::PrematureEndOfFileError, "coefficients");
  for (const std::string& file : cases::FilesOfNoReader())
  {
    const std::string path = folder.write("file", file);
    EXPECT_EQ(vtkSPHARMCoefficientReader::CanReadFile(path.c_str()), 0);
    EXPECT_TRUE(TableReading(path).Seen.Error());
  }
  for (const std::string& file : samples::BadSPHARMCoefficientFiles())
  {
    const TableReading reading(folder.write("file", file));
    EXPECT_TRUE(reading.Seen.Error()) << file;
    EXPECT_NE(reading.Seen.ErrorMessage().find("line "), std::string::npos) << file;
    EXPECT_EQ(reading.Reader->GetOutput()->GetNumberOfColumns(), 0);
  }
}

TEST(SPHARMCoefficientReader, DegreesTooHighAreRefused)
{
  std::string text = "{ 1052676,{0,0,0}"; // 1026^2
  for (int i = 1; i < 1052676; ++i)
  {
    text += ",{0,0,0}";
  }
  const TemporaryFolder folder;
  ExpectRefused(TableReading(folder.write("high.coef", text + "}")), vtkErrorCode::UserError,
    "the coefficients have degree 1025, but the highest is 1024");
}

TEST(SPHARMCoefficientReader, FilesOfOthersAreNotTaken)
{
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    for (const std::string& file : test.Files)
    {
      EXPECT_EQ(vtkSPHARMCoefficientReader::CanReadFile(folder.write("file", file).c_str()), 0)
        << test.Name;
    }
    for (const std::string& file : samples::SPHARMCoefficientFiles())
    {
      const std::string path = folder.write("file", file);
      EXPECT_EQ(test.CanReadFile(path.c_str()), 0) << test.Name;
      EXPECT_EQ(vtkSPHARMCoefficientReader::CanReadFile(path.c_str()), 1);
    }
  }
}

TEST(SPHARMCoefficientReader, MutatedFilesEndInAnErrorOrInWholeTables)
{
  const TemporaryFolder folder;
  const std::vector<std::string> files = samples::SPHARMCoefficientFiles();
  int read = 0;
  for (std::uint32_t seed = 0; seed < 500; ++seed)
  {
    const TableReading reading(
      folder.write("file", samples::Mutated(files[seed % files.size()], seed)));
    vtkTable* table = reading.Reader->GetOutput();
    const bool isRead = reading.Reader->GetErrorCode() == vtkErrorCode::NoError;
    ASSERT_EQ(isRead, !reading.Seen.Error()) << seed;
    ASSERT_EQ(table->GetNumberOfColumns(), isRead ? 5 : 0) << seed;
    for (const char* name : { "X", "Y", "Z" })
    {
      if (isRead)
      {
        contract::ExpectArray(table->GetRowData(), name, VTK_DOUBLE, 1, table->GetNumberOfRows());
      }
    }
    read += isRead ? 1 : 0;
  }
  EXPECT_GT(read, 10);
  EXPECT_LT(read, 490);
}

TEST(SPHARMCoefficientReader, StopsWhenAsked)
{
  const TemporaryFolder folder;
  vtkNew<vtkSPHARMCoefficientReader> reader;
  reader->SetFileName(folder.write("file", samples::SPHARMCoefficientFiles()[1]).c_str());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  const contract::Observed seen(reader);
  reader->Update();
  EXPECT_FALSE(seen.Error());
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfColumns(), 0);
}
