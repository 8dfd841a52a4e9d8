/// Decompress data of PCD files in the format of the library LibLZF, piece by piece.

#ifndef ConformalLZFDecoder_h
#define ConformalLZFDecoder_h

#include "Bytes/ByteReader.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace conformal
{
/// Decoder of the compression format LZF. A control byte c below 32 precedes c + 1 literal bytes,
/// which are copied to the output. Any other control byte encodes a length n and a distance d,
/// together with the next one or two bytes. The decoder then copies n bytes that begin d bytes
/// before the end of the output.
class LZFDecoder
{
public:
  /// Maximum number of decompressed bytes for each byte of compressed data. At most 264 bytes are
  /// decompressed from 3 bytes.
  static constexpr std::uint64_t MaximumGrowth = 88;

  /// @param[in] compressedBytes  size of the compressed data [bytes], which begin at the next byte
  ///   of the input
  LZFDecoder(ByteReader& input, std::uint64_t compressedBytes)
    : Input(input)
    , Left(compressedBytes)
  {
  }

  /// Decompress the next `count` bytes.
  /// @throws ParseError if the compressed data end too early, or a distance is larger than the
  ///   number of decompressed bytes
  void read(char* bytes, std::size_t count);

  /// Check that all compressed data were read.
  /// @throws ParseError if compressed data remain
  void end() const;

private:
  static constexpr std::size_t HistoryBytes = std::size_t(1) << 13; // maximum distance d

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
