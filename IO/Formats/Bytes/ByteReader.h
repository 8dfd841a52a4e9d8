/// Read the bytes of a file from beginning to end, from memory or piece by piece.

#ifndef ConformalByteReader_h
#define ConformalByteReader_h

#include "Bytes/ParseStatus.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
/// Reader of an input, a file or bytes in memory. The reader accesses the input through a window,
/// the piece of a file that is in memory. A small window stays in the cache of the processor during
/// parsing. If another process truncates the file during reading, the reader does not crash. The
/// input then ends at the new end of the file.
class ByteReader
{
public:
  /// Function that reads the next bytes into a buffer and returns their number. If this number is
  /// smaller than `size`, the input has ended.
  using Read = std::function<std::size_t(char* buffer, std::size_t size)>;
  /// Function that moves to an offset in the input. The next call of Read begins at this offset.
  using Seek = std::function<void(std::uint64_t offset)>;

  ByteReader() = default;
  explicit ByteReader(std::string_view bytes);
  ByteReader(Read read, std::uint64_t size, Seek seek = {});
  ByteReader(ByteReader&&) = default;
  ByteReader& operator=(ByteReader&&) = default;

  std::uint64_t size() const { return this->Size; }
  std::uint64_t offset() const { return this->WindowOffset + (this->Begin - this->Window); }
  std::uint64_t left() const { return this->Size - this->offset(); }

  /// Return at least `count` consecutive bytes from the current position. Fewer bytes are returned
  /// only at the end of the input.
  std::string_view peek(std::size_t count)
  {
    if (static_cast<std::size_t>(this->End - this->Begin) < count)
    {
      this->refill(count);
    }
    return { this->Begin, static_cast<std::size_t>(this->End - this->Begin) };
  }

  /// Advance by a number of bytes that peek() has returned.
  void advance(std::size_t count) { this->Begin += count; }

  /// Advance by any number of bytes. If the constructor got a function Seek and beginBinary() was
  /// called, the reader uses Seek. Without Seek, or before beginBinary(), the reader reads the
  /// bytes and discards them.
  /// @return false if the input ends before these bytes
  bool skip(std::uint64_t count);

  /// Move to an offset of the input, before or after the current position. An input that is not in
  /// memory needs the function Seek. Call beginBinary() first.
  /// @return false if the input ends before this offset, or cannot be moved
  bool seek(std::uint64_t offset);

  /// Stop counting lines for error messages. Call this function if the rest of the input is binary,
  /// or if bytes were skipped without counting their lines.
  void beginBinary() { this->Binary = true; }

  /// Return the line number of the next byte, counted from 1. After beginBinary(), return 0. A line
  /// ends with LF, CR or CRLF. Call this function for errors only, since it searches the window for
  /// line ends.
  std::uint64_t line() const;

  [[noreturn]] void fail(ParseCode code, const std::string& message) const;

  /// Require that the input is not empty. Every parser calls this function first.
  /// @throws ParseError if the input is empty
  void requireBytes();

private:
  void refill(std::size_t count);
  std::uint64_t fetched() const { return this->WindowOffset + (this->End - this->Window); }

  Read Source;
  Seek Jump;
  std::vector<char> Buffer;
  const char* Window = nullptr; ///< first byte of the window
  const char* Begin = nullptr;  ///< next byte
  const char* End = nullptr;
  std::uint64_t WindowOffset = 0;
  std::uint64_t Size = 0;
  std::uint64_t LinesBefore = 0; ///< number of line ends before the window
  char LastBefore = 0;           ///< last byte before the window
  bool Binary = false;
};

/// Open a regular file. Directories, pipes and devices are rejected without being opened.
ParseStatus openFile(const std::string& path, ByteReader& input);

/// Test the first bytes of a file. A file that cannot be read does not look right.
/// @param[in] looksRight  function of up to `size` first bytes, and of the size of the file [bytes]
bool startsLike(const std::string& path, std::size_t size,
  const std::function<bool(std::string_view, std::uint64_t)>& looksRight);
}

#endif
