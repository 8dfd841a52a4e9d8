/// Decompress LibLZF data of PCD files, piece by piece.

#ifndef ConformalLZFDecoder_h
#define ConformalLZFDecoder_h

#include "Bytes/ByteReader.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace conformal
{
/// Decoder of LZF. A control byte c below 32 precedes c + 1 literal bytes. Any other control byte
/// encodes, with the next one or two bytes, the length and distance of bytes to repeat.
class LZFDecoder
{
public:
  /// Maximum number of decompressed bytes for one byte of compressed data.
  static constexpr std::uint64_t MaximumGrowth = 88;

  /// @param[in] compressedBytes  size of the block that begins at the next byte of the input
  LZFDecoder(ByteReader& input, std::uint64_t compressedBytes)
    : Input(input)
    , Left(compressedBytes)
  {
  }

  /// Decompress a number of bytes.
  /// @throws ParseError if the block or the input ends too early, or bytes to repeat would precede
  ///   the data
  void read(char* bytes, std::size_t count);

  /// Require the end of the block.
  /// @throws ParseError if the block has more data
  void end() const;

private:
  static constexpr std::size_t HistoryBytes = std::size_t(1) << 13; // maximum distance

  unsigned char nextByte();
  void nextControl();

  ByteReader& Input;
  std::uint64_t Left; ///< number of remaining compressed bytes
  std::array<char, HistoryBytes> History = {};
  std::uint64_t Done = 0; ///< number of decompressed bytes so far
  std::size_t Literals = 0;
  std::size_t Repeats = 0;
  std::size_t Distance = 0;
};
}

#endif
