#include "TIFF/TIFFStackParser.h"

#include "../Bytes/Mutations.h"
#include "TIFFSamples.h"

#include <gtest/gtest.h>

#include <cstring>

using conformal::ParseCode;
using conformal::TIFFStackOptions;
using conformal::TIFFStackResult;
using samples::TIFFOptions;

namespace
{
TIFFStackResult parsed(
  const std::string& bytes, const TIFFStackOptions& options = {}, const conformal::Run& run = {})
{
  return conformal::parseTIFFStack(
    [&](conformal::ByteReader& input)
    {
      input = conformal::ByteReader(bytes);
      return conformal::ParseStatus();
    },
    options, {}, run);
}

std::vector<std::uint16_t> valuesOf(const TIFFStackResult& result)
{
  std::vector<std::uint16_t> values(result.Stack.Values.size() / 2);
  std::memcpy(values.data(), result.Stack.Values.data(), result.Stack.Values.size());
  return values;
}

void expectRefused(const std::string& bytes, ParseCode code, const std::string& part)
{
  const TIFFStackResult result = parsed(bytes);
  EXPECT_EQ(result.Status.Code, code) << result.Status.text();
  EXPECT_NE(result.Status.text().find(part), std::string::npos) << result.Status.text();
  EXPECT_EQ(result.Stack.Values.size(), 0u);
}
}

TEST(TIFFStackParser, PagesOfAllKindsAreSlices)
{
  TIFFOptions kinds[5];
  kinds[1].IsBig = true;
  kinds[2].IsLong = true;
  kinds[3].IsDeflated = true;
  kinds[4] = { true, true, true };
  for (const TIFFOptions& kind : kinds)
  {
    const TIFFStackResult result = parsed(samples::TIFF(2, kind));
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_EQ(result.Stack.Info.Slices, 2u);
    EXPECT_EQ(result.Stack.Info.Type, conformal::ScalarType::UInt16);
    EXPECT_EQ(result.Stack.Info.Spacing[0], 1.0); // without a unit, the resolution is of printing
    EXPECT_EQ(valuesOf(result),
      std::vector<std::uint16_t>({ 0, 1, 2, 10, 11, 12, 100, 101, 102, 110, 111, 112 }));
  }
}

TEST(TIFFStackParser, DescriptionOfImageJHasChannelsFramesAndUnits)
{
  TIFFOptions options;
  options.Description = "ImageJ=1.54f\nimages=8\nchannels=2\nslices=2\nframes=2\nunit="
                        "\\u00B5m\nspacing=-3.5\nfinterval=2";
  TIFFStackOptions second;
  second.Frame = 1;
  second.FirstRowUp = true;
  const TIFFStackResult result = parsed(samples::TIFF(8, options), second);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  const conformal::TIFFStackInfo& info = result.Stack.Info;
  EXPECT_EQ(info.Channels, 2u);
  EXPECT_EQ(info.Slices, 2u);
  EXPECT_EQ(info.Frames, 2u);
  EXPECT_EQ(info.Unit, "micron");
  EXPECT_EQ(info.Spacing, (std::array<double, 3>{ 0.5, 0.5, 3.5 }));
  EXPECT_EQ(info.FrameInterval, 2.0);
  // Pages 4 to 7: two channels of the first slice, two of the second. The last row is first.
  const std::vector<std::uint16_t> values = valuesOf(result);
  ASSERT_EQ(values.size(), 24u);
  EXPECT_EQ(std::vector<std::uint16_t>(values.begin(), values.begin() + 4),
    std::vector<std::uint16_t>({ 410, 510, 411, 511 }));
  EXPECT_EQ(values[12], 610);
  EXPECT_EQ(values[23], 702);
}

