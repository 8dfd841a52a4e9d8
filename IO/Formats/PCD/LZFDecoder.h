/// Decompression of LibLZF data in PCD files, piece by piece.

#ifndef ConformalLZFDecoder_h
#define ConformalLZFDecoder_h

#include "Bytes/ByteReader.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace conformal
{
/// A control byte below 32 is followed by one more literal bytes than it says; another one and the
/// next one or two bytes give the length and distance of bytes to be repeated.
class LZFDecoder
{
public:
  /// A byte of compressed data gives no more than that many.
  static constexpr std::uint64_t MaximumGrowth = 88;

  /// @param[in] compressedBytes  of the block that begins at the next byte of the input
  LZFDecoder(ByteReader& input, std::uint64_t compressedBytes)
    : Input(input)
    , Left(compressedBytes)
  {
  }

  /// Decompress so many bytes.
  /// @throws ParseError if the block or the input ends before, or a byte to repeat never was
  void read(char* bytes, std::size_t count);

  /// @throws ParseError if the block has more
  void end() const;

private:
  static constexpr std::size_t HistoryBytes = std::size_t(1) << 13; // the largest distance

  unsigned char nextByte();
  void nextControl();

  ByteReader& Input;
  std::uint64_t Left; ///< compressed bytes
  std::array<char, HistoryBytes> History = {};
  std::uint64_t Done = 0; ///< decompressed bytes
  std::size_t Literals = 0;
  std::size_t Repeats = 0;
  std::size_t Distance = 0;
};
}

#endif
