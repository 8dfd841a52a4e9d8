#include "SPHARM/SPHARMCoefficients.h"

#include "../../CommaLocale.h"
#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "Refusals.h"
#include "SPHARMSamples.h"

#include <cmath>
#include <stdexcept>

using conformal::NamedArray;
using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::replaced;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes, const conformal::Run& run = {})
{
  conformal::ByteReader input(bytes);
  return conformal::parseSPHARMCoefficients(input, {}, run);
}

void ExpectSample(const std::string& bytes)
{
  const SurfaceResult result = parse(bytes);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  ASSERT_EQ(result.Data.PointArrays.size(), 1u);
  // Of the file's order: m = 0, then cos and sin of m = 1 with the Condon-Shortley phase.
  const double half = std::sqrt(0.5);
  const std::vector<double> expected = { 0.5, -1.0, 2.0, 0.0, 5.125 * half, -0.1 * half, 0.0, 0.0,
    3.25, 4.0 * half, 0.0, 0.0 };
  const std::vector<double> found = values<double>(result.Data.PointArrays.front());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-15) << i;
  }
}

std::string rewritten(const std::string& bytes)
{
  const SurfaceResult result = parse(bytes);
  EXPECT_TRUE(result.Status.ok()) << result.Status.text();
  return conformal::makeSPHARMCoefficients(result.Data.PointArrays.front());
}
}

TEST(SPHARMCoefficients, AreReadHoweverTheyAreWritten)
{
  const CommaLocale locale;
  const std::string& sample = samples::SPHARMCoefficients();
  ExpectSample(sample);
  for (const std::string end : { "", " ", "\r\n", "\r", "\n\n", " \t\n" })
  {
    ExpectSample(replaced(sample, "\n", end));
  }
  ExpectSample(" \n" + sample + "\n\n ");
  ExpectSample("\xEF\xBB\xBF" + sample);
  ExpectSample(replaced(sample, "{", " { "));
  ExpectSample(replaced(sample, "}", " } "));
  ExpectSample(replaced(sample, ",", " , "));
  ExpectSample(replaced(sample, ", ", ","));
  ExpectSample(replaced(sample, "-4.000000", "-4e0"));
  ExpectSample(replaced(sample, ",\n", "," + std::string(1 << 20, ' ')));
}

TEST(SPHARMCoefficients, AreReadInPieces)
{
  // More than is read at once.
  for (const std::string& file :
    { samples::SPHARMCoefficients(), samples::SPHARMCoefficientFiles()[1],
      replaced(samples::SPHARMCoefficients(), ", ", "," + std::string(1 << 20, ' ')) })
  {
    const SurfaceResult whole = parse(file);
    conformal::ByteReader input = samples::InPieces(file);
    const SurfaceResult result = conformal::parseSPHARMCoefficients(input);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_EQ(values<double>(result.Data.PointArrays.front()),
      values<double>(whole.Data.PointArrays.front()));
  }
}

// To the last printed digit.
TEST(SPHARMCoefficients, RoundTripKeepsEveryDigit)
{
  const CommaLocale locale;
  std::string text = "{ 25,";
  for (int i = 0; i < 25; ++i)
  {
    text += i > 0 ? ",\n{" : "{";
    for (int c = 0; c < 3; ++c)
    {
      // 15 digits, none of them 0 at the end.
      const long long digits = 123456789012345LL + 987654321987LL * (3 * i + c) / 10 * 10 + 1;
      text += (c > 0 ? ", " : "") + std::string(i % 2 == 0 ? "-" : "") +
        std::to_string(digits).substr(0, 3) + "." + std::to_string(digits).substr(3);
    }
    text += "}";
  }
  text += "}\n";
  EXPECT_EQ(rewritten(replaced(text, "01,", "11,")), replaced(text, "01,", "11,"));
  const std::string once = rewritten(samples::SPHARMCoefficients());
  EXPECT_EQ(once, "{ 4,{0.5, -1, 2},\n{0, 0, 3.25},\n{-4, 0, 0},\n{0, -5.125, 0.1}}\n");
  EXPECT_EQ(rewritten(once), once);
}

