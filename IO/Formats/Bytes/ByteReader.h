/// Read the bytes of a file in order, from memory or piece by piece.

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
/// Moving window over the input. A file is never in memory as a whole: its pieces stay in the cache
/// of the processor while they are parsed. A file truncated by another process in the meantime is a
/// short file, not a crash.
class ByteReader
{
public:
  /// Fill a buffer and return the number of bytes; fewer than requested mean the end of the input.
  using Read = std::function<std::size_t(char* buffer, std::size_t size)>;
  /// Move to an offset, from which the next bytes are read.
  using Seek = std::function<void(std::uint64_t offset)>;

  ByteReader() = default;
  explicit ByteReader(std::string_view bytes);
  ByteReader(Read read, std::uint64_t size, Seek seek = {});
  ByteReader(ByteReader&&) = default;
  ByteReader& operator=(ByteReader&&) = default;

  std::uint64_t size() const { return this->Size; }
  std::uint64_t offset() const { return this->WindowOffset + (this->Begin - this->Window); }
  std::uint64_t left() const { return this->Size - this->offset(); }

  /// Return at least `count` consecutive bytes from the current position; fewer only at the end of
  /// the input.
  std::string_view peek(std::size_t count)
  {
    if (static_cast<std::size_t>(this->End - this->Begin) < count)
    {
      this->refill(count);
    }
    return { this->Begin, static_cast<std::size_t>(this->End - this->Begin) };
  }

  /// Advance by bytes that peek() returned.
  void advance(std::size_t count) { this->Begin += count; }

  /// Advance by any number of bytes. Binary data are skipped by a seek if possible.
  /// @return false if the input ends before
  bool skip(std::uint64_t count);

  /// Stop counting lines, which are counted from the start for messages. The input from here on is
  /// binary, or a text whose lines are counted elsewhere.
  void beginBinary() { this->Binary = true; }

  /// Return the number of the line of the next byte, from 1; 0 in binary data. LF, CR and CRLF end
  /// lines. The whole window is scanned: call it for errors only.
  std::uint64_t line() const;

  [[noreturn]] void fail(ParseCode code, const std::string& message) const;

  /// Throw unless the input has a byte; every parser calls it first.
  /// @throws ParseError if the input is empty
  void requireBytes();

private:
  void refill(std::size_t count);

  Read Source;
  Seek Jump;
  std::vector<char> Buffer;
  const char* Window = nullptr; ///< first byte in memory
  const char* Begin = nullptr;  ///< next byte
  const char* End = nullptr;
  std::uint64_t WindowOffset = 0;
  std::uint64_t Size = 0;
  std::uint64_t LinesBefore = 0; ///< line ends before the window
  char LastBefore = 0;           ///< last byte before the window
  bool Binary = false;
};

/// Open a regular file. Directories, pipes and devices are rejected without being opened.
ParseStatus openFile(const std::string& path, ByteReader& input);
}

#endif
