#include "StanfordScans/AlignedScans.h"

#include "../../CommaLocale.h"
#include "../Bytes/ParsedArrays.h"
#include "AlignedScansSamples.h"

using conformal::ParseCode;
using conformal::SurfaceResult;
using samples::replaced;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes, const conformal::AlignedScansOptions& options = {})
{
  static const auto files = samples::SphereScans();
  const auto open = [](const std::string& name)
  {
    conformal::OpenedScan scan;
    scan.Status = { ParseCode::FileNotFound, 0, 0, "there is no such file" };
    scan.Identity = name;
    for (const auto& [known, content] : files)
    {
      if (known == name)
      {
        scan.Status = {};
        scan.Input = conformal::ByteReader(content);
      }
    }
    return scan;
  };
  conformal::ByteReader input(bytes);
  return conformal::parseAlignedScans(input, open, options);
}

double maximumError(const SurfaceResult& result)
{
  const std::vector<double> points = values<double>(result.Data.Points);
  double error = 0.0;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    error = std::max(error, std::abs(std::hypot(points[i], points[i + 1], points[i + 2]) - 1.0));
  }
  return error;
}

void ExpectRefused(
  const std::string& bytes, ParseCode code, std::uint64_t line, const std::string& part)
{
  const SurfaceResult result = parse(bytes);
  EXPECT_EQ(result.Status.Code, code) << result.Status.text();
  EXPECT_EQ(result.Status.Line, line) << result.Status.text();
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
}
}

TEST(AlignedScans, LieOnTheObjectThatWasScanned)
{
  const CommaLocale locale;
  const std::string& conf = samples::SphereConf();
  for (const std::string& file :
    { conf, replaced(conf, "\n", "\r\n"), replaced(conf, "\n", "\n#\n\n"), "\xEF\xBB\xBF" + conf,
      replaced(conf, " ", "\t "), conf.substr(0, conf.size() - 1) })
  {
    const SurfaceResult result = parse(file);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_LT(maximumError(result), 1e-6);
    EXPECT_EQ(result.Data.Points.numberOfTuples(), 3u * 25u);
    const std::vector<std::int32_t> ids =
      values<std::int32_t>(*samples::find(result.Data.PointArrays, "ScanId"));
    EXPECT_EQ(std::count(ids.begin(), ids.end(), 1), 25);
    EXPECT_EQ(ids.back(), 2);
    EXPECT_EQ(samples::find(result.Data.PointArrays, "confidence")->numberOfTuples(), 75u);
    EXPECT_EQ(result.Data.PolygonIds.size(), 0u);
    // A scanner faces every point of the unit sphere that it has measured.
    const std::vector<double> points = values<double>(result.Data.Points);
    const std::vector<float> scanners =
      values<float>(*samples::find(result.Data.PointArrays, "ScannerPosition"));
    ASSERT_EQ(scanners.size(), points.size());
    for (std::size_t i = 0; i < points.size(); i += 3)
    {
      double height = 0.0;
      for (std::size_t c = i; c < i + 3; ++c)
      {
        height += (scanners[c] - points[c]) * points[c];
      }
      EXPECT_GT(height, 0.0);
    }
  }
  conformal::AlignedScansOptions options;
  options.InvertRotation = true;
  EXPECT_GT(maximumError(parse(conf, options)), 0.5);
}

TEST(AlignedScans, RefusesBrokenFilesWithTheirLine)
{
  for (const std::string& file : samples::BadAlignedScansFiles())
  {
    EXPECT_FALSE(parse(file).Status.ok()) << file;
  }
  const std::string& conf = samples::SphereConf();
  ExpectRefused("", ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused("ply\n", ParseCode::UnrecognizedType, 1, "camera");
  ExpectRefused(
    replaced(conf, "side.ply", "broken.ply"), ParseCode::Malformed, 3, "in \"broken.ply\": line 4");
  ExpectRefused(replaced(conf, "side.ply", "../side.ply"), ParseCode::Malformed, 3, "folder");
  ExpectRefused(replaced(conf, "side.ply", "front.ply"), ParseCode::Malformed, 3, "once");
  ExpectRefused(replaced(conf, "0.5 -1", "0.5.5 -1"), ParseCode::Malformed, 3, "mesh NAME");
}

TEST(AlignedScans, ScanIdIsTheLineWhateverTheScansHave)
{
  const std::string scan = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                           "property float y\nproperty float z\nproperty int ScanId\n"
                           "property int only\nend_header\n1 2 3 77 1\n";
  const auto open = [&](const std::string& name)
  {
    conformal::OpenedScan opened;
    opened.Identity = name;
    opened.Input = conformal::ByteReader(std::string_view(scan));
    return opened;
  };
  conformal::ByteReader input{ std::string_view("mesh a 0 0 0 0 0 0 1\nmesh b 0 0 0 0 0 0 1\n") };
  const SurfaceResult result = conformal::parseAlignedScans(input, open);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  using conformal::ScalarType;
  const auto& arrays = result.Data.PointArrays;
  samples::ExpectArray<std::int32_t>(arrays, "ScanId", ScalarType::Int32, 1, { 0, 1 });
  samples::ExpectArray<std::int32_t>(arrays, "ScanId2", ScalarType::Int32, 1, { 77, 77 });
  samples::ExpectArray<std::int32_t>(arrays, "only", ScalarType::Int32, 1, { 1, 1 });
  EXPECT_EQ(arrays.size(), 4u);
}

TEST(AlignedScans, AreKnownByTheirFirstLine)
{
  for (const std::string& file : samples::AlignedScansFiles())
  {
    EXPECT_TRUE(conformal::looksLikeAlignedScans(file));
  }
  for (const char* other : { "", "camera\n", "mesh 0 0 0 0 0 0 1\n", "mesh a 0 0 0 0 0 0 0\n" })
  {
    EXPECT_FALSE(conformal::looksLikeAlignedScans(other)) << other;
  }
}
