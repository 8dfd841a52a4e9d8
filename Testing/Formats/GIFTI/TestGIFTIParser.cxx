#include "GIFTI/GIFTIParser.h"

#include "../../CommaLocale.h"
#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "GIFTI/BinaryText.h"
#include "GIFTI/GIFTIFile.h"
#include "GIFTISamples.h"
#include "Text/BinaryTextEncoder.h"

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::ExpectArray;
using samples::Ids;
using samples::polygonIds;
using samples::replaced;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parseGIFTISurface(input);
}

SurfaceResult parseArrays(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parseGIFTIArrays(input);
}

std::string decoded(const std::string& text, std::size_t size, bool isCompressed)
{
  conformal::BinaryTextDecoder decoder(size, isCompressed);
  for (std::size_t at = 0, step = 1; at < text.size(); at += step, step = step * 7 % 5003 + 1)
  {
    decoder.add(std::string_view(text).substr(at, step));
  }
  const conformal::OwnedArray<unsigned char> bytes = decoder.take();
  return { reinterpret_cast<const char*>(bytes.data()), bytes.size() };
}

void ExpectRefused(
  const std::string& bytes, ParseCode code, std::uint64_t line, const std::string& part)
{
  const SurfaceResult result = parse(bytes);
  EXPECT_EQ(result.Status.Code, code) << result.Status.text();
  EXPECT_EQ(result.Status.Line, line) << result.Status.text();
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
}
}

TEST(GIFTIParser, ReadsTextHoweverItIsWritten)
{
  const CommaLocale locale;
  const std::string ascii = samples::AsciiGIFTI();
  for (const std::string& file : { ascii, replaced(ascii, "\n", "\r\n"), "\xEF\xBB\xBF" + ascii,
         replaced(ascii, "1.5", std::string(1 << 20, ' ') + "1.5"),
         replaced(ascii, "<MetaData/>", "<!--" + std::string(1 << 20, 'x') + "-->") })
  {
    const SurfaceResult result = parse(file);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    EXPECT_EQ(values<float>(result.Data.Points),
      (std::vector<float>{ 0, 0, 0, 1.5F, 0, 0, 0, 1, 0, 0, 0, 1e-3F }));
    EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 }));
    ExpectArray<float>(
      result.Data.PointArrays, "sulc & depth", ScalarType::Float32, 1, { 1, 2, 3, 0.25F });
  }
  // One coordinate after another.
  std::string columns =
    replaced(ascii, "0 0 0\n1.5 0 0\n0 1 0\n0 0 1e-3", "0 1.5 0 0 0 0 1 0 0 0 0 1e-3");
  columns = replaced(columns, "0 2 1 0 1 3 1 2 3 2 0 3", "0 0 1 2 2 1 2 0 1 3 3 3");
  columns = replaced(columns, "RowMajorOrder", "ColumnMajorOrder");
  EXPECT_TRUE(samples::AreSame(parse(columns).Data.Points, parse(ascii).Data.Points));
  EXPECT_EQ(polygonIds(parse(columns).Data), polygonIds(parse(ascii).Data));
}

TEST(GIFTIParser, ReadsBinaryOfBothOrdersAndCompressed)
{
  const std::vector<double> expected(
    samples::TetrahedronPoints().begin(), samples::TetrahedronPoints().end());
  for (const bool isBig : { false, true })
  {
    for (const bool isCompressed : { false, true })
    {
      const std::string file = samples::BinaryGIFTI(isBig, isCompressed);
      const SurfaceResult result = parse(file);
      ASSERT_TRUE(result.Status.ok()) << result.Status.text();
      EXPECT_EQ(values<double>(result.Data.Points), expected);
      EXPECT_EQ(polygonIds(result.Data), (Ids{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 }));
      conformal::ByteReader pieces = samples::InPieces(file);
      EXPECT_TRUE(
        samples::AreSame(conformal::parseGIFTISurface(pieces).Data.Points, result.Data.Points));
    }
  }
}

TEST(GIFTIParser, NamesArraysByMetadataOrIntent)
{
  const SurfaceResult result = parseArrays(samples::ShapeGIFTI());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  const auto& arrays = result.Data.PointArrays;
  ExpectArray<std::int16_t>(arrays, "sulc & depth", ScalarType::Int16, 1, { 0, 1, 2, 3 });
  ExpectArray<std::uint8_t>(arrays, "None", ScalarType::UInt8, 1, { 0, 1, 2, 3 });
  const SurfaceResult twice = parseArrays(replaced(
    replaced(samples::ShapeGIFTI(), "INTENT_SHAPE", "INTENT_NONE"), "sulc &amp; depth", ""));
  ASSERT_EQ(twice.Data.PointArrays.size(), 2u);
  EXPECT_EQ(twice.Data.PointArrays[0].Name, "None");
  EXPECT_EQ(twice.Data.PointArrays[1].Name, "None2");
  EXPECT_TRUE(parseArrays(samples::AsciiGIFTI()).Status.ok());
}