TEST(TIFFStackParser, TimesAreInSeconds)
{
  for (const auto& [unit, seconds] : std::map<std::string, double>{
         { "", 1.0 }, { "min", 60.0 }, { "ms", 1e-3 }, { "hour", 3600.0 }, { "beats", 1.0 } })
  {
    TIFFOptions options;
    options.Description = "ImageJ=1.54f\nimages=4\nframes=4\nfinterval=0.5\n" +
      (unit.empty() ? "" : "tunit=" + unit + "\n");
    EXPECT_DOUBLE_EQ(parsed(samples::TIFF(4, options)).Stack.Info.FrameInterval, 0.5 * seconds)
      << unit;
  }
}

// Opening a file again for each tag, or reading a piece of it for each page, takes long.
TEST(TIFFStackParser, FilesThatCanSeekAreOpenedOnceAndReadInLargePieces)
{
  const std::string bytes = samples::TIFF(9000);
  std::size_t place = 0, opened = 0, jumps = 0;
  const TIFFStackResult result = conformal::parseTIFFStack(
    [&](conformal::ByteReader& input)
    {
      ++opened;
      place = 0;
      input = conformal::ByteReader(
        [&](char* buffer, std::size_t size)
        {
          const std::size_t got = bytes.copy(buffer, size, place);
          place += got;
          return got;
        },
        bytes.size(),
        [&](std::uint64_t offset)
        {
          ++jumps;
          place = offset;
        });
      return conformal::ParseStatus();
    });
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(opened, 1u);
  EXPECT_LT(jumps, 100u);
  EXPECT_EQ(valuesOf(result), valuesOf(parsed(bytes)));
}

// ImageJ writes stacks of more than 4 GB with one directory. Its other pages follow the first.
TEST(TIFFStackParser, PagesWithoutADirectoryFollowTheFirst)
{
  TIFFOptions options;
  options.Description = "ImageJ=1.54f\nimages=30\nslices=30\n";
  const TIFFStackResult cut = parsed(samples::TIFF(1, options));
  EXPECT_EQ(cut.Status.Code, ParseCode::PrematureEnd) << cut.Status.text();
  options.Description = "ImageJ=1.54f\nimages=3\nslices=3\n";
  const TIFFStackResult result = parsed(samples::TIFF(1, options));
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(result.Stack.Info.Slices, 3u);
  EXPECT_EQ(valuesOf(result).size(), 18u);
}

// A small file must not make the header large: readers list all time steps.
TEST(TIFFStackParser, HeadersAreRefusedIfTheFileIsTooSmallForTheirPages)
{
  TIFFStackOptions header;
  header.HeaderOnly = true;
  TIFFOptions options;
  options.Description = "ImageJ=1\nimages=1000000000\nframes=1000000000\n";
  const TIFFStackResult many = parsed(samples::TIFF(1, options), header);
  EXPECT_EQ(many.Status.Code, ParseCode::PrematureEnd);
  EXPECT_NE(many.Status.text().find("1000000000 pages"), std::string::npos) << many.Status.text();
  options.Description = "ImageJ=1\nimages=3\nframes=3\n";
  EXPECT_EQ(parsed(samples::TIFF(1, options), header).Stack.Info.Frames, 3u);
  options.IsDeflated = true;
  const TIFFStackResult packed = parsed(samples::TIFF(1, options), header);
  EXPECT_NE(packed.Status.text().find("compressed"), std::string::npos) << packed.Status.text();
}

