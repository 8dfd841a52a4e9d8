#include "PCD/PCDParser.h"

#include "../../CommaLocale.h"
#include "../Bytes/FilePieces.h"
#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "PCD/LZFDecoder.h"
#include "PCD/PCDHeader.h"
#include "PCDSamples.h"

#include <random>

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceResult;
using samples::ExpectArray;
using samples::replaced;
using samples::values;

namespace
{
SurfaceResult parse(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parsePCD(input);
}

void ExpectAscii(const std::string& bytes)
{
  const SurfaceResult result = parse(bytes);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(values<float>(result.Data.Points), (std::vector<float>{ 0.5F, 1.5F, 2.5F, 7, 8, 9 }));
  ExpectArray<std::uint8_t>(
    result.Data.PointArrays, "RGB", ScalarType::UInt8, 3, { 1, 2, 3, 255, 0, 0 });
  ExpectArray<std::int16_t>(result.Data.PointArrays, "label", ScalarType::Int16, 1, { -1, 32767 });
  EXPECT_EQ(result.Data.DroppedPoints, 0u);
}

void ExpectRich(const std::string& bytes)
{
  const SurfaceResult result = parse(bytes);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  const auto& arrays = result.Data.PointArrays;
  EXPECT_EQ(values<float>(result.Data.Points),
    (std::vector<float>{ 0, 1, 0.1F, 1, 1, 0.1F, 1.5F, 1, 0.1F }));
  ExpectArray<float>(arrays, "Normals", ScalarType::Float32, 3, { 0, 0, 1, 0, 0, 1, 0, 0, 1 });
  ExpectArray<std::uint8_t>(
    arrays, "RGBA", ScalarType::UInt8, 4, { 1, 2, 3, 128, 1, 2, 5, 128, 1, 2, 6, 128 });
  ExpectArray<std::int16_t>(arrays, "pair", ScalarType::Int16, 2, { 0, 300, -2, 300, -3, 300 });
  const std::uint64_t stamp = std::uint64_t(1) << 40;
  ExpectArray<std::uint64_t>(
    arrays, "stamp", ScalarType::UInt64, 1, { stamp, stamp + 2, stamp + 3 });
  EXPECT_EQ(arrays.size(), 4u);
}

void ExpectRefused(
  const std::string& bytes, ParseCode code, std::uint64_t line, const std::string& part)
{
  const SurfaceResult result = parse(bytes);
  EXPECT_EQ(result.Status.Code, code) << result.Status.text() << "\n" << bytes.substr(0, 300);
  EXPECT_EQ(result.Status.Line, line) << result.Status.text() << "\n" << bytes.substr(0, 300);
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
}

std::string decompressed(const std::string& compressed, std::size_t size)
{
  conformal::ByteReader input{ std::string_view(compressed) };
  conformal::LZFDecoder decoder(input, compressed.size());
  std::string result(size, '\0');
  for (std::size_t at = 0, step = 1; at < size; at += step, step = step * 5 % 97 + 1)
  {
    step = std::min(step, size - at);
    decoder.read(&result[at], step);
  }
  decoder.end();
  return result;
}
}

TEST(PCDParser, ReadsAsciiFilesHoweverTheyAreWritten)
{
  const CommaLocale locale;
  const std::string& ascii = samples::AsciiPCD();
  ExpectAscii(ascii);
  for (const std::string end : { "\r\n", "\r", "\n\n", " \t\n" })
  {
    ExpectAscii(replaced(ascii, "\n", end));
  }
  ExpectAscii("\xEF\xBB\xBF" + ascii);
  ExpectAscii(ascii.substr(0, ascii.size() - 1));
  ExpectAscii(replaced(ascii, "WIDTH 3\nHEIGHT 1\n", ""));
  ExpectAscii(replaced(ascii, "POINTS 3\n", ""));
  ExpectAscii(replaced(ascii, "COUNT 1 1 1 1 1\n", "# " + std::string(1 << 20, '#') + "\n"));
  // Colors that claim to be a float: their bits are the color.
  ExpectAscii(
    replaced(replaced(replaced(ascii, "F F F U I", "F F F F I"), "66051", "9.2557137e-41"),
      "16711680", "2.3418051e-38"));
}

TEST(PCDParser, ColorsThatAreNoNumbersAreBlack)
{
  const std::string text =
    replaced(replaced(samples::AsciiPCD(), "F F F U I", "F F F F I"), "66051", "nan");
  conformal::ByteReader input(text);
  const SurfaceResult result = conformal::parsePCD(input);
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  EXPECT_EQ(result.Data.ReplacedValues, 1u);
  const conformal::NamedArray& colors = result.Data.PointArrays.front();
  ASSERT_EQ(colors.Name, "RGB");
  EXPECT_EQ(values<std::uint8_t>(colors)[0], 0);
}

