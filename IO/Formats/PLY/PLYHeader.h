/// Parser of the header of a PLY file: its elements and their properties.

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
  ScalarType Type = ScalarType::Float32; ///< of the number, or of a list's members
  bool IsList = false;
  ScalarType CountType = ScalarType::UInt8; ///< of a list's length
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
  std::uint64_t GridColumns = 0; ///< of obj_info num_cols, 0 if there is none
  std::uint64_t GridRows = 0;    ///< of obj_info num_rows
};

/// Whether bytes from the start of a file are those of a PLY file.
bool looksLikePLY(std::string_view start);

/// Read up to and with the line "end_header". The input is at the first byte of the data then.
/// @throws ParseError
PLYHeader readPLYHeader(ByteReader& input);
}

#endif
