/// Decode base64 text to bytes. The bytes may be compressed with zlib.

#ifndef ConformalBinaryText_h
#define ConformalBinaryText_h

#include "Bytes/OwnedArray.h"

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace conformal
{
/// Error in the data of a GIFTI file. The parser adds the position in the file to this error.
class GIFTIError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Decoder of a base64 text, which is added in pieces. If the text encodes more bytes than
/// expected, add() throws an error.
class BinaryTextDecoder
{
public:
  /// @param[in] expected      expected total number of decoded (and decompressed) bytes
  /// @param[in] isCompressed  whether the bytes in the text are compressed
  BinaryTextDecoder(std::size_t expected, bool isCompressed);
  ~BinaryTextDecoder();

  /// Decode the next piece of the text. Blanks are skipped.
  /// @throws GIFTIError if the text is not valid base64, cannot be decompressed, or has too many
  ///   bytes
  void add(std::string_view text);

  /// Return the decoded bytes. Call this function after all pieces of the text have been added.
  /// @throws GIFTIError if there are fewer bytes than expected
  OwnedArray<unsigned char> take();

private:
  class Inflater;

  void addBytes(const unsigned char* bytes, std::size_t count);

  const std::size_t Expected;
  std::unique_ptr<Inflater> Inflate; ///< null if the bytes are not compressed
  OwnedArray<unsigned char> Bytes;
  unsigned int Bits = 0; ///< decoded bits that do not yet form a byte
  int NumberOfBits = 0;
  bool IsPadded = false;
};
}

#endif