TEST(PCDParser, ReadsBinaryAndCompressedFiles)
{
  ExpectRich(samples::BinaryPCD());
  ExpectRich(samples::CompressedPCD());
  const std::string packed = samples::Bytes(false, "FIELDS x y z\nPOINTS 1\nDATA binary\n")
                               .add(std::vector<float>{ 1, 2, 3 })
                               .bytes();
  EXPECT_EQ(values<float>(parse(packed).Data.Points), (std::vector<float>{ 1, 2, 3 }));
  const std::string mixed =
    samples::Bytes(false, "FIELDS x y z\nSIZE 4 8 2\nTYPE F F I\nPOINTS 1\nDATA binary\n")
      .add(0.5F)
      .add(0.1)
      .add<std::int16_t>(-3)
      .bytes();
  EXPECT_EQ(values<double>(parse(mixed).Data.Points), (std::vector<double>{ 0.5, 0.1, -3 }));
  const SurfaceResult empty = parse("FIELDS x y z\nPOINTS 0\nDATA binary_compressed\n");
  EXPECT_TRUE(empty.Status.ok()) << empty.Status.text();
}

TEST(PCDParser, ViewpointIsThePositionOfTheScanner)
{
  const std::string& ascii = samples::AsciiPCD();
  using Numbers = std::vector<double>;
  const auto scannerWith = [&](
                             const std::string& line, const std::string& size = "WIDTH 3\nHEIGHT 1")
  {
    const SurfaceResult result =
      parse(replaced(replaced(ascii, "VIEWPOINT 0 0 0 1 0 0 0", line), "WIDTH 3\nHEIGHT 1", size));
    EXPECT_TRUE(result.Status.ok()) << result.Status.text();
    return result.Data.ScannerPosition;
  };
  EXPECT_EQ(scannerWith("VIEWPOINT 1 -2 3.5 1 0 0 0"), (Numbers{ 1, -2, 3.5 }));
  EXPECT_EQ(scannerWith("VIEWPOINT 0 0 0 1 0 0 0"), Numbers());
  EXPECT_EQ(scannerWith("VIEWPOINT 0 0 0 1 0 0 0", "WIDTH 1\nHEIGHT 3"), (Numbers{ 0, 0, 0 }));
  for (const char* line : { "# no viewpoint", "VIEWPOINT", "VIEWPOINT 1 nan 2", "VIEWPOINT a b c" })
  {
    EXPECT_EQ(scannerWith(line), Numbers()) << line;
  }
}

TEST(PCDParser, EveryTruncationOfBinaryDataIsRefused)
{
  for (const std::string& file : { samples::BinaryPCD(), samples::CompressedPCD() })
  {
    const std::size_t body = file.find('\n', file.find("DATA")) + 1;
    for (std::size_t size = 0; size < file.size(); ++size)
    {
      const SurfaceResult result = parse(file.substr(0, size));
      EXPECT_FALSE(result.Status.ok()) << size;
      if (size >= body)
      {
        EXPECT_EQ(result.Status.Code, ParseCode::PrematureEnd) << result.Status.text();
      }
    }
  }
}

