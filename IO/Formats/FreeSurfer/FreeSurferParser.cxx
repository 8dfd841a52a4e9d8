#include "FreeSurfer/FreeSurferParser.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FileValues.h"
#include "Bytes/PolygonList.h"
#include "Bytes/ProgressReport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace conformal
{
namespace
{
constexpr std::uint32_t TriangleMagic = 0xFFFFFE;
constexpr std::uint32_t QuadMagic = 0xFFFFFF; // also the magic number of new curv files
constexpr std::uint32_t NewQuadMagic = 0xFFFFFD;
constexpr std::size_t MagicBytes = 3;
constexpr float OldUnit = 100.0F; // old files store hundredths

std::uint32_t magicOf(std::string_view start)
{
  std::uint32_t magic = 0;
  for (std::size_t i = 0; i < MagicBytes && i < start.size(); ++i)
  {
    magic = magic << 8 | static_cast<unsigned char>(start[i]);
  }
  return start.size() < MagicBytes ? 0 : magic;
}

class FreeSurferReader
{
public:
  FreeSurferReader(ByteReader& input, const ParseLimits& limits, const Run& run, SurfaceData& data)
    : Input(input)
    , Limits(limits)
    , Data(data)
    , Progress(input, run)
    , Values(input, isLittleEndianMachine())
  {
    input.beginBinary();
    input.requireBytes();
  }

  void readSurface()
  {
    const std::uint32_t magic = magicOf(this->Input.peek(MagicBytes));
    if (magic == TriangleMagic)
    {
      this->Input.advance(MagicBytes);
      this->skipLine(); // author and date
      this->skipLine();
      const std::uint64_t points = this->count();
      const std::uint64_t faces = this->count();
      this->readPoints<float>(points, 1.0F);
      this->readFaces(points, faces, 3, sizeof(std::int32_t));
    }
    else if (magic == QuadMagic || magic == NewQuadMagic)
    {
      this->Input.advance(MagicBytes);
      const std::uint64_t points = this->next24();
      const std::uint64_t faces = this->next24();
      if (magic == QuadMagic)
      {
        this->readPoints<std::int16_t>(points, OldUnit);
      }
      else
      {
        this->readPoints<float>(points, 1.0F);
      }
      this->readFaces(points, faces, 4, MagicBytes);
    }
    else
    {
      this->Input.fail(ParseCode::UnrecognizedType,
        "found " + quoted(this->Input.peek(MagicBytes).substr(0, MagicBytes)) +
          ", expected the first bytes of a FreeSurfer surface");
    }
  }

  void readCurv()
  {
    std::uint64_t points = this->next24();
    const bool isNew = points == QuadMagic;
    if (isNew)
    {
      points = this->count();
      this->count(); // number of faces
      const auto values = this->Values.next<std::int32_t>();
      if (values != 1)
      {
        this->Input.fail(ParseCode::Malformed,
          "found " + std::to_string(values) + " values for each point, expected 1");
      }
    }
    else
    {
      this->next24();
    }
    const std::size_t count = this->Limits.checkedCount(
      this->Input, "values", points, isNew ? sizeof(float) : sizeof(std::int16_t), sizeof(float));
    NamedArray values = makeArray("Curvature", ScalarType::Float32, 1);
    values.Values.reserve(count * sizeof(float));
    for (std::size_t i = 0; i < count; ++i)
    {
      const float value = isNew ? this->Values.next<float>()
                                : static_cast<float>(this->Values.next<std::int16_t>()) / OldUnit;
      append(values, &value);
      this->Progress.tick();
    }
    if (this->Input.left() > 0)
    {
      this->Input.fail(ParseCode::Malformed, "found bytes after the last value");
    }
    this->Data.PointArrays.push_back(std::move(values));
  }

private:
  void skipLine()
  {
    constexpr std::size_t longest = 4096;
    const std::string_view text = this->Input.peek(longest).substr(0, longest);
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos)
    {
      this->Input.fail(text.size() < longest ? ParseCode::PrematureEnd : ParseCode::Malformed,
        "expected a line with the creator of the surface");
    }
    this->Input.advance(end + 1);
  }

  std::uint64_t count()
  {
    const auto value = this->Values.next<std::int32_t>();
    if (value < 0)
    {
      this->Input.fail(
        ParseCode::Malformed, "found a count of " + std::to_string(value) + ", expected 0 or more");
    }
    return static_cast<std::uint64_t>(value);
  }

  std::uint32_t next24()
  {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < MagicBytes; ++i)
    {
      value = value << 8 | this->Values.next<std::uint8_t>();
    }
    return value;
  }

  template <typename T>
  void readPoints(std::uint64_t points, float unit)
  {
    const std::size_t count =
      this->Limits.checkedCount(this->Input, "points", points, 3 * sizeof(T), 3 * sizeof(float));
    this->Data.Points = makeArray("Points", ScalarType::Float32, 3);
    this->Data.Points.Values.reserve(count * 3 * sizeof(float));
    for (std::size_t i = 0; i < count; ++i)
    {
      std::array<float, 3> p;
      for (float& coordinate : p)
      {
        coordinate = static_cast<float>(this->Values.next<T>()) / unit;
        if (!std::isfinite(coordinate))
        {
          this->Input.fail(ParseCode::Malformed,
            "found coordinates of point " + std::to_string(i) + " that are not finite");
        }
      }
      append(this->Data.Points, p.data());
      this->Progress.tick();
    }
  }

  void readFaces(
    std::uint64_t points, std::uint64_t faces, std::size_t corners, std::size_t bytesOfId)
  {
    const std::size_t count = this->Limits.checkedCount(
      this->Input, "faces", faces, corners * bytesOfId, (corners + 1) * sizeof(std::int64_t));
    PolygonList polygons(this->Input, points, this->Data);
    polygons.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t c = 0; c < corners; ++c)
      {
        polygons.add(bytesOfId == MagicBytes ? static_cast<std::int64_t>(this->next24())
                                             : this->Values.next<std::int32_t>());
      }
      polygons.end();
      this->Progress.tick();
    }
  }

  ByteReader& Input;
  const ParseLimits& Limits;
  SurfaceData& Data;
  ProgressReport Progress;
  BinaryValues Values;
};
}

//------------------------------------------------------------------------------
SurfaceResult parseFreeSurferSurface(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { FreeSurferReader(input, limits, run, data).readSurface(); });
}

//------------------------------------------------------------------------------
SurfaceResult parseFreeSurferCurv(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { FreeSurferReader(input, limits, run, data).readCurv(); });
}

//------------------------------------------------------------------------------
bool looksLikeFreeSurferSurface(std::string_view start)
{
  constexpr std::size_t curvHead = 15;
  const std::uint32_t magic = magicOf(start);
  const std::string_view rest = start.substr(std::min(MagicBytes, start.size()));
  if (magic == TriangleMagic)
  {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    return line.size() < rest.size() &&
      std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; });
  }
  if (magic == QuadMagic) // a new curv file has the number of values for each point, 1, at this
                          // position
  {
    return start.size() >= curvHead && start.substr(11, 4) != std::string_view("\0\0\0\1", 4);
  }
  return magic == NewQuadMagic && start.size() > 2 * MagicBytes;
}
}
