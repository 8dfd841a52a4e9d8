// Check for all parsers that the pieces of a file together equal the whole file.
#ifndef FilePieces_h
#define FilePieces_h

#include "Bytes/ByteReader.h"
#include "Bytes/FilePiece.h"
#include "ParsedArrays.h"

#include <cstring>
#include <functional>
#include <memory>
#include <string>

namespace samples
{
/// Return a reader of bytes that works as for a file. The number of bytes read is counted in
/// `numberRead`.
inline conformal::ByteReader InFile(const std::string& bytes, std::size_t& numberRead)
{
  auto position = std::make_shared<std::size_t>(0);
  numberRead = 0;
  return conformal::ByteReader(
    [&bytes, &numberRead, position](char* buffer, std::size_t size)
    {
      const std::size_t count = std::min(size, bytes.size() - *position);
      std::memcpy(buffer, bytes.data() + *position, count);
      *position += count;
      numberRead += count;
      return count;
    },
    bytes.size(), [position](std::uint64_t offset) { *position = offset; });
}

using ParsePiece =
  std::function<conformal::SurfaceResult(conformal::ByteReader&, const conformal::FilePiece&)>;

inline std::string bytesOf(const conformal::NamedArray& array)
{
  return std::string(reinterpret_cast<const char*>(array.Values.data()), array.Values.size());
}

/// Divide a file into different numbers of pieces. Expect that each piece has all arrays. The
/// values of consecutive pieces must equal the values of the whole file.
inline void ExpectPiecesMakeTheWhole(const std::string& bytes, const ParsePiece& parse)
{
  std::size_t numberRead = 0;
  conformal::ByteReader file = InFile(bytes, numberRead);
  const conformal::SurfaceResult whole = parse(file, {});
  ASSERT_TRUE(whole.Status.ok()) << whole.Status.text();
  const std::size_t arrays = whole.Data.PointArrays.size();
  for (std::uint64_t count = 1; count < 40; count += count < 5 ? 1 : 11)
  {
    std::string points;
    std::vector<std::string> values(arrays);
    std::uint64_t dropped = 0, skipped = 0;
    std::size_t polygons = 0;
    for (std::uint64_t number = 0; number < count; ++number)
    {
      conformal::ByteReader input = InFile(bytes, numberRead);
      const conformal::SurfaceResult piece = parse(input, { number, count });
      ASSERT_TRUE(piece.Status.ok()) << piece.Status.text();
      ASSERT_EQ(piece.Data.Points.Type, whole.Data.Points.Type);
      ASSERT_EQ(piece.Data.PointArrays.size(), arrays);
      points += bytesOf(piece.Data.Points);
      for (std::size_t i = 0; i < arrays; ++i)
      {
        ASSERT_EQ(piece.Data.PointArrays[i].Name, whole.Data.PointArrays[i].Name);
        ASSERT_EQ(piece.Data.PointArrays[i].Type, whole.Data.PointArrays[i].Type);
        values[i] += bytesOf(piece.Data.PointArrays[i]);
      }
      dropped += piece.Data.DroppedPoints;
      skipped += piece.Data.SkippedLines;
      polygons += piece.Data.PolygonIds.size();
    }
    EXPECT_EQ(points, bytesOf(whole.Data.Points)) << count;
    for (std::size_t i = 0; i < arrays; ++i)
    {
      EXPECT_EQ(values[i], bytesOf(whole.Data.PointArrays[i])) << count;
    }
    EXPECT_EQ(dropped, whole.Data.DroppedPoints);
    EXPECT_EQ(skipped, whole.Data.SkippedLines);
    EXPECT_EQ(polygons, whole.Data.PolygonIds.size());
  }
}

/// Divide a large file into 4 pieces. Expect that the parser of each piece reads about a quarter of
/// the bytes. The parser may also read the bytes that identify the format, and two windows of the
/// reader.
inline void ExpectPiecesReadTheirShare(const std::string& bytes, const ParsePiece& parse)
{
  constexpr std::uint64_t count = 4;
  constexpr std::size_t sample = std::size_t(4) << 20, window = std::size_t(1) << 20;
  ASSERT_GT(bytes.size(), 8 * sample);
  for (std::uint64_t number = 0; number < count; ++number)
  {
    std::size_t numberRead = 0;
    conformal::ByteReader input = InFile(bytes, numberRead);
    const conformal::SurfaceResult piece = parse(input, { number, count });
    ASSERT_TRUE(piece.Status.ok()) << piece.Status.text();
    EXPECT_LT(numberRead, bytes.size() / count + sample + 2 * window);
    EXPECT_NEAR(static_cast<double>(numberRead), static_cast<double>(bytes.size()) / count,
      static_cast<double>(sample + 2 * window));
  }
}
}

#endif
