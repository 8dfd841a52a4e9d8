#include "TextCloud/TextCloudParser.h"

#include "../../CommaLocale.h"
#include "../Bytes/FilePieces.h"
#include "../Bytes/MadeBytes.h"
#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "TextCloudSamples.h"

#include <gtest/gtest.h>

#include <limits>

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::ExpectArray;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes, const conformal::TextCloudOptions& options = {})
{
  conformal::ByteReader input(bytes);
  return conformal::parseTextCloud(input, options);
}

void ExpectPoints(const std::string& bytes, const std::vector<double>& expected)
{
  const SurfaceResult result = parse(bytes);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text() << "\n" << bytes.substr(0, 200);
  EXPECT_EQ(values<double>(result.Data.Points), expected) << bytes.substr(0, 200);
}

std::vector<std::string> namesOf(const std::string& bytes)
{
  std::vector<std::string> names;
  for (const conformal::NamedArray& array : parse(bytes).Data.PointArrays)
  {
    names.push_back(array.Name);
  }
  return names;
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

using Names = std::vector<std::string>;
const std::vector<double> Plain = { 0.5, 1.5, 2.5, 1234567.123456789, -1e-3, 0.25, 7, 8, 9 };
}

TEST(TextCloudParser, ReadsPointsBetweenEveryDelimiter)
{
  const std::string& plain = samples::PlainCloud();
  ExpectPoints(plain, Plain);
  for (const char* delimiter : { "\t", "  \t ", ",", ", ", ";", " ; ", "\t," })
  {
    const std::string text = samples::replaced(plain, " ", delimiter);
    ExpectPoints(text, Plain);
    ExpectPoints(samples::replaced(text, "\n", std::string(delimiter) + "\n"), Plain);
  }
}

TEST(TextCloudParser, IsBlindToLineEndsBlanksRemarksAndTheByteOrderMark)
{
  const CommaLocale locale;
  const std::string& plain = samples::PlainCloud();
  const std::string million(1 << 20, ' ');
  for (const std::string end : { "\n", "\r\n", "\r", "\n\n", " \t\n", "\n \n# no\n//no\n;no\n" })
  {
    ExpectPoints(samples::replaced(plain, "\n", end), Plain);
  }
  ExpectPoints(plain.substr(0, plain.size() - 1), Plain);
  ExpectPoints("\xEF\xBB\xBF" + plain, Plain);
  ExpectPoints("\xEF\xBB\xBF# gr\xC3\xBC\xC3\x9F\n" + plain, Plain);
  ExpectPoints(samples::replaced(plain, " ", million), Plain);
  ExpectPoints("#" + std::string(1 << 20, 'x') + "\n" + plain, Plain);
}

TEST(TextCloudParser, ReadsColumnsByTheirNames)
{
  const SurfaceResult result = parse(samples::NamedCloud());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  const auto& arrays = result.Data.PointArrays;
  EXPECT_EQ(values<double>(result.Data.Points), (std::vector<double>{ 0.5, 1, 2, -0.5, 1, 2 }));
  ExpectArray<std::uint8_t>(arrays, "RGB", ScalarType::UInt8, 3, { 1, 2, 3, 255, 254, 253 });
  ExpectArray<double>(arrays, "Normals", ScalarType::Float64, 3, { 0, 0, 1, 0, 1, 0 });
  ExpectArray<double>(arrays, "Intensity", ScalarType::Float64, 1, { -2048, 2047 });
  ExpectArray<double>(arrays, "label", ScalarType::Float64, 1, { 5, 6 });
  EXPECT_EQ(arrays.size(), 4u);
  // In a remark, with blanks in names between tabs, as another program exports them.
  EXPECT_EQ(namesOf("//X Y Z Rough\n0 0 0 5\n"), (Names{ "Rough" }));
  EXPECT_EQ(namesOf("# made by me\n0 0 0 5\n"), (Names{ "Intensity" }));
  EXPECT_EQ(namesOf("x\ty\tz\tScalar field\n0\t0\t0\t5\n"), (Names{ "Scalar field" }));
  EXPECT_EQ(namesOf("Points:0,Points:1,Points:2,d\n0,0,0,5\n"), (Names{ "d" }));
  // Numbers that are no colors keep their names, and so do single members.
  EXPECT_EQ(namesOf("x y z r g b\n0 0 0 0.5 0 -1\n"), (Names{ "r", "g", "b" }));
  EXPECT_EQ(namesOf("x y z r g b\n0 0 0 0.5 0 1\n0 0 0 2 0 1\n"), (Names{ "r", "g", "b" }));
  EXPECT_EQ(namesOf("x y z r g b\n0 0 0 65536 0 1\n"), (Names{ "r", "g", "b" }));
  EXPECT_EQ(namesOf("x y z nx g\n0 0 0 0.5 1\n"), (Names{ "nx", "g" }));
}

