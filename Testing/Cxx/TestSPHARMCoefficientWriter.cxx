#include "vtkSPHARMCoefficientWriter.h"

#include "../Formats/SPHARM/SPHARMSamples.h"
#include "../TemporaryFolder.h"
#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkSPHARMCoefficientReader.h"
#include "vtkSurfaceHarmonics.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkTable.h"

#include <cmath>
#include <limits>
#include <string>

TEST(SPHARMCoefficientWriter, HarmonicsAreReadBackToFifteenDigits)
{
  vtkNew<vtkSurfaceHarmonics> harmonics;
  harmonics->SetInputData(fixtures::Ellipsoid(12));
  harmonics->SetDegree(9);
  harmonics->Update();
  const TemporaryFolder folder;
  const std::string path = folder.file("shape.coef");
  vtkNew<vtkSPHARMCoefficientWriter> writer;
  writer->SetInputConnection(harmonics->GetOutputPort(1));
  writer->SetFileName(path.c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkSPHARMCoefficientReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkTable *written = harmonics->GetCoefficients(), *read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfRows(), 100);
  for (vtkIdType row = 0; row < 100; ++row)
  {
    for (const char* name : { "Degree", "Order", "X", "Y", "Z" })
    {
      const double value = written->GetValueByName(row, name).ToDouble();
      EXPECT_NEAR(read->GetValueByName(row, name).ToDouble(), value, 1e-14 * std::abs(value));
    }
  }
  // What was read is written the same, to the last digit.
  const std::string again = folder.file("again.coef");
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(again.c_str());
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(folder.read("again.coef"), folder.read("shape.coef"));
}

TEST(SPHARMCoefficientWriter, BadTablesAreRefusedAndOldFilesKept)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("shape.coef", samples::SPHARMCoefficients());
  vtkNew<vtkSPHARMCoefficientReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkNew<vtkTable> table;
  table->DeepCopy(reader->GetOutput());
  vtkNew<vtkSPHARMCoefficientWriter> writer;
  writer->SetInputData(table);
  writer->SetFileName(path.c_str());
  const contract::Observed seen(writer);
  const auto expectRefused = [&](const std::string& why)
  {
    EXPECT_EQ(writer->Write(), 0);
    EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
    seen.ExpectError(why);
    EXPECT_EQ(folder.read("shape.coef"), samples::SPHARMCoefficients());
  };
  vtkDoubleArray::SafeDownCast(table->GetColumnByName("X"))
    ->SetValue(2, std::numeric_limits<double>::quiet_NaN());
  expectRefused("the column \"X\" is not finite in row 2");
  vtkDoubleArray::SafeDownCast(table->GetColumnByName("X"))->SetValue(2, 1.0);
  vtkDoubleArray::SafeDownCast(table->GetColumnByName("X"))->SetValue(1, 1.7e308);
  expectRefused("a coefficient is too large");
  for (const char* name : { "Degree", "Y" })
  {
    vtkAbstractArray* column = table->GetColumnByName(name);
    column->SetNumberOfTuples(3);
    expectRefused("the column \"" + std::string(name) + "\" has 3 values for 4 rows");
    column->SetNumberOfTuples(4);
  }
  table->RemoveColumnByName("X");
  expectRefused("the table of coefficients has no column \"X\"");
}

TEST(SPHARMCoefficientWriter, AsksForANameAndATable)
{
  vtkNew<vtkSPHARMCoefficientWriter> writer;
  const contract::Observed seen(writer);
  EXPECT_EQ(writer->Write(), 0);
  seen.ExpectError("input port 0 has no data to write");
  vtkNew<vtkTable> table;
  writer->SetInputData(table);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
  contract::ExpectPrints(writer, "FileName");
}
