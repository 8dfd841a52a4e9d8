#include "PCD/PCDParser.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FileValues.h"
#include "Bytes/ProgressReport.h"
#include "Bytes/Records.h"
#include "PCD/LZFDecoder.h"
#include "PCD/PCDHeader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::size_t BlockBytes = std::size_t(1) << 17; // bytes of records copied at once

class PCDReader
{
public:
  PCDReader(ByteReader& input, const FilePiece& piece, const ParseLimits& limits, const Run& run,
    SurfaceData& data)
    : Input(input)
    , Piece(piece)
    , Limits(limits)
    , Data(data)
    , Progress(input, run)
    , Header(readPCDHeader(input))
  {
  }

  void read()
  {
    Records records = this->makeRecords();
    const bool isText = this->Header.Format == PCDFormat::Ascii;
    if (!isText)
    {
      this->Input.beginBinary();
    }
    const std::size_t recordBytes = this->recordBytes();
    const std::uint64_t minimumBytes = isText    ? 2 * this->numbers() - 1
      : this->Header.Format == PCDFormat::Binary ? recordBytes
                                                 : 0;
    std::size_t count = this->Limits.checkedCount(
      this->Input, "points", this->Header.NumberOfPoints, minimumBytes, 2 * recordBytes);
    if (this->Header.Format == PCDFormat::Binary)
    {
      this->Input.skip(this->Piece.begin(count) * recordBytes);
      count = this->Piece.end(count) - this->Piece.begin(count);
    }
    else if (!this->Piece.isFirst())
    {
      count = 0;
    }
    if (count > 0)
    {
      this->readPoints(records, count);
    }
    this->finish(records, count);
    this->Data.ScannerPosition = this->Header.ScannerPosition;
  }

private:
  void readPoints(Records& records, std::size_t count)
  {
    if (this->Header.Format == PCDFormat::BinaryCompressed)
    {
      const std::uint32_t compressed = this->compressedBytes(count);
      records.resize(count);
      this->readCompressed(records, count, compressed);
      return;
    }
    records.resize(count);
    if (this->Header.Format == PCDFormat::Ascii)
    {
      this->readText(records, count);
    }
    else
    {
      this->readBinary(records, count);
    }
  }

  Records makeRecords()
  {
    std::vector<RecordField> fields;
    for (const PCDField& field : this->Header.Fields)
    {
      fields.insert(fields.end(), field.Count, { field.Name, field.Type, !field.isPadding() });
    }
    try
    {
      return Records(std::move(fields), true);
    }
    catch (const std::invalid_argument& e)
    {
      this->Input.fail(ParseCode::Malformed, e.what());
    }
  }

  std::size_t recordBytes() const
  {
    std::size_t bytes = 0;
    for (const PCDField& field : this->Header.Fields)
    {
      bytes += field.bytes();
    }
    return bytes;
  }

  std::size_t numbers() const
  {
    std::size_t count = 0;
    for (const PCDField& field : this->Header.Fields)
    {
      count += field.Count;
    }
    return count;
  }

  void readText(Records& records, std::size_t count)
  {
    TextValues text(this->Input);
    for (std::size_t i = 0; i < count; ++i)
    {
      std::size_t number = 0;
      for (const PCDField& field : this->Header.Fields)
      {
        for (std::size_t c = 0; c < field.Count; ++c, ++number)
        {
          if (field.isPadding())
          {
            text.skip(field.Type, 1);
          }
          else
          {
            records.read(text, number, i);
          }
        }
      }
      text.endRecord();
      this->Progress.tick();
    }
    text.endFile();
  }

  void readBinary(Records& records, std::size_t count)
  {
    const std::size_t recordBytes = this->recordBytes();
    const std::size_t maximumInBlock = std::max<std::size_t>(1, BlockBytes / recordBytes);
    for (std::size_t first = 0; first < count;)
    {
      const std::size_t block = std::min(maximumInBlock, count - first);
      const std::string_view bytes = this->Input.peek(block * recordBytes);
      if (bytes.size() < block * recordBytes)
      {
        this->Input.fail(ParseCode::PrematureEnd, "the file ends inside the points");
      }
      this->copyBlock(records, bytes.data(), block, first);
      this->Input.advance(block * recordBytes);
      first += block;
      this->Progress.tick();
    }
  }

  void copyBlock(Records& records, const char* bytes, std::size_t block, std::size_t first)
  {
    const bool swap = !isLittleEndianMachine();
    const std::size_t recordBytes = this->recordBytes();
    if (records.canCopy())
    {
      records.copy(bytes, block, first, swap);
      return;
    }
    std::size_t number = 0;
    std::size_t offset = 0;
    for (const PCDField& field : this->Header.Fields)
    {
      for (std::size_t c = 0; c < field.Count; ++c, ++number)
      {
        if (!field.isPadding())
        {
          records.copyField(number, bytes + offset, recordBytes, block, first, swap);
        }
        offset += sizeOf(field.Type);
      }
    }
  }

