/// Parse the header of a PCD file.

#ifndef ConformalPCDHeader_h
#define ConformalPCDHeader_h

#include "Bytes/ByteReader.h"
#include "Bytes/ScalarType.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
enum class PCDFormat
{
  Ascii,
  Binary,
  BinaryCompressed
};

struct PCDField
{
  /// Name of all padding fields, which contain no data. Every other name may occur only once
  static constexpr std::string_view Padding = "_";
  std::string Name;
  ScalarType Type = ScalarType::Float32;
  std::size_t Count = 1;

  bool isPadding() const { return this->Name == Padding; }
  std::size_t bytes() const { return this->Count * sizeOf(this->Type); }
};

struct PCDHeader
{
  PCDFormat Format = PCDFormat::Ascii;
  std::vector<PCDField> Fields;
  std::uint64_t NumberOfPoints = 0;
  /// Position of the scanner, 3 numbers. Empty if the line VIEWPOINT is missing, or if it contains
  /// the default position (0, 0, 0) and the points do not form an image (HEIGHT is 1)
  std::vector<double> ScannerPosition;
};

/// Test whether the first bytes of a file identify a PCD file.
bool looksLikePCD(std::string_view start);

/// Read the header of a PCD file, up to and including the line "DATA". Afterwards, the next byte of
/// the input is the first byte of the data.
/// @throws ParseError if the header is malformed, truncated, or not of a PCD file
PCDHeader readPCDHeader(ByteReader& input);
}

#endif
