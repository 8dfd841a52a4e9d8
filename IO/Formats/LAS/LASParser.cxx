#include "LAS/LASParser.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/ProgressReport.h"
#include "Coordinates/CoordinateShift.h"
#include "LAS/LASHeader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::size_t LASBlockBytes = std::size_t(1) << 17; // bytes of records decoded at once

// Array of one number of each point.
struct LASArray
{
  NamedArray Array;
  std::size_t Offset = 0; ///< in a record [bytes]
  unsigned Shift = 0;     ///< position of the number's bits in a byte
  unsigned Mask = 0xFF;   ///< for numbers of bytes, after the shift
};

class LASReader
{
public:
  LASReader(ByteReader& input, const LASOptions& options, const ParseLimits& limits, const Run& run,
    SurfaceData& data)
    : Input(input)
    , Options(options)
    , Limits(limits)
    , Progress(input, run)
    , Data(data)
    , Header(readLASHeader(input))
  {
    const LASPointFormat& format = this->Header.Format;
    const unsigned returnBits = format.HasWideReturns ? 4 : 3;
    const unsigned returnMask = (1U << returnBits) - 1;
    this->add("Intensity", ScalarType::UInt16, 12);
    this->add("ReturnNumber", ScalarType::UInt8, 14, 0, returnMask);
    this->add("NumberOfReturns", ScalarType::UInt8, 14, returnBits, returnMask);
    this->add("Classification", ScalarType::UInt8, format.classification(), 0,
      format.HasWideReturns ? 0xFF : 0x1F);
    this->add("PointSourceId", ScalarType::UInt16, format.pointSourceId());
    this->add("GPSTime", ScalarType::Float64, format.GPSTime);
    this->add("NearInfrared", ScalarType::UInt16, format.NearInfrared);
  }

  void read()
  {
    const std::uint64_t size = this->Input.size();
    if (!this->Input.skip(this->Header.FirstRecord))
    {
      this->Input.fail(ParseCode::PrematureEnd,
        "found " + std::to_string(size) + " bytes, expected the points at byte " +
          std::to_string(this->Header.FirstRecord));
    }
    std::size_t memory = this->Points.tupleBytes() + this->Colors.tupleBytes();
    for (const LASArray& array : this->Arrays)
    {
      memory += array.Array.tupleBytes();
    }
    const std::size_t count = this->Limits.checkedCount(
      this->Input, "points", this->Header.NumberOfPoints, this->Header.RecordBytes, memory);
    this->resize(count);
    for (std::size_t first = 0; first < count;)
    {
      first += this->readBlock(first, count - first);
      this->Progress.tick();
    }
    this->Data.UnreadBytes = this->Header.HasDataAfterPoints ? 0 : this->Input.left();
    this->finish();
  }

private:
  void add(
    const char* name, ScalarType type, std::size_t offset, unsigned shift = 0, unsigned mask = 0xFF)
  {
    if (offset > 0)
    {
      this->Arrays.push_back({ makeArray(name, type, 1), offset, shift, mask });
    }
  }

  bool hasColors() const { return this->Header.Format.Color > 0; }

  void resize(std::size_t count)
  {
    this->Points.Values.resize(count * this->Points.tupleBytes());
    this->Colors.Values.resize(this->hasColors() ? count * this->Colors.tupleBytes() : 0);
    for (LASArray& array : this->Arrays)
    {
      array.Array.Values.resize(count * array.Array.tupleBytes());
    }
  }

