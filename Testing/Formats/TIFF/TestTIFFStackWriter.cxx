#include "TIFF/TIFFStackWriter.h"

#include "TIFF/TIFFStackParser.h"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

using conformal::makeTIFFStack;
using conformal::ScalarType;
using conformal::TIFFStack;

namespace
{
// Two channels and three slices of 4 x 2 floats with sizes of voxels.
TIFFStack stack()
{
  TIFFStack result;
  result.Info.Width = 4;
  result.Info.Height = 2;
  result.Info.Slices = 3;
  result.Info.Channels = 2;
  result.Info.Type = ScalarType::Float32;
  result.Info.Spacing = { 0.29304, 12.5, 3.340934043219543 };
  result.Info.Unit = "micron";
  result.Values.resize(48 * sizeof(float));
  for (int i = 0; i < 48; ++i)
  {
    const float value = 0.25F * static_cast<float>(i) - 3.0F;
    std::memcpy(result.Values.data() + i * sizeof(float), &value, sizeof(float));
  }
  return result;
}

conformal::TIFFStackResult read(const std::string& bytes, bool isUp = false, std::size_t frame = 0)
{
  conformal::TIFFStackOptions options;
  options.FirstRowUp = isUp;
  options.Frame = frame;
  return conformal::parseTIFFStack(
    [&](conformal::ByteReader& input)
    {
      input = conformal::ByteReader(bytes);
      return conformal::ParseStatus();
    },
    options);
}
}

TEST(TIFFStackWriter, StacksAreReadBackWithUnits)
{
  const TIFFStack written = stack();
  for (const bool isUp : { false, true })
  {
    const conformal::TIFFStackResult result = read(makeTIFFStack(written, isUp), isUp);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    const conformal::TIFFStackInfo& info = result.Stack.Info;
    EXPECT_EQ(info.Width, 4u);
    EXPECT_EQ(info.Height, 2u);
    EXPECT_EQ(info.Slices, 3u);
    EXPECT_EQ(info.Channels, 2u);
    EXPECT_EQ(info.Type, ScalarType::Float32);
    EXPECT_EQ(info.Unit, "micron");
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_NEAR(info.Spacing[a] / written.Info.Spacing[a], 1.0, a < 2 ? 1e-6 : 1e-16);
    }
    ASSERT_EQ(result.Stack.Values.size(), written.Values.size());
    EXPECT_EQ(
      std::memcmp(result.Stack.Values.data(), written.Values.data(), written.Values.size()), 0);
  }
}

// ImageJ reads only the first directory, and takes the pages that follow the first one.
TEST(TIFFStackWriter, PagesFollowEachOther)
{
  const std::string bytes = makeTIFFStack(stack());
  const float first = -3.0F;
  const std::size_t begin = bytes.find(std::string(reinterpret_cast<const char*>(&first), 4));
  ASSERT_NE(begin, std::string::npos);
  for (int page = 0; page < 6; ++page)
  {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + begin + 32 * page, sizeof(value));
    EXPECT_EQ(value, 0.25F * static_cast<float>(page / 2 * 16 + page % 2) - 3.0F);
  }
  EXPECT_NE(bytes.find("images=6\nchannels=2\nslices=3\nhyperstack=true\n"), std::string::npos);
  EXPECT_NE(bytes.find("spacing=3.340934043219543\n"), std::string::npos);
  EXPECT_NE(bytes.find("min=-3\nmax=8.75\n"), std::string::npos);
}

TEST(TIFFStackWriter, TimeStepsAreReadBack)
{
  TIFFStack written = stack();
  written.Info.Slices = 1;
  written.Info.Frames = 3;
  written.Info.FrameInterval = 12.5;
  const std::string bytes = makeTIFFStack(written);
  EXPECT_NE(bytes.find("images=6\nchannels=2\nframes=3\nhyperstack=true\n"), std::string::npos);
  EXPECT_NE(bytes.find("finterval=12.5\n"), std::string::npos);
  for (std::size_t frame = 0; frame < 3; ++frame)
  {
    const conformal::TIFFStackResult result = read(bytes, false, frame);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_EQ(result.Stack.Info.Frames, 3u);
    EXPECT_EQ(result.Stack.Info.Slices, 1u);
    EXPECT_EQ(result.Stack.Info.FrameInterval, 12.5);
    const std::size_t size = written.Values.size() / 3;
    ASSERT_EQ(result.Stack.Values.size(), size);
    EXPECT_EQ(
      std::memcmp(result.Stack.Values.data(), written.Values.data() + frame * size, size), 0);
  }
}

TEST(TIFFStackWriter, SpacingsOfAnySizeAreKept)
{
  for (const double spacing :
    { 2.4e-10, 4e-10, 1e-9, 3.3e-7, 3e-4, 0.7, 1.0, 77.7, 1e6, 3e6 / 7.0, 3e6, 3.3e7, 1e9, 4.2e9 })
  {
    TIFFStack sized = stack();
    sized.Info.Spacing = { spacing, 1.0 / spacing, spacing };
    const std::array<double, 3> found = read(makeTIFFStack(sized)).Stack.Info.Spacing;
    EXPECT_NEAR(found[0] / spacing, 1.0, 5e-7) << spacing;
    EXPECT_NEAR(found[1] * spacing, 1.0, 5e-7) << spacing;
  }
}

TEST(TIFFStackWriter, UnsuitableStacksAreRefused)
{
  const auto expectRefused = [](const std::function<void(TIFFStack&)>& change)
  {
    TIFFStack bad = stack();
    change(bad);
    EXPECT_THROW(makeTIFFStack(bad), std::invalid_argument);
  };
  expectRefused([](TIFFStack& s) { s.Info.Type = ScalarType::Float64; });
  expectRefused([](TIFFStack& s) { s.Info.Slices = 4; });
  expectRefused([](TIFFStack& s) { s.Info.Width = 0; });
  expectRefused([](TIFFStack& s) { s.Info.Spacing[1] = 0.0; });
  expectRefused([](TIFFStack& s) { s.Info.Spacing[0] = 2.3e-10; });
  expectRefused([](TIFFStack& s) { s.Info.Spacing[0] = 4.3e9; });
  expectRefused([](TIFFStack& s) { s.Info.Spacing[1] = 1e-310; });
  expectRefused([](TIFFStack& s) { s.Info.Frames = 2; });
  expectRefused([](TIFFStack& s) { s.Info.FrameInterval = 0.0; });
  expectRefused([](TIFFStack& s) { s.Info.Unit = "a\nb"; });
  EXPECT_THROW(
    makeTIFFStack(stack(), false, { {}, [](double) { return false; } }), conformal::Aborted);
}
