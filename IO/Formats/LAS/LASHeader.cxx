#include "LAS/LASHeader.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FileValues.h"

#include <cmath>
#include <limits>
#include <string_view>

namespace conformal
{
namespace
{
constexpr std::string_view LASSignature = "LASF";
constexpr std::size_t OldestHeaderBytes = 227; // of versions 1.0 to 1.2
constexpr std::size_t NewestHeaderBytes = 375; // of version 1.4

constexpr LASPointFormat Formats[] = { { 20, false, 0, 0, 0 }, { 28, false, 20, 0, 0 },
  { 26, false, 0, 20, 0 }, { 34, false, 20, 28, 0 }, { 57, false, 20, 0, 0 },
  { 63, false, 20, 28, 0 }, { 30, true, 22, 0, 0 }, { 36, true, 22, 30, 0 },
  { 38, true, 22, 30, 36 }, { 59, true, 22, 0, 0 }, { 67, true, 22, 30, 36 } };

class LASHeaderReader
{
public:
  explicit LASHeaderReader(ByteReader& input)
    : Input(input)
    , Bytes(input.peek(NewestHeaderBytes).substr(0, NewestHeaderBytes))
  {
  }

  LASHeader read()
  {
    this->checkStart();
    LASHeader header;
    const unsigned minor = this->at<std::uint8_t>(25);
    const auto headerBytes = this->at<std::uint16_t>(94);
    const std::size_t required = minor < 3 ? OldestHeaderBytes
      : minor == 3                         ? OldestHeaderBytes + sizeof(std::uint64_t)
                                           : NewestHeaderBytes;
    this->check(headerBytes >= required,
      "a header of at least " + std::to_string(required) + " bytes for version 1." +
        std::to_string(minor));
    header.FirstRecord = this->at<std::uint32_t>(96);
    this->check(header.FirstRecord >= headerBytes, "the points after the header");
    this->readFormat(header);
    header.NumberOfPoints = minor < 4 ? this->at<std::uint32_t>(107) : this->at<std::uint64_t>(247);
    for (std::size_t c = 0; c < 3; ++c)
    {
      header.Scale[c] = this->at<double>(131 + 8 * c);
      header.Offset[c] = this->at<double>(155 + 8 * c);
      const double largest = std::abs(header.Scale[c]) * std::ldexp(1.0, 31) +
        std::abs(header.Offset[c]); // not finite if a number is not
      this->check(header.Scale[c] != 0.0 && std::isfinite(largest),
        "scales and offsets of coordinates that are finite, and scales other than 0");
    }
    header.HasDataAfterPoints = (minor >= 3 && this->at<std::uint64_t>(227) != 0) ||
      (minor >= 4 && this->at<std::uint32_t>(243) != 0);
    return header;
  }

private:
  void checkStart()
  {
    if (this->Bytes.substr(0, LASSignature.size()) != LASSignature)
    {
      this->Input.fail(ParseCode::UnrecognizedType, "expected LASF at the beginning of a LAS file");
    }
    if (this->Bytes.size() < OldestHeaderBytes)
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file ends inside its header");
    }
    this->check(this->at<std::uint8_t>(24) == 1 && this->at<std::uint8_t>(25) <= 4,
      "version 1.0 to 1.4, not " + std::to_string(this->at<std::uint8_t>(24)) + "." +
        std::to_string(this->at<std::uint8_t>(25)));
  }

  void readFormat(LASHeader& header)
  {
    constexpr unsigned compressionBits = 0xC0; // set in LAZ files
    const unsigned format = this->at<std::uint8_t>(104);
    if ((format & compressionBits) != 0)
    {
      this->Input.fail(ParseCode::Malformed,
        "the points are compressed (LAZ), and are not read; first convert the file to LAS, for "
        "example by \"pdal translate scan.laz scan.las\" or \"laszip -i scan.laz -o scan.las\"");
    }
    this->check(format < std::size(Formats), "point format 0 to 10, not " + std::to_string(format));
    header.Format = Formats[format];
    header.RecordBytes = this->at<std::uint16_t>(105);
    this->check(header.RecordBytes >= header.Format.Bytes,
      "records of at least " + std::to_string(header.Format.Bytes) + " bytes, not " +
        std::to_string(header.RecordBytes));
  }

  // Return the number at an offset of the header.
  template <typename T>
  T at(std::size_t offset) const
  {
    if (offset + sizeof(T) > this->Bytes.size())
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file ends inside its header");
    }
    ByteReader number(this->Bytes.substr(offset, sizeof(T)));
    return BinaryValues(number, !isLittleEndianMachine()).next<T>();
  }

  void check(bool isRight, const std::string& expected) const
  {
    if (!isRight)
    {
      this->Input.fail(ParseCode::Malformed, "the header is not valid: expected " + expected);
    }
  }

  ByteReader& Input;
  const std::string_view Bytes;
};
}

//------------------------------------------------------------------------------
LASHeader readLASHeader(ByteReader& input)
{
  input.requireBytes();
  input.beginBinary();
  return LASHeaderReader(input).read();
}
}