  // Read up to `left` records. Return the number of records read, which is at least 1.
  std::size_t readBlock(std::size_t first, std::size_t left)
  {
    const std::size_t stride = this->Header.RecordBytes;
    const std::size_t count = std::min(left, std::max<std::size_t>(1, LASBlockBytes / stride));
    const std::string_view bytes = this->Input.peek(count * stride);
    if (bytes.size() < count * stride)
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file ends inside the points");
    }
    const auto* records = reinterpret_cast<const unsigned char*>(bytes.data());
    this->readCoordinates(records, first, count);
    if (this->hasColors())
    {
      this->readColors(records, first, count);
    }
    for (LASArray& array : this->Arrays)
    {
      this->readNumbers(records, first, count, array);
    }
    this->Input.advance(count * stride);
    return count;
  }

  void readCoordinates(const unsigned char* records, std::size_t first, std::size_t count)
  {
    const std::size_t stride = this->Header.RecordBytes;
    const std::array<double, 3> scale = this->Header.Scale;
    const std::array<double, 3> offset = this->Header.Offset;
    unsigned char* const to = this->Points.Values.data() + first * this->Points.tupleBytes();
    for (std::size_t i = 0; i < count; ++i)
    {
      double p[3];
      for (std::size_t c = 0; c < 3; ++c)
      {
        p[c] = littleEndianAt<std::int32_t>(records + i * stride + 4 * c) * scale[c] + offset[c];
      }
      std::memcpy(to + i * sizeof(p), p, sizeof(p));
    }
  }

  void readColors(const unsigned char* records, std::size_t first, std::size_t count)
  {
    const std::size_t stride = this->Header.RecordBytes;
    unsigned char* const to = this->Colors.Values.data() + first * this->Colors.tupleBytes();
    std::uint16_t largest = this->LargestColor;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::uint16_t color[3];
      for (std::size_t c = 0; c < 3; ++c)
      {
        color[c] =
          littleEndianAt<std::uint16_t>(records + i * stride + this->Header.Format.Color + 2 * c);
        largest = std::max(largest, color[c]);
      }
      std::memcpy(to + i * sizeof(color), color, sizeof(color));
    }
    this->LargestColor = largest;
  }

  void readNumbers(
    const unsigned char* records, std::size_t first, std::size_t count, LASArray& array) const
  {
    const std::size_t stride = this->Header.RecordBytes;
    const unsigned char* from = records + array.Offset;
    unsigned char* to = array.Array.Values.data() + first * array.Array.tupleBytes();
    const auto copy = [&](auto zero)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        const auto value = littleEndianAt<decltype(zero)>(from + i * stride);
        std::memcpy(to + i * sizeof(value), &value, sizeof(value));
      }
    };
    if (array.Array.Type == ScalarType::UInt16)
    {
      copy(std::uint16_t());
    }
    else if (array.Array.Type == ScalarType::Float64)
    {
      copy(double());
    }
    else
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        to[i] = static_cast<unsigned char>((from[i * stride] >> array.Shift) & array.Mask);
      }
    }
  }

  void finish()
  {
    const auto& scale = this->Header.Scale;
    const double resolution =
      std::min({ std::abs(scale[0]), std::abs(scale[1]), std::abs(scale[2]) });
    this->Data.Points = std::move(this->Points);
    this->Data.CoordinateShift =
      storeCoordinates(this->Data.Points, resolution, this->Options.ShiftCoordinates);
    if (this->hasColors())
    {
      this->Data.PointArrays.push_back(this->colorBytes());
    }
    for (LASArray& array : this->Arrays)
    {
      this->Data.PointArrays.push_back(std::move(array.Array));
    }
  }

  // Convert the colors to bytes, in place. The format states that colors have 16 bits, but many
  // programs write 8.
  NamedArray colorBytes()
  {
    const unsigned shift = this->LargestColor > 0xFF ? 8 : 0;
    NamedArray bytes = makeArray("RGB", ScalarType::UInt8, 3);
    bytes.Values = std::move(this->Colors.Values);
    const std::size_t count = bytes.Values.size() / sizeof(std::uint16_t);
    for (std::size_t i = 0; i < count; ++i)
    {
      std::uint16_t color = 0;
      std::memcpy(&color, bytes.Values.data() + i * sizeof(color), sizeof(color));
      bytes.Values[i] = static_cast<unsigned char>(color >> shift);
    }
    bytes.Values.resize(count);
    return bytes;
  }

  ByteReader& Input;
  const LASOptions& Options;
  const ParseLimits& Limits;
  ProgressReport Progress;
  SurfaceData& Data;
  const LASHeader Header;
  NamedArray Points = makeArray("Points", ScalarType::Float64, 3);
  NamedArray Colors = makeArray("RGB", ScalarType::UInt16, 3);
  std::uint16_t LargestColor = 0;
  std::vector<LASArray> Arrays;
};
}

//------------------------------------------------------------------------------
bool looksLikeLAS(std::string_view start)
{
  constexpr std::string_view signature = "LASF";
  return start.substr(0, signature.size()) == signature;
}

//------------------------------------------------------------------------------
SurfaceResult parseLAS(
  ByteReader& input, const LASOptions& options, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { LASReader(input, options, limits, run, data).read(); });
}
}
