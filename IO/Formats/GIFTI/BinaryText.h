/// Conversion of base64 text, optionally compressed with zlib, to bytes.

#ifndef ConformalBinaryText_h
#define ConformalBinaryText_h

#include "Bytes/OwnedArray.h"

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace conformal
{
/// Error at the position of the parser in the file.
class GIFTIError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Decode a text that arrives in pieces. At most the expected number of bytes is kept.
class BinaryTextDecoder
{
public:
  /// @param[in] expected      total number of bytes
  /// @param[in] isCompressed  whether the bytes are compressed
  BinaryTextDecoder(std::size_t expected, bool isCompressed);
  ~BinaryTextDecoder();

  /// Decode a piece; blanks are skipped.
  /// @throws GIFTIError
  void add(std::string_view text);

  /// Return the bytes after all text was added.
  /// @throws GIFTIError if there are fewer than expected
  OwnedArray<unsigned char> take();

private:
  class Inflater;

  void addBytes(const unsigned char* bytes, std::size_t count);

  const std::size_t Expected;
  std::unique_ptr<Inflater> Inflate; ///< null if the bytes are not compressed
  OwnedArray<unsigned char> Bytes;
  unsigned int Bits = 0; ///< of letters that do not complete a byte yet
  int NumberOfBits = 0;
  bool IsPadded = false;
};
}

#endif
