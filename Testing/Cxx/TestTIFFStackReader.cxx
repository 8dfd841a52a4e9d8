#include "vtkTIFFStackReader.h"

#include "../Formats/Bytes/Mutations.h"
#include "../Formats/TIFF/TIFFSamples.h"
#include "../TemporaryFolder.h"
#include "FilterContract.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTIFFReader.h"

#include <string>

namespace
{
struct StackReading
{
  explicit StackReading(const std::string& path)
    : Seen(this->Reader)
  {
    this->Reader->SetFileName(path.c_str());
    this->Reader->Update();
  }
  vtkNew<vtkTIFFStackReader> Reader;
  contract::Observed Seen;
};

std::string Movie()
{
  samples::TIFFOptions options;
  options.Description =
    "ImageJ=1.54f\nimages=6\nchannels=2\nframes=3\nunit=micron\nfinterval=2.5\n";
  return samples::TIFF(6, options);
}
}

TEST(TIFFStackReader, ChannelsAreComponentsAndFramesAreTimeSteps)
{
  const TemporaryFolder folder;
  vtkNew<vtkTIFFStackReader> reader;
  reader->SetFileName(folder.write("movie.tif", Movie()).c_str());
  reader->UpdateInformation();
  vtkInformation* info = reader->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 3);
  EXPECT_EQ(info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[2], 5.0);
  for (const auto& [time, frame] : { std::pair(0.0, 0), { 2.5, 1 }, { 4.9, 1 }, { 9.0, 2 } })
  {
    reader->UpdateTimeStep(time);
    vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
    ASSERT_EQ(values->GetNumberOfComponents(), 2);
    EXPECT_EQ(values->GetComponent(4, 1), 200 * frame + 111) << time; // row 1, column 1
    EXPECT_EQ(
      reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 2.5 * frame);
  }
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[0], 0.5);
  auto* unit =
    vtkStringArray::SafeDownCast(reader->GetOutput()->GetFieldData()->GetAbstractArray("Unit"));
  ASSERT_NE(unit, nullptr);
  EXPECT_EQ(unit->GetValue(0), "micron");
  contract::ExpectPrints(reader, "FileName");
  contract::ExpectPrints(reader, "YAxis");
}

// VTK's reader is another program. Versions of VTK differ in the direction of rows.
TEST(TIFFStackReader, AgreesWithTheReaderOfVTK)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("stack.tif", samples::TIFF(4));
  vtkNew<vtkTIFFReader> other;
  other->SetFileName(path.c_str());
  other->Update();
  StackReading reading(path);
  EXPECT_FALSE(reading.Seen.Error() || reading.Seen.Warning());
  EXPECT_EQ(reading.Reader->GetOutput()->GetScalarComponentAsDouble(2, 1, 3, 0), 312.0);
  const auto differences = [&]()
  {
    int count = 0;
    for (int i = 0; i < 24; ++i)
    {
      count += reading.Reader->GetOutput()->GetScalarComponentAsDouble(i % 3, i / 3 % 2, i / 6,
                 0) != other->GetOutput()->GetScalarComponentAsDouble(i % 3, i / 3 % 2, i / 6, 0);
    }
    return count;
  };
  const int down = differences();
  reading.Reader->SetYAxisToUp();
  reading.Reader->Update();
  EXPECT_EQ(reading.Reader->GetOutput()->GetScalarComponentAsDouble(2, 0, 3, 0), 312.0);
  const int up = differences();
  EXPECT_TRUE((down == 0 && up == 24) || (down == 24 && up == 0)) << down << " " << up;
}

TEST(TIFFStackReader, BadFilesAreRefused)
{
  const TemporaryFolder folder;
  const auto expectRefused = [](const std::string& path, unsigned long code)
  {
    const StackReading reading(path);
    EXPECT_TRUE(reading.Seen.Error());
    EXPECT_EQ(reading.Reader->GetErrorCode(), code) << reading.Seen.ErrorMessage();
    EXPECT_EQ(reading.Reader->GetOutput()->GetNumberOfPoints(), 0);
  };
  expectRefused("", vtkErrorCode::NoFileNameError);
  expectRefused(folder.file("missing.tif"), vtkErrorCode::FileNotFoundError);
  expectRefused(folder.file(""), vtkErrorCode::CannotOpenFileError);
  expectRefused(folder.write("empty.tif", ""), vtkErrorCode::PrematureEndOfFileError);
  expectRefused(folder.write("a.tif", "GIF89a??"), vtkErrorCode::UnrecognizedFileTypeError);
  const std::string good = samples::TIFF(2);
  expectRefused(folder.write("cut.tif", good.substr(0, 50)), vtkErrorCode::PrematureEndOfFileError);
  EXPECT_EQ(vtkTIFFStackReader::CanReadFile(folder.write("b.tif", good).c_str()), 1);
  EXPECT_EQ(vtkTIFFStackReader::CanReadFile(folder.file("a.tif").c_str()), 0);
  EXPECT_EQ(vtkTIFFStackReader::CanReadFile(nullptr), 0);
}

TEST(TIFFStackReader, ChangedFilesEndInAnErrorOrInAnImage)
{
  const TemporaryFolder folder;
  const std::vector<std::string> files = samples::TIFFFiles();
  int read = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed)
  {
    const StackReading reading(
      folder.write("file", samples::Mutated(files[seed % files.size()], seed)));
    const bool isRead = reading.Reader->GetErrorCode() == vtkErrorCode::NoError;
    ASSERT_EQ(isRead, !reading.Seen.Error()) << seed;
    ASSERT_EQ(reading.Reader->GetOutput()->GetNumberOfPoints() > 0, isRead) << seed;
    read += isRead;
  }
  EXPECT_GT(read, 10);
}

TEST(TIFFStackReader, StopsWhenAsked)
{
  const TemporaryFolder folder;
  StackReading reading(folder.write("stack.tif", samples::TIFF(4)));
  contract::ExpectStopsWhenAsked(reading.Reader);
}