TEST(PCDParser, RefusesHeadersThatAreWrong)
{
  const std::string& ascii = samples::AsciiPCD();
  const auto refuse = [&](const char* from, const char* to, std::uint64_t line, const char* part)
  { ExpectRefused(replaced(ascii, from, to), ParseCode::Malformed, line, part); };
  ExpectRefused("", ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused("OFF\n", ParseCode::UnrecognizedType, 1, "keyword");
  ExpectRefused(ascii.substr(0, ascii.find("DATA")), ParseCode::PrematureEnd, 11, "DATA");
  refuse("VERSION .7", "VERSION .8", 2, "version");
  refuse("SIZE", "SIZES", 4, "keyword");
  refuse("HEIGHT 1", "WIDTH 1", 8, "once");
  refuse("WIDTH 3", "WIDTH -3", 7, "count");
  refuse("WIDTH 3", "WIDTH 4", 11, "WIDTH times HEIGHT");
  refuse("HEIGHT 1", "HEIGHT 18446744073709551615", 11, "WIDTH times HEIGHT");
  refuse("WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\n", "", 7, "POINTS");
  refuse("SIZE 4 4 4 4 2", "SIZE 4 4 4 4", 11, "SIZE");
  refuse("SIZE 4 4 4 4 2", "SIZE 4 4 4 4 3", 11, "types");
  refuse("SIZE 4 4 4 4 2", "SIZE 4 4 4 4 -2", 4, "greater than 0");
  refuse("TYPE F F F U I", "TYPE F F F U X", 11, "types");
  refuse("TYPE F F F U I", "TYPE F F F U II", 5, "types");
  refuse("COUNT 1 1 1 1 1", "COUNT 1 1 1 1 4000000000", 11, "100000");
  refuse("COUNT 1 1 1 1 1", "COUNT 2 1 1 1 1", 12, "x, y and z");
  refuse("FIELDS x y z", "FIELDS x y w", 12, "x, y and z");
  refuse("ascii", "text", 11, "binary_compressed");
}

TEST(PCDParser, NamesOfFieldsAreThereOnceButForPadding)
{
  const std::string& ascii = samples::AsciiPCD();
  for (const char* fields : { "x x z rgb label", "x y z x label", "x y z label label" })
  {
    const std::string twice = std::string(fields)[0] == 'x' && fields[6] != 'l' ? "x" : "label";
    ExpectRefused(replaced(ascii, "x y z rgb label", fields), ParseCode::Malformed, 3,
      "two fields \"" + twice + "\"");
  }
  const SurfaceResult padded = parse("FIELDS _ x y _ z _\nPOINTS 1\nDATA ascii\n9 1 2 9 3 9\n");
  EXPECT_EQ(values<float>(padded.Data.Points), (std::vector<float>{ 1, 2, 3 }));
  EXPECT_TRUE(padded.Data.PointArrays.empty());
  // Colors become RGB, whatever else is called so.
  const SurfaceResult colors = parse(
    "FIELDS x y z RGB rgb\nTYPE F F F F U\nSIZE 4 4 4 4 4\nPOINTS 1\nDATA ascii\n1 2 3 4 66051\n");
  ASSERT_EQ(colors.Data.PointArrays.size(), 2u);
  ExpectArray<float>(colors.Data.PointArrays, "RGB", ScalarType::Float32, 1, { 4 });
  ExpectArray<std::uint8_t>(colors.Data.PointArrays, "RGB2", ScalarType::UInt8, 3, { 1, 2, 3 });
}

TEST(PCDParser, CompressedPointsAreCountedBeforeThereIsMemoryForThem)
{
  const std::string compressed = samples::CompressedPCD();
  for (const char* count : { "5", "300000", "3000000000000", "30000000000000000" })
  {
    ExpectRefused(replaced(compressed, "POINTS 4", std::string("POINTS ") + count),
      ParseCode::Malformed, 0, "expected " + std::to_string(40 * std::stoull(count)));
  }
  // Padding is not in the block.
  const std::string point = samples::Bytes(false).add(std::vector<float>{ 1, 2, 3 }).bytes();
  const std::string block = samples::CompressedLZF(point);
  const std::string wide =
    samples::Bytes(false, "FIELDS x y z _\nCOUNT 1 1 1 1000\nPOINTS 1\nDATA binary_compressed\n")
      .add(static_cast<std::uint32_t>(block.size()))
      .add(static_cast<std::uint32_t>(point.size()))
      .text(block)
      .bytes();
  EXPECT_EQ(values<float>(parse(wide).Data.Points), (std::vector<float>{ 1, 2, 3 }));
}

TEST(PCDParser, RefusesBodiesThatAreWrong)
{
  const std::string& ascii = samples::AsciiPCD();
  const auto refuse = [&](const char* from, const char* to, std::uint64_t line, const char* part)
  { ExpectRefused(replaced(ascii, from, to), ParseCode::Malformed, line, part); };
  for (const char* word : { "1.2.3", "--5", "0x1p3", "1e999", "1,5", "one" })
  {
    refuse("1.5", word, 12, word);
  }
  refuse("7 8 9 16711680 32767", "7 8 9 16711680 32768", 14, "32768");
  refuse("7 8 9 16711680 32767", "7 8 9 16711680 32767 1", 14, "after the 5 numbers of a record");
  refuse("7 8 9 16711680 32767", "7 8 9 16711680 32767\n1", 15, "end of the file");
  refuse(
    "WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3", "POINTS 4000000000", 9, "4000000000");
  ExpectRefused(ascii.substr(0, ascii.size() - 7), ParseCode::PrematureEnd, 14, "ends");
  const std::string compressed = samples::CompressedPCD();
  const std::size_t body = compressed.find('\n', compressed.find("DATA")) + 1;
  const auto sizes = [&](std::uint32_t less, std::uint32_t more)
  {
    return compressed.substr(0, body) + samples::Bytes(false).add(less).add(more).bytes() +
      compressed.substr(body + 8);
  };
  const auto size = static_cast<std::uint32_t>(compressed.size() - body - 8);
  const std::uint32_t whole = 4 * 40;
  EXPECT_TRUE(parse(sizes(size, whole)).Status.ok());
  ExpectRefused(sizes(size, whole + 1), ParseCode::Malformed, 0, "expected 160");
  ExpectRefused(sizes(1, whole), ParseCode::Malformed, 0, "expected 160");
  ExpectRefused(sizes(size - 1, whole), ParseCode::Malformed, 0, "shorter than the header");
  ExpectRefused(sizes(size + 1, whole), ParseCode::PrematureEnd, 0, "bytes");
  ExpectRefused(sizes(size + 1, whole) + "x", ParseCode::Malformed, 0, "after the last point");
}

TEST(PCDParser, DecompressesWhatWasCompressed)
{
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i)
  {
    std::string bytes;
    while (bytes.size() < static_cast<std::size_t>(i * 700))
    {
      const bool isNew = bytes.empty() || random() % 3 == 0;
      const std::size_t length = 1 + random() % 300;
      for (std::size_t j = 0, from = random() % (bytes.size() + 1); j < length; ++j)
      {
        bytes += isNew || from == bytes.size() ? static_cast<char>(random()) : bytes[from++];
      }
    }
    EXPECT_TRUE(decompressed(samples::CompressedLZF(bytes), bytes.size()) == bytes) << i;
  }
  EXPECT_EQ(decompressed({ 0, 'a', '\xE0', 1, 0 }, 11), std::string(11, 'a')); // over itself
  EXPECT_THROW(decompressed({ 0, 'a', 32, 1 }, 4), conformal::ParseError);
}