TEST(TextCloudParser, ReadsColorsAsFractionsAndOf16Bits)
{
  const auto expect = [](const std::string& text, const std::vector<std::uint8_t>& colors)
  {
    const SurfaceResult result = parse(text);
    ASSERT_TRUE(result.Status.ok()) << result.Status.text();
    ASSERT_EQ(result.Data.PointArrays.size(), 1u);
    ExpectArray<std::uint8_t>(result.Data.PointArrays, "RGB", ScalarType::UInt8, 3, colors);
  };
  expect("x,y,z,red,green,blue\n0,0,0,0.5,0,1\n0,0,1,0.1,0.2,0.002\n", { 128, 0, 255, 26, 51, 1 });
  expect("x y z r g b\n0 0 0 65535 0 257\n0 0 1 32768 128 129\n", { 255, 0, 1, 128, 0, 1 });
  expect("x y z r g b\n0 0 0 1 0 1\n0 0 1 0 0 1\n", { 1, 0, 1, 0, 0, 1 }); // bytes
  std::string fractions = "x y z r g b\n", words = fractions;
  for (int i = 0; i < 120; ++i)
  {
    fractions += "0 0 0 0.5 0 1\n";
    words += "0 0 0 500 0 1\n";
  }
  ExpectRefused(
    fractions + "5 5 5 1.5 0 1\n", ParseCode::Malformed, 122, "colors as fractions in 0..1 as");
  ExpectRefused(
    words + "5 5 5 1.5 0 1\n", ParseCode::Malformed, 122, "colors as integers in 0..65535 as");
}

TEST(TextCloudParser, UnitsAfterNamesDoNotMatter)
{
  for (const char* names : { "x [mm],Y [mm],z[mm]", "X (m),y(m),Z (m)", "\"x [mm]\",\"y\",z" })
  {
    ExpectPoints(names + std::string("\n1,2,3\n"), { 1, 2, 3 });
  }
  ExpectRefused("[x],y,z\n1,2,3\n", ParseCode::UnrecognizedType, 1, "names of the 3 columns");
  ExpectRefused(
    "x [m],x [mm],z\n1,2,3\n", ParseCode::UnrecognizedType, 1, "names of the 3 columns");
}

TEST(TextCloudParser, NamesOfColumnsAreThereOnce)
{
  ExpectRefused("x y z a a\n1 2 3 4 5\n", ParseCode::UnrecognizedType, 1, "two columns \"a\"");
  ExpectRefused("x,y,z,x\n1,2,3,4\n", ParseCode::UnrecognizedType, 1, "two columns \"x\"");
  EXPECT_EQ(namesOf("x,y,z,X\n1,2,3,4\n"), (Names{ "X" }));
  // A remark that says a name twice names no columns.
  EXPECT_EQ(namesOf("# x y z a a\n1 2 3 4 5\n"), (Names{ "Column4", "Column5" }));
  // Columns that a spreadsheet left without a name are called by their number.
  EXPECT_EQ(namesOf(",x,y,z,\"\"\n0,1,2,3,4\n"), (Names{ "Column1", "Column5" }));
  // Normals become Normals, whatever else is called so.
  EXPECT_EQ(namesOf("x,y,z,nx,ny,nz,Normals\n1,2,3,0,0,1,7\n"), (Names{ "Normals", "Normals2" }));
}

