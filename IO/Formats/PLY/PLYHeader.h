/// Parse the header of a PLY file: its elements and their properties.

#ifndef ConformalPLYHeader_h
#define ConformalPLYHeader_h

#include "Bytes/ByteReader.h"
#include "Bytes/ScalarType.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
enum class PLYFormat
{
  Ascii,
  BinaryLittleEndian,
  BinaryBigEndian
};

struct PLYProperty
{
  std::string Name;
  ScalarType Type = ScalarType::Float32; ///< type of the number, or of the numbers in a list
  bool IsList = false;
  ScalarType CountType = ScalarType::UInt8; ///< type of the length, written before each list
};

struct PLYElement
{
  std::string Name;
  std::uint64_t Count = 0;
  std::vector<PLYProperty> Properties;

  bool hasLists() const;
};

struct PLYHeader
{
  PLYFormat Format = PLYFormat::Ascii;
  std::vector<PLYElement> Elements;
  std::uint64_t GridColumns = 0; ///< columns of the range grid, from "obj_info num_cols"; else 0
  std::uint64_t GridRows = 0;    ///< rows of the range grid, from "obj_info num_rows"; else 0
};

/// Test whether the first bytes of a file identify a PLY file.
bool looksLikePLY(std::string_view start);

/// Read the header of a PLY file, up to and including the line "end_header". Afterwards, the next
/// byte of the input is the first byte of the data.
/// @throws ParseError if the header is malformed, truncated, or not of a PLY file
PLYHeader readPLYHeader(ByteReader& input);
}

#endif