TEST(PCDParser, ReadsTheSameFromPiecesAsFromMemory)
{
  const std::uint32_t count = 120000;
  const std::string head =
    "FIELDS x y z n\nSIZE 4 4 4 8\nTYPE F F F F\nPOINTS " + std::to_string(count) + "\nDATA ";
  samples::Bytes bytes(false, head + "binary\n");
  std::string text = head + "ascii\n";
  for (std::uint32_t i = 0; i < count; ++i)
  {
    bytes.add(static_cast<float>(i)).add(0.5F).add(-static_cast<float>(i)).add(i * 0.25);
    text +=
      std::to_string(i) + " 0.5 -" + std::to_string(i) + " " + std::to_string(i * 0.25) + "\n";
  }
  const SurfaceResult whole = parse(bytes.bytes());
  for (const std::string& file : { bytes.bytes(), text })
  {
    conformal::ByteReader pieces = samples::InPieces(file);
    const SurfaceResult windowed = conformal::parsePCD(pieces);
    ASSERT_TRUE(windowed.Status.ok()) << windowed.Status.text();
    EXPECT_TRUE(samples::AreSame(windowed.Data.Points, whole.Data.Points));
    EXPECT_TRUE(samples::AreSame(windowed.Data.PointArrays[0], whole.Data.PointArrays[0]));
  }
}

TEST(PCDParser, IsKnownByItsFirstLines)
{
  for (const std::string& file : samples::PCDFiles())
  {
    EXPECT_TRUE(conformal::looksLikePCD(file)) << file;
  }
  for (const char* other : { "", "# .PCD\n", "VERSION\n", "VERSION 3\n", "FIELDS\n", "x y z\n" })
  {
    EXPECT_FALSE(conformal::looksLikePCD(other)) << other;
  }
}

TEST(PCDParser, PiecesMakeTheWhole)
{
  const auto parsePiece = [](conformal::ByteReader& input, const conformal::FilePiece& piece)
  { return conformal::parsePCD(input, piece); };
  samples::ExpectPiecesMakeTheWhole(samples::BinaryPCD(), parsePiece);
  samples::ExpectPiecesMakeTheWhole(samples::AsciiPCD(), parsePiece);

  constexpr std::size_t count = 3000000;
  const std::string number = std::to_string(count);
  const std::string large =
    "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + number +
    "\nHEIGHT 1\nPOINTS " + number + "\nDATA binary\n" + std::string(12 * count, '\1');
  samples::ExpectPiecesReadTheirShare(large, parsePiece);
}