TEST(TextCloudParser, TellsUnnamedColumnsByTheirNumberAndValues)
{
  EXPECT_EQ(namesOf("0 0 0\n"), (Names{}));
  EXPECT_EQ(namesOf("0 0 0 5\n"), (Names{ "Intensity" }));
  EXPECT_EQ(namesOf("0 0 0 5 6\n"), (Names{ "Column4", "Column5" }));
  EXPECT_EQ(namesOf("0 0 0 0 0 1\n0 0 0 0.6 0.8 0\n"), (Names{ "Normals" }));
  EXPECT_EQ(namesOf("0 0 0 0 0 1\n0 0 0 0 0 255\n"), (Names{ "RGB" }));
  EXPECT_EQ(namesOf("0 0 0 0 0 1\n0 0 0 0 0 256\n"), (Names{ "Column4", "Column5", "Column6" }));
  EXPECT_EQ(namesOf("0 0 0 -5 1 2 3\n"), (Names{ "RGB", "Intensity" }));
  EXPECT_EQ(namesOf("0 0 0 1 2 3 0.5\n"), (Names{ "RGB", "Intensity" }));
  EXPECT_EQ(namesOf("0 0 0 1 2 3 0 0 1\n"), (Names{ "Normals", "RGB" }));
  EXPECT_EQ(namesOf("0 0 0 0 0 1 1 2 3\n"), (Names{ "Normals", "RGB" }));
  EXPECT_EQ(namesOf("0 0 0 0 0 0\n0 0 1 0 0 0\n"), (Names{ "RGB" })); // black
  EXPECT_EQ(namesOf("0 0 0 0 0 0\n0 0 1 0 0 1\n"), (Names{ "Normals" }));
  const SurfaceResult laser = parse("0 0 0 -5 1 2 3\n");
  ExpectArray<double>(laser.Data.PointArrays, "Intensity", ScalarType::Float64, 1, { -5 });
  ExpectArray<std::uint8_t>(laser.Data.PointArrays, "RGB", ScalarType::UInt8, 3, { 1, 2, 3 });
}

TEST(TextCloudParser, ReadsEveryPointOfCountedBlocks)
{
  const SurfaceResult result = parse(samples::LaserCloud());
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(values<double>(result.Data.Points),
    (std::vector<double>{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 }));
  ExpectPoints("0\n", {});
  ExpectPoints("0\n1\n1 2 3\n", { 1, 2, 3 });
  ExpectRefused("3\n0 0 0\n1 1 1\n", ParseCode::PrematureEnd, 1, "bytes");
  ExpectRefused("3\n0.000 0.000 0.000\n1 1 1\n", ParseCode::PrematureEnd, 4, "1 more points");
  ExpectRefused("1\n0 0 0\n1 1 1\n", ParseCode::Malformed, 3, "one more point");
  ExpectRefused("2000000000\n0 0 0\n", ParseCode::Malformed, 1, "2000000000");
  ExpectRefused("-5\n0 0 0\n", ParseCode::UnrecognizedType, 1, "-5");
  ExpectRefused("99999999999999999999\n0 0 0\n", ParseCode::Malformed, 1, "number of points");
}

TEST(TextCloudParser, DecimalCommasAreReadWhenSaid)
{
  conformal::TextCloudOptions options;
  options.DecimalComma = true;
  for (const char* text : { "0,5;1;-2,25\n", "0,5 1 -2,25\n", "0,5\t1\t-2,25\n" })
  {
    EXPECT_EQ(
      values<double>(parse(text, options).Data.Points), (std::vector<double>{ 0.5, 1, -2.25 }));
  }
  for (const char* text : { "0,5 1 -2,25\n", "0,5\t1\t-2,25\n" })
  {
    EXPECT_NE(parse(text).Status.Message.find("DecimalComma"), std::string::npos) << text;
  }
}

TEST(TextCloudParser, CommasBetweenSemicolonsAreDecimal)
{
  for (const char* text : { "0,5;1;-2,25\n", "x;y;z\r\n0,5; 1; -2,25\r\n" })
  {
    EXPECT_EQ(values<double>(parse(text).Data.Points), (std::vector<double>{ 0.5, 1, -2.25 }));
  }
  for (const char* text : { "0,5;1;2.5\n", "0,5;1;a\n" })
  {
    EXPECT_FALSE(parse(text).Status.ok()) << text;
  }
}