TEST(TIFFStackParser, UnreadableFilesAreRefusedWithTheReason)
{
  const std::string good = samples::TIFF(2);
  expectRefused("", ParseCode::PrematureEnd, "empty");
  expectRefused("II*", ParseCode::UnrecognizedType, "no TIFF");
  expectRefused("ply\nformat", ParseCode::UnrecognizedType, "no TIFF");
  expectRefused(good.substr(0, good.size() - 60), ParseCode::PrematureEnd, "expected 12 tags");
  const auto with = [](int tag, std::uint32_t value)
  {
    TIFFOptions options;
    options.Others = { { tag, value } };
    return samples::TIFF(1, options);
  };
  expectRefused(with(259, 5), ParseCode::Malformed, "compression 5");
  expectRefused(with(322, 16), ParseCode::Malformed, "tiles");
  expectRefused(with(274, 6), ParseCode::Malformed, "turned");
  expectRefused(with(258, 12), ParseCode::Malformed, "12 bits");
  TIFFOptions high;
  high.Height = 2000000;
  expectRefused(samples::TIFF(1, high), ParseCode::PrematureEnd, "");
  high.IsDeflated = true;
  expectRefused(samples::TIFF(1, high), ParseCode::PrematureEnd, "too small");
  TIFFOptions wrong;
  wrong.Description = "ImageJ=1\nimages=4\nchannels=3\n";
  expectRefused(samples::TIFF(4, wrong), ParseCode::Malformed, "3 channels");
  TIFFOptions microscopy;
  microscopy.Description = "<?xml version=\"1.0\"?><OME><Image><Pixels SizeC=\"2\"/></Image></OME>";
  expectRefused(samples::TIFF(4, microscopy), ParseCode::Malformed, "OME-TIFF");
  EXPECT_TRUE(parsed(samples::TIFF(1, microscopy)).Status.ok());
  std::string loop = samples::TIFF(1);
  loop.replace(loop.size() - 4, 4, loop.substr(4, 4));
  expectRefused(loop, ParseCode::Malformed, "loop");
}

// The time and memory of a file are limited by its size, although pages can share their arrays.
TEST(TIFFStackParser, PagesThatShareLargeArraysAreRefused)
{
  TIFFOptions options;
  options.Strips = 2;
  EXPECT_TRUE(parsed(samples::TIFF(100, options), { 0, false, true }).Status.ok());
  options.Strips = 1000; // fewer bytes than the file has, but more on all pages
  expectRefused(samples::TIFF(100, options), ParseCode::Malformed, "exceed the size of the file");
  options = {};
  options.HasTagTwice = true;
  expectRefused(samples::TIFF(1, options), ParseCode::Malformed, "found tag 256 twice");
}

// Numbers of tags that exceed all integers are no undefined conversions.
TEST(TIFFStackParser, HugeNumbersOfTagsAreRefused)
{
  for (const int tag : { 256, 258, 259, 273, 277 })
  {
    TIFFOptions options;
    options.IsLong = true;
    options.Huge = tag;
    EXPECT_FALSE(parsed(samples::TIFF(1, options)).Status.ok()) << tag;
  }
}

TEST(TIFFStackParser, ReadingDirectoriesStopsWhenAsked)
{
  std::size_t calls = 0;
  const auto stop = [&](double)
  {
    ++calls;
    return false;
  };
  TIFFStackOptions header;
  header.HeaderOnly = true;
  EXPECT_EQ(parsed(samples::TIFF(300), header, { {}, stop }).Status.Code, ParseCode::Aborted);
  EXPECT_EQ(calls, 1u);
}

TEST(TIFFStackParser, ChangedFilesAreReadOrRefused)
{
  const std::vector<std::string> files = samples::TIFFFiles();
  int read = 0;
  for (std::uint32_t seed = 0; seed < 4000; ++seed)
  {
    const TIFFStackResult result = parsed(samples::Mutated(files[seed % files.size()], seed));
    const conformal::TIFFStackInfo& info = result.Stack.Info;
    ASSERT_EQ(result.Stack.Values.size(),
      result.Status.ok()
        ? info.pixelsPerPage() * info.Channels * info.Slices * conformal::sizeOf(info.Type)
        : 0);
    read += result.Status.ok();
  }
  EXPECT_GT(read, 100);
  EXPECT_LT(read, 3900);
}

TEST(TIFFStackParser, StopsWhenAsked)
{
  const TIFFStackResult result =
    parsed(samples::TIFF(4), {}, { {}, [](double done) { return done < 0.5; } });
  EXPECT_EQ(result.Status.Code, ParseCode::Aborted);
  EXPECT_EQ(result.Stack.Values.size(), 0u);
}
