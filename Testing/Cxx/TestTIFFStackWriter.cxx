#include "vtkTIFFStackWriter.h"

#include "../TemporaryFolder.h"
#include "FilterContract.h"
#include "vtkTIFFStackReader.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTIFFReader.h"

#include <limits>
#include <string>

namespace
{
vtkSmartPointer<vtkImageData> Volume()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 3, 2);
  image->SetSpacing(0.5, 0.25, 2.0);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Brightness");
  values->SetNumberOfValues(24);
  for (int i = 0; i < 24; ++i)
  {
    values->SetValue(i, 100.25 * i);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

// Write the volume, read it back, and compare the spacing.
vtkSmartPointer<vtkImageData> WrittenAndRead(const std::string& path, const char* unit)
{
  vtkNew<vtkTIFFStackWriter> writer;
  writer->SetInputData(Volume());
  writer->SetFileName(path.c_str());
  writer->SetUnit(unit);
  EXPECT_EQ(writer->Write(), 1);
  vtkNew<vtkTIFFStackReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_NEAR(reader->GetOutput()->GetSpacing()[a], Volume()->GetSpacing()[a], 1e-9);
  }
  return reader->GetOutput();
}
}

TEST(TIFFStackWriter, ImagesAreReadBackAndByVTK)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("stack.tif");
  const auto image = WrittenAndRead(path, "mm");
  ASSERT_EQ(image->GetNumberOfPoints(), 24);
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  vtkNew<vtkTIFFReader> other; // another program; its versions differ in the direction of rows
  other->SetFileName(path.c_str());
  other->Update();
  const bool isUp = other->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0) != 0.0;
  for (int i = 0; i < 24; ++i)
  {
    const int row = i / 4 % 3;
    EXPECT_EQ(image->GetPointData()->GetScalars()->GetComponent(i, 0), 100.25 * i);
    EXPECT_EQ(
      other->GetOutput()->GetScalarComponentAsDouble(i % 4, isUp ? 2 - row : row, i / 12, 0),
      100.25 * i);
  }
}

TEST(TIFFStackWriter, SpacingIsReadBackWithoutAUnit)
{
  const TemporaryFolder folder;
  WrittenAndRead(folder.file("stack.tif"), "");
}

TEST(TIFFStackWriter, ValuesBecomeWholeNumbersOrAreRefused)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("stack.tif");
  const vtkSmartPointer<vtkImageData> volume = Volume();
  vtkNew<vtkTIFFStackWriter> writer;
  writer->SetInputData(volume);
  writer->SetFileName(path.c_str());
  writer->SetPixelTypeToUInt16();
  writer->SetYAxisToUp();
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkTIFFStackReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetYAxisToUp();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetScalarType(), VTK_UNSIGNED_SHORT);
  EXPECT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(3, 0, 0, 0), 301.0);
  const std::string before = folder.read("stack.tif");
  const contract::Observed seen(writer);
  for (const double bad : { -1.0, 65536.0, std::numeric_limits<double>::quiet_NaN() })
  {
    volume->GetPointData()->GetScalars()->SetComponent(5, 0, bad);
    volume->Modified();
    EXPECT_EQ(writer->Write(), 0);
    EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
    seen.ExpectError("of pixel 5 is not finite, or out of the range");
  }
  EXPECT_EQ(folder.read("stack.tif"), before);
}

TEST(TIFFStackWriter, SlicesBecomeTimeSteps)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("movie.tif");
  vtkNew<vtkTIFFStackWriter> writer;
  writer->SetInputData(Volume());
  writer->SetFileName(path.c_str());
  writer->SetNumberOfFrames(2);
  writer->SetFrameInterval(30.0);
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkTIFFStackReader> reader;
  reader->SetFileName(path.c_str());
  for (const double time : { 0.0, 30.0 })
  {
    reader->UpdateTimeStep(time);
    EXPECT_EQ(reader->GetOutput()->GetDimensions()[2], 1);
    EXPECT_EQ(
      reader->GetOutput()->GetScalarComponentAsDouble(1, 0, 0, 0), 100.25 * (time > 0.0 ? 13 : 1));
  }
  const contract::Observed seen(writer);
  writer->SetNumberOfFrames(3);
  EXPECT_EQ(writer->Write(), 0);
  seen.ExpectError("2 slices, which is not a multiple of NumberOfFrames, 3");
  writer->SetNumberOfFrames(2);
  writer->SetFrameInterval(-1.0);
  EXPECT_EQ(writer->Write(), 0);
  seen.ExpectError("frame interval");
}

TEST(TIFFStackWriter, EmptyImagesAndOtherArraysAreRefused)
{
  const TemporaryFolder folder;
  vtkNew<vtkTIFFStackWriter> writer;
  const contract::Observed seen(writer);
  EXPECT_EQ(writer->Write(), 0);
  seen.ExpectError("input port 0 has no data to write");
  writer->SetFileName(folder.file("a.tif").c_str());
  vtkNew<vtkImageData> empty;
  writer->SetInputData(empty);
  EXPECT_EQ(writer->Write(), 0);
  seen.ExpectError("the image is empty");
  writer->SetInputData(Volume());
  writer->SetArrayName("Other");
  EXPECT_EQ(writer->Write(), 0);
  seen.ExpectError("no point array Other");
  EXPECT_EQ(folder.numberOfFiles(), 0u);
  for (const char* name :
    { "FileName", "ArrayName", "Unit", "PixelType", "YAxis", "NumberOfFrames", "FrameInterval" })
  {
    contract::ExpectPrints(writer, name);
  }
}