TEST(TextCloudParser, RefusesWhatIsNoPointWithItsLine)
{
  for (const char* word : { "1.2.3", "--5", "0x1p3", "1e999", "1,5", "one", "5 5", "" })
  {
    ExpectRefused(samples::replaced(samples::PlainCloud(), "1234567.123456789", word),
      ParseCode::Malformed, 2, "found \"");
  }
  ExpectRefused("", ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused("# nothing\n", ParseCode::UnrecognizedType, 1, "no points");
  ExpectRefused("1 2\n", ParseCode::UnrecognizedType, 1, "3 to 1000 numbers");
  ExpectRefused("a b c\n1 2 3\n", ParseCode::UnrecognizedType, 1, "names");
  ExpectRefused(std::string("1 2 3\n\0\1", 8), ParseCode::UnrecognizedType, 2, "text");
  std::string colors = "0 0 0 1 2 3\n";
  for (int i = 0; i < 7; ++i)
  {
    colors += colors;
  }
  ExpectRefused(colors + "0 0 0 1 2 256\n", ParseCode::Malformed, 129, "colors");
}

TEST(TextCloudParser, NamesWhatIsWrongWithALine)
{
  const auto expectMessage = [](const std::string& line, const std::string& message)
  { ExpectRefused("1 2 3 0.5 7 8\n" + line + "\n", ParseCode::Malformed, 2, message); };
  expectMessage("1 2 3 4 5",
    "found \"1 2 3 4 5\" with 5 columns, expected 6 columns as in the first line of numbers");
  expectMessage("1 2 3 4 5 6 7", "with 7 columns, expected 6 columns");
  expectMessage("1", "with 1 column, expected 6 columns");
  expectMessage("1 2 3 x 5 6", "with \"x\" in column 4, expected 6 numbers");
  expectMessage("1 2 3 0,5 5 6", "set DecimalComma");
  ExpectRefused("1;2;3\n1;2\n", ParseCode::Malformed, 2,
    "with 2 columns, expected 3 columns between \";\" as in the first line of numbers");
  ExpectRefused(
    "x,y,z\n1,2,3\n1,,3\n", ParseCode::Malformed, 3, "with \"\" in column 2, expected 3 numbers");
  ExpectRefused("x,y,z\n\"1\",\"2\",\"3\"\n", ParseCode::Malformed, 2,
    "in column 1, expected 3 numbers without quotation marks");
  ExpectRefused("2\n1 2 3\n1 2 3 4\n", ParseCode::Malformed, 3, "with 4 columns, expected 3");
  ExpectRefused("2\ncomment\n1 2 3\n1 2 4\n", ParseCode::UnrecognizedType, 2, "comment");
}

TEST(TextCloudParser, FractionsAfterColorsAreRefused)
{
  std::string text;
  for (int i = 0; i < 120; ++i)
  {
    text += "0 0 0 1 1 1\n";
  }
  ExpectRefused(text + "5 5 5 0.5 0.7 0.2\n", ParseCode::Malformed, 121, "integers in 0..255");
}

TEST(TextCloudParser, CountsWhatItLeavesOut)
{
  conformal::TextCloudOptions options;
  options.SkipMalformedLines = true;
  const SurfaceResult result = parse("1 2 3\nnan 0 0\nx\n4 5 6\n0 0 -inf\n1 2\n", options);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(values<double>(result.Data.Points), (std::vector<double>{ 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(result.Data.DroppedPoints, 2u);
  EXPECT_EQ(result.Data.SkippedLines, 2u);
  const SurfaceResult counted = parse("3\n0 0 0\nbad\n1 1 1\n1\n2 2 2\n", options);
  ASSERT_TRUE(counted.Status.ok()) << counted.Status.text();
  EXPECT_EQ(counted.Data.Points.numberOfTuples(), 3u);
  EXPECT_EQ(counted.Data.SkippedLines, 1u);
  const SurfaceResult replaced = parse("1 2 3 nan\n");
  EXPECT_EQ(replaced.Data.ReplacedValues, 1u);
}

TEST(TextCloudParser, ReadsTheSameFromPiecesAsFromMemory)
{
  std::string bytes;
  for (int i = 0; i < 200000; ++i)
  {
    bytes += std::to_string(i * 0.37) + " " + std::to_string(-i) + " 0." + std::to_string(i) +
      (i % 3 == 0 ? "\r\n" : "\n");
  }
  conformal::ByteReader pieces = samples::InPieces(bytes);
  const SurfaceResult windowed = conformal::parseTextCloud(pieces);
  const SurfaceResult whole = parse(bytes);
  ASSERT_TRUE(windowed.Status.ok()) << windowed.Status.text();
  EXPECT_EQ(whole.Data.Points.numberOfTuples(), 200000u);
  EXPECT_TRUE(samples::AreSame(windowed.Data.Points, whole.Data.Points));
  conformal::ByteReader broken = samples::InPieces(bytes + "x");
  EXPECT_EQ(conformal::parseTextCloud(broken).Status.Line, 200001u);
}

TEST(TextCloudParser, ReportsProgressAndStops)
{
  std::string bytes;
  for (int i = 0; i < 10000; ++i)
  {
    bytes += "0 0 0\n";
  }
  int calls = 0;
  conformal::ByteReader input{ std::string_view(bytes) };
  const SurfaceResult result = conformal::parseTextCloud(
    input, {}, {}, conformal::Run({}, [&](double) { return ++calls < 20; }));
  EXPECT_EQ(result.Status.Code, ParseCode::Aborted);
  EXPECT_EQ(calls, 20);
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
}

TEST(TextCloudParser, IsKnownByItsFirstLines)
{
  for (const std::string& file : samples::TextCloudFiles())
  {
    EXPECT_TRUE(conformal::looksLikeTextCloud(file)) << file;
  }
  for (const char* other : { "", "5\n", "1 2\n", "1 2 3\n1 2\n1 2\n", "a b c\n", "# x y z\n",
         "x y z\n", "v 0 0 0\n", "3\nwater\nO 0 0 0\n" })
  {
    EXPECT_FALSE(conformal::looksLikeTextCloud(other)) << other;
  }
}

// Pieces for several processes ---------------------------------------------------------------

namespace
{
samples::ParsePiece piecesOf(bool skipMalformedLines = false)
{
  return [=](conformal::ByteReader& input, const conformal::FilePiece& piece)
  {
    conformal::TextCloudOptions options;
    options.SkipMalformedLines = skipMalformedLines;
    options.Piece = piece;
    return conformal::parseTextCloud(input, options);
  };
}

// Lines of many lengths, remarks and blank lines among them, a point that is not finite.
std::string Lines(const std::string& head, const std::string& end)
{
  std::string text = head;
  for (int i = 0; i < 23; ++i)
  {
    text += std::to_string(i * i * i) + " 0." + std::to_string(i) + " 7 " + std::to_string(i) + end;
    text += i % 5 == 2 ? "# a remark with 1 2 3 4" + end + end : "";
    text += i == 11 ? "nan 1 2 3" + end : "";
  }
  return text;
}
}

TEST(TextCloudParser, PiecesMakeTheWholeForEveryLineEnd)
{
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    for (const std::string head : { "", "\xEF\xBB\xBF", "# x y z age" })
    {
      const std::string text = Lines(head == "# x y z age" ? head + end : head, end);
      samples::ExpectPiecesMakeTheWhole(text, piecesOf());
      samples::ExpectPiecesMakeTheWhole(text.substr(0, text.size() - end.size()), piecesOf());
    }
    samples::ExpectPiecesMakeTheWhole(
      Lines("// long remark before the names" + end + "x y z age" + end, end), piecesOf());
    samples::ExpectPiecesMakeTheWhole("1 2 3" + end + "4 5 6" + end, piecesOf());
  }
}

TEST(TextCloudParser, PiecesCutAtEveryByte)
{
  const std::string text = "x y z\r\n1 2 3\r\n\r\n44 55 66\r\n7 8 9";
  for (std::uint64_t count = 1; count < 2 * text.size(); ++count)
  {
    std::vector<double> points;
    for (std::uint64_t number = 0; number < count; ++number)
    {
      conformal::ByteReader input{ std::string_view(text) };
      const SurfaceResult piece = piecesOf()(input, { number, count });
      ASSERT_TRUE(piece.Status.ok()) << piece.Status.text();
      const std::vector<double> own = values<double>(piece.Data.Points);
      points.insert(points.end(), own.begin(), own.end());
    }
    ASSERT_EQ(points, (std::vector<double>{ 1, 2, 3, 44, 55, 66, 7, 8, 9 })) << count;
  }
}

TEST(TextCloudParser, PiecesSkipTheLinesTheWholeSkips)
{
  samples::ExpectPiecesMakeTheWhole(
    "1 2 3\n4 5 6\nno point\n7 8 9\n1 2\n10 11 12\n", piecesOf(true));
}

TEST(TextCloudParser, TextWithACountIsAllInTheFirstPiece)
{
  const std::string text = "2\n1 2 3\n4 5 6\n1\n7 8 9\n";
  samples::ExpectPiecesMakeTheWhole(text, piecesOf());
  conformal::ByteReader input{ std::string_view(text) };
  EXPECT_EQ(piecesOf()(input, { 1, 2 }).Data.Points.numberOfTuples(), 0u);
}

TEST(TextCloudParser, PiecesReadTheirShare)
{
  std::string text;
  while (text.size() < (std::size_t(36) << 20))
  {
    text += "1.25 2.5 -3.75 0.5\n";
  }
  samples::ExpectPiecesReadTheirShare(text, piecesOf());
}

TEST(TextCloudParser, OnlyThePieceWithABadLineIsRefused)
{
  const std::string text = "1 2 3\n4 5 6\n7 8 9\n10 11\n";
  for (std::uint64_t number = 0; number < 2; ++number)
  {
    conformal::ByteReader input{ std::string_view(text) };
    const SurfaceResult piece = piecesOf()(input, { number, 2 });
    EXPECT_EQ(piece.Status.ok(), number == 0);
    if (number == 1)
    {
      EXPECT_EQ(piece.Status.Line, 0u); // nobody counted those before
      EXPECT_EQ(piece.Status.Offset, 18u);
    }
  }
}