TEST(GIFTIParser, DecodesKnownTexts)
{
  EXPECT_EQ(decoded("TWFu", 3, false), "Man");
  EXPECT_EQ(decoded(" TW\nE= ", 2, false), "Ma");
  EXPECT_EQ(decoded("TQ==", 1, false), "M");
  EXPECT_EQ(decoded("eJzLSM3JyQcABiwCFQ==", 5, true), "hello"); // as Python's zlib writes it
  EXPECT_EQ(conformal::encodeBinaryText("Ma", false), "TWE=");
  std::string bytes;
  for (unsigned int i = 0; i < 100000; ++i)
  {
    bytes += static_cast<char>((i * i) >> 5);
  }
  for (const bool isCompressed : { false, true })
  {
    EXPECT_TRUE(decoded(conformal::encodeBinaryText(bytes, isCompressed), bytes.size(),
                  isCompressed) == bytes);
  }
  for (const char* text : { "TWF*", "T=Fu", "TWFuTWFu", "TWE=" })
  {
    EXPECT_THROW(decoded(text, 3, false), conformal::GIFTIError) << text;
  }
  const std::string bomb = conformal::encodeBinaryText(std::string(10000000, '\0'), true);
  EXPECT_THROW(decoded(bomb, 1000, true), conformal::GIFTIError);
}

TEST(GIFTIParser, RefusesBrokenFilesWithTheirLine)
{
  for (const std::string& file : samples::BadGIFTIFiles())
  {
    const SurfaceResult result = parse(file);
    EXPECT_FALSE(result.Status.ok()) << file.substr(0, 2000);
    EXPECT_FALSE(result.Status.Message.empty());
  }
  const std::string ascii = samples::AsciiGIFTI();
  ExpectRefused("", ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused("<html></html>", ParseCode::UnrecognizedType, 1, "GIFTI");
  ExpectRefused(replaced(ascii, "1.5", "1.2.3"), ParseCode::Malformed, 11, "1.2.3");
  ExpectRefused(replaced(ascii, "ASCII", "EBCDIC"), ParseCode::Malformed, 10, "EBCDIC");
  ExpectRefused(ascii.substr(0, ascii.size() - 9), ParseCode::PrematureEnd, 28, "XML");
  const std::string manyTags = replaced(ascii, "<MetaData/>", std::string(200, '<'));
  ExpectRefused(manyTags, ParseCode::Malformed, 4, "XML");
  std::string deep;
  for (int i = 0; i < 200; ++i)
  {
    deep += "<a>";
  }
  ExpectRefused(replaced(ascii, "<LabelTable/>", deep), ParseCode::Malformed, 5, "deep");
}

TEST(GIFTIParser, NumberOfArraysIsThatOfTheFile)
{
  const std::string ascii = samples::AsciiGIFTI();
  const auto refuse = [&](const char* attribute, std::uint64_t line, const char* part)
  {
    ExpectRefused(
      replaced(ascii, "NumberOfDataArrays=\"3\"", attribute), ParseCode::Malformed, line, part);
  };
  refuse("NumberOfDataArrays=\"2\"", 22, "more DataArrays than the 2");
  refuse("NumberOfDataArrays=\"4\"", 28, "fewer DataArrays than the 4");
  refuse("NumberOfDataArrays=\"18446744073709551616\"", 3, "expected a count");
  refuse("NumberOfDataArrays=\"three\"", 3, "found NumberOfDataArrays \"three\"");
  refuse("", 3, "found NumberOfDataArrays \"\"");
  ExpectRefused(
    replaced(ascii, "RowMajorOrder", "NoOrder"), ParseCode::Malformed, 6, "ArrayIndexingOrder");
}

TEST(GIFTIParser, IsKnownByItsElement)
{
  for (const std::string& file : samples::GIFTIFiles())
  {
    EXPECT_TRUE(conformal::looksLikeGIFTI(file));
  }
  for (const char* other : { "", "<", "<?xml version=\"1.0\"?><VTKFile>", "GIFTI", "x<GIFTI>" })
  {
    EXPECT_FALSE(conformal::looksLikeGIFTI(other)) << other;
  }
}
