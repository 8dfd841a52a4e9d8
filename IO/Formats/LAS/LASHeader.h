/// Parse the header of a LAS file.

#ifndef ConformalLASHeader_h
#define ConformalLASHeader_h

#include "Bytes/ByteReader.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace conformal
{
/// Offsets of numbers in the record of a point [bytes]. Numbers that a point format lacks have the
/// offset 0.
struct LASPointFormat
{
  std::size_t Bytes;   ///< minimum length of a record
  bool HasWideReturns; ///< formats 6 to 10: returns of 4 bits, classification of 8 bits
  std::size_t GPSTime;
  std::size_t Color;
  std::size_t NearInfrared;

  std::size_t classification() const { return this->HasWideReturns ? 16 : 15; }
  std::size_t pointSourceId() const { return this->HasWideReturns ? 20 : 18; }
};

struct LASHeader
{
  LASPointFormat Format = {};
  std::size_t RecordBytes = 0;   ///< length of a record; the last bytes may be extra ones
  std::uint64_t FirstRecord = 0; ///< offset of the first record in the file
  std::uint64_t NumberOfPoints = 0;
  std::array<double, 3> Scale = {};
  std::array<double, 3> Offset = {};
  bool HasDataAfterPoints = false; ///< whether records or waveforms follow the points
};

/// Read the header. The input remains at its beginning.
/// @throws ParseError if the header is malformed or truncated, or the file is compressed (LAZ)
LASHeader readLASHeader(ByteReader& input);
}

#endif
