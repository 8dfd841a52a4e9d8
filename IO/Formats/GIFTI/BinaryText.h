/// Decode base64 text to bytes, which may be compressed with zlib.

#ifndef ConformalBinaryText_h
#define ConformalBinaryText_h

#include "Bytes/OwnedArray.h"

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace conformal
{
/// Error in a GIFTI file, at the current position of the parser.
class GIFTIError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Decoder of a text that is added in pieces. At most the expected number of bytes is stored.
class BinaryTextDecoder
{
public:
  /// @param[in] expected      expected total number of decoded bytes
  /// @param[in] isCompressed  whether the bytes in the text are compressed
  BinaryTextDecoder(std::size_t expected, bool isCompressed);
  ~BinaryTextDecoder();

  /// Decode a piece of the text. Blanks are skipped.
  /// @throws GIFTIError
  void add(std::string_view text);

  /// Return the decoded bytes. Call this function after all text was added.
  /// @throws GIFTIError if there are fewer than expected
  OwnedArray<unsigned char> take();

private:
  class Inflater;

  void addBytes(const unsigned char* bytes, std::size_t count);

  const std::size_t Expected;
  std::unique_ptr<Inflater> Inflate; ///< null if the bytes are not compressed
  OwnedArray<unsigned char> Bytes;
  unsigned int Bits = 0; ///< bits of letters that do not yet complete a byte
  int NumberOfBits = 0;
  bool IsPadded = false;
};
}

#endif
