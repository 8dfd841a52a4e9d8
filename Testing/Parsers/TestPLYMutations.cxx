// A smoke test; whatever happens to a valid file, the parser ends with a status, and what it
// gives is whole.
#include "PLYParser.h"

#include "PLYSamples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
conformal::SurfaceResult parsePLY(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parsePLY(input);
}

// Numbers that break readers.
const char* const Words[] = { "-1", "0", "4294967295", "18446744073709551615", "nan", "1e999", "x",
  "3", "255", "list", "double", "face", "tristrips", "\n", "\r", "\t" };

std::string mutated(std::string bytes, std::mt19937& random)
{
  const auto below = [&](std::size_t count) { return random() % std::max<std::size_t>(1, count); };
  const std::size_t changes = 1 + below(3);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i)
  {
    // Most of a small file is header: every second change is one of the body.
    const std::size_t body = std::min(bytes.find("end_header"), bytes.size() - 1);
    const std::size_t begin = below(2) == 0 ? 0 : body;
    const std::size_t at = begin + below(bytes.size() - begin);
    switch (below(7))
    {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(random());
        break;
      case 2:
        bytes.erase(at, 1 + below(9));
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(bytes.size()), below(30)));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:
        bytes.insert(at, Words[below(std::size(Words))]);
        break;
      default: // a word for a word
      {
        const std::size_t word = std::min(bytes.find_first_of(" \n", at), bytes.size() - 1) + 1;
        const std::size_t end = std::min(bytes.find_first_of(" \n", word), bytes.size());
        bytes.replace(word, end - word, Words[below(std::size(Words))]);
      }
    }
  }
  return bytes;
}

template <typename T>
void ExpectFinite(const conformal::NamedArray& array)
{
  for (std::size_t i = 0; i < array.Values.size(); i += sizeof(T))
  {
    T value;
    std::memcpy(&value, array.Values.data() + i, sizeof(T));
    ASSERT_TRUE(std::isfinite(value)) << array.Name;
  }
}

void ExpectWhole(const conformal::NamedArray& array, std::size_t tuples)
{
  ASSERT_EQ(array.numberOfTuples(), tuples) << array.Name;
  if (array.Type == conformal::ScalarType::Float32)
  {
    ExpectFinite<float>(array);
  }
  else if (array.Type == conformal::ScalarType::Float64)
  {
    ExpectFinite<double>(array);
  }
}

void ExpectWhole(const conformal::SurfaceData& data)
{
  const std::size_t points = data.Points.numberOfTuples();
  ExpectWhole(data.Points, points);
  for (const conformal::NamedArray& array : data.PointArrays)
  {
    ExpectWhole(array, points);
  }
  const std::size_t polygons = data.PolygonOffsets.size() - 1;
  for (const conformal::NamedArray& array : data.PolygonArrays)
  {
    ExpectWhole(array, polygons);
  }
  ASSERT_EQ(data.PolygonOffsets[0], 0);
  ASSERT_EQ(data.PolygonOffsets[polygons], static_cast<std::int64_t>(data.PolygonIds.size()));
  for (std::size_t i = 0; i < polygons; ++i)
  {
    ASSERT_GE(data.PolygonOffsets[i + 1], data.PolygonOffsets[i] + 3);
  }
  for (std::size_t i = 0; i < data.PolygonIds.size(); ++i)
  {
    ASSERT_GE(data.PolygonIds[i], 0);
    ASSERT_LT(data.PolygonIds[i], static_cast<std::int64_t>(points));
  }
}
}

TEST(PLYMutations, EndInAStatusAndWholeData)
{
  const std::string files[] = { samples::AsciiMesh(), samples::AsciiCloud(), samples::AsciiStrips(),
    samples::AsciiGrid(), samples::BinaryMesh(false), samples::BinaryMesh(true),
    samples::BinaryCloud(true) };
  int refused = 0;
  int read = 0;
  for (std::uint32_t seed = 0; seed < 3000; ++seed)
  {
    std::mt19937 random(seed);
    const std::string bytes = mutated(files[seed % std::size(files)], random);
    SCOPED_TRACE(seed);
    const conformal::SurfaceResult result = parsePLY(bytes);
    if (result.Status.ok())
    {
      ++read;
      ExpectWhole(result.Data);
    }
    else
    {
      ++refused;
      ASSERT_FALSE(result.Status.Message.empty());
      ASSERT_LE(result.Status.Offset, bytes.size());
    }
  }
  // Mutations that all fail in the header, or all do nothing, would test little.
  EXPECT_GT(read, 200);
  EXPECT_GT(refused, 200);
}
