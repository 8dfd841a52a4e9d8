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
/// What is wrong at the parser's place in the file.
class GIFTIError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Decodes a text that comes in pieces. No more than the expected bytes are ever kept.
class BinaryTextDecoder
{
public:
  /// @param[in] expected      the bytes there must be in the end
  /// @param[in] isCompressed  whether they were compressed
  BinaryTextDecoder(std::size_t expected, bool isCompressed);
  ~BinaryTextDecoder();

  /// Decode a piece; blanks are passed over.
  /// @throws GIFTIError
  void add(std::string_view text);

  /// The bytes, when all the text was added.
  /// @throws GIFTIError if there are fewer than expected
  OwnedArray<unsigned char> take();

private:
  class Inflater;

  void addBytes(const unsigned char* bytes, std::size_t count);

  const std::size_t Expected;
  std::unique_ptr<Inflater> Inflate; ///< null if the bytes are not compressed
  OwnedArray<unsigned char> Bytes;
  unsigned int Bits = 0; ///< of letters that make no byte yet
  int NumberOfBits = 0;
  bool IsPadded = false;
};
}

#endif