  // Read the size of a compressed block. Check the size before memory for the contents is
  // allocated.
  std::uint32_t compressedBytes(std::size_t count)
  {
    BinaryValues values(this->Input, !isLittleEndianMachine());
    const auto compressed = values.next<std::uint32_t>();
    const auto uncompressed = values.next<std::uint32_t>();
    std::uint64_t expected = 0;
    for (const PCDField& field : this->Header.Fields)
    {
      expected += field.isPadding() ? 0 : count * field.bytes();
    }
    if (uncompressed != expected || expected > LZFDecoder::MaximumGrowth * compressed)
    {
      this->Input.fail(ParseCode::Malformed,
        "found " + std::to_string(compressed) + " bytes that give " + std::to_string(uncompressed) +
          ", expected " + std::to_string(expected));
    }
    this->Limits.checkedCount(this->Input, "bytes", compressed, 1, 0);
    return compressed;
  }

  // Compressed data contain all values of the first field, then all values of the next field,
  // without padding.
  void readCompressed(Records& records, std::size_t count, std::uint32_t compressed)
  {
    LZFDecoder decoder(this->Input, compressed);
    std::vector<char> buffer;
    std::size_t number = 0;
    for (const PCDField& field : this->Header.Fields)
    {
      const std::size_t bytes = field.bytes();
      const std::size_t maximumInBlock = std::max<std::size_t>(1, BlockBytes / bytes);
      for (std::size_t first = 0; first < count && !field.isPadding();)
      {
        const std::size_t block = std::min(maximumInBlock, count - first);
        buffer.resize(block * bytes);
        decoder.read(buffer.data(), buffer.size());
        for (std::size_t c = 0; c < field.Count; ++c)
        {
          records.copyField(number + c, buffer.data() + c * sizeOf(field.Type), bytes, block, first,
            !isLittleEndianMachine());
        }
        first += block;
        this->Progress.tick();
      }
      number += field.Count;
    }
    decoder.end();
  }

  void finish(Records& records, std::size_t count)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (kept != i)
      {
        records.move(i, kept);
      }
      kept += records.isFinitePoint(kept) ? 1 : 0;
    }
    records.resize(kept);
    this->Data.Points = std::move(records.arrays().front());
    for (auto array = records.arrays().begin() + 1; array != records.arrays().end(); ++array)
    {
      const bool isColor = (array->Name == "rgb" || array->Name == "rgba") &&
        array->Components == 1 && array->tupleBytes() == sizeof(std::uint32_t);
      this->Data.PointArrays.push_back(isColor ? this->unpackColors(*array) : std::move(*array));
    }
  }

  // Unpack colors from the bits 0xAARRGGBB, in the byte order of this machine.
  NamedArray unpackColors(const NamedArray& packed)
  {
    const std::size_t components = packed.Name == "rgba" ? 4 : 3;
    NamedArray colors = makeArray(components == 4 ? "RGBA" : "RGB", ScalarType::UInt8, components);
    colors.Values.resize(packed.numberOfTuples() * components);
    constexpr int shifts[] = { 16, 8, 0, 24 };
    // In a binary file, the bits of a float that is not a number are a color. A text has no bits.
    const bool hasNumbers =
      this->Header.Format == PCDFormat::Ascii && packed.Type == ScalarType::Float32;
    for (std::size_t i = 0; i < packed.numberOfTuples(); ++i)
    {
      std::uint32_t bits = 0;
      float number = 0.0F;
      std::memcpy(&bits, packed.Values.data() + i * sizeof(bits), sizeof(bits));
      std::memcpy(&number, &bits, sizeof(number));
      if (hasNumbers && !std::isfinite(number))
      {
        bits = 0;
        ++this->Data.ReplacedValues;
      }
      for (std::size_t c = 0; c < components; ++c)
      {
        colors.Values[i * components + c] = static_cast<unsigned char>(bits >> shifts[c]);
      }
    }
    return colors;
  }

  ByteReader& Input;
  const FilePiece& Piece;
  const ParseLimits& Limits;
  SurfaceData& Data;
  ProgressReport Progress;
  const PCDHeader Header;
};
}

//------------------------------------------------------------------------------
SurfaceResult parsePCD(
  ByteReader& input, const FilePiece& piece, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { PCDReader(input, piece, limits, run, data).read(); });
}
}