TEST(SPHARMCoefficients, BadFilesAreRefusedWithTheirLine)
{
  const std::string& sample = samples::SPHARMCoefficients();
  ExpectRefused(parse(""), ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused(parse("hello"), ParseCode::UnrecognizedType, 1, "expected { N,{x, y, z}");
  ExpectRefused(parse("{ \"points\": [1] }"), ParseCode::UnrecognizedType, 1, "expected { N,");
  ExpectRefused(parse(replaced(sample, "{ 4", "{ 3")), ParseCode::Malformed, 1, "(L + 1)^2");
  ExpectRefused(
    parse(replaced(sample, "3.25", "x")), ParseCode::Malformed, 2, "expected a finite number");
  ExpectRefused(parse(replaced(sample, "3.250000", "nan")), ParseCode::Malformed, 2, "finite");
  ExpectRefused(
    parse(replaced(sample, "{-4.000000,", "{-4.000000;")), ParseCode::Malformed, 3, "found \"-4.0");
  ExpectRefused(parse(sample + "\nmore"), ParseCode::Malformed, 5, "expected the end of the file");
  ExpectRefused(parse(replaced(sample, "{ 4", "{ 9000000000000000000")), ParseCode::Malformed, 1,
    "coefficients");
  for (std::size_t length = 7; length + 1 < sample.size(); ++length)
  {
    const SurfaceResult cut = parse(sample.substr(0, length));
    EXPECT_FALSE(cut.Status.ok()) << length;
  }
  for (const std::string& bad : samples::BadSPHARMCoefficientFiles())
  {
    EXPECT_FALSE(parse(bad).Status.ok()) << bad;
  }
}

TEST(SPHARMCoefficients, ReadingAndWritingStopWhenAsked)
{
  const conformal::Run stop({}, [](double) { return false; });
  const conformal::Run stopHalfWay({}, [](double done) { return done < 0.5; });
  const SurfaceResult result = parse(samples::SPHARMCoefficients(), stop);
  EXPECT_EQ(result.Status.Code, ParseCode::Aborted);
  const SurfaceResult whole = parse(samples::SPHARMCoefficientFiles()[1]);
  EXPECT_THROW(conformal::makeSPHARMCoefficients(whole.Data.PointArrays.front(), stopHalfWay),
    conformal::Aborted);
}

TEST(SPHARMCoefficients, WriterRefusesWhatIsNoneOrTooLarge)
{
  NamedArray array = conformal::makeArray("Coefficients", ScalarType::Float64, 3);
  const double tuple[] = { 1.0, 1.7e308, 3.0 };
  EXPECT_THROW(conformal::makeSPHARMCoefficients(array), std::invalid_argument);
  for (int i = 0; i < 4; ++i)
  {
    conformal::append(array, tuple);
  }
  EXPECT_THROW(conformal::makeSPHARMCoefficients(array), std::invalid_argument);
  conformal::append(array, tuple);
  EXPECT_THROW(conformal::makeSPHARMCoefficients(array), std::invalid_argument);
}

TEST(SPHARMCoefficients, FilesAreRecognized)
{
  EXPECT_TRUE(conformal::looksLikeSPHARMCoefficients(samples::SPHARMCoefficients()));
  EXPECT_TRUE(conformal::looksLikeSPHARMCoefficients(" {4 , { "));
  EXPECT_FALSE(conformal::looksLikeSPHARMCoefficients("{ 4"));
  EXPECT_FALSE(conformal::looksLikeSPHARMCoefficients("{ a,{"));
  EXPECT_FALSE(conformal::looksLikeSPHARMCoefficients("{}"));
  EXPECT_FALSE(conformal::looksLikeSPHARMCoefficients(""));
}
