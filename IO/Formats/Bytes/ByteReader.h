/// Reads the bytes of a file in order, from memory or piece by piece.

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
/// A window that moves over the input. A file is never in memory as a whole: its pieces stay in
/// the processor's cache while they are parsed, and a file that others cut short meanwhile is a
/// short file, not a crash.
class ByteReader
{
public:
  /// Fills a buffer; fewer bytes than asked for mean the end.
  using Read = std::function<std::size_t(char* buffer, std::size_t size)>;
  /// Goes to an offset, from where the next bytes are read.
  using Seek = std::function<void(std::uint64_t offset)>;

  ByteReader() = default;
  explicit ByteReader(std::string_view bytes);
  ByteReader(Read read, std::uint64_t size, Seek seek = {});
  ByteReader(ByteReader&&) = default;
  ByteReader& operator=(ByteReader&&) = default;

  std::uint64_t size() const { return this->Size; }
  std::uint64_t offset() const { return this->WindowOffset + (this->Begin - this->Window); }
  std::uint64_t left() const { return this->Size - this->offset(); }

  /// At least `count` bytes in a row from here on, fewer only where the input ends before.
  std::string_view peek(std::size_t count)
  {
    if (static_cast<std::size_t>(this->End - this->Begin) < count)
    {
      this->refill(count);
    }
    return { this->Begin, static_cast<std::size_t>(this->End - this->Begin) };
  }

  /// Go past bytes that peek() has shown.
  void advance(std::size_t count) { this->Begin += count; }

  /// Go past any number of bytes; false if the input ends before. Bytes of binary data are not
  /// read if there is another way.
  bool skip(std::uint64_t count);

  /// Lines are counted from the start for messages; from here on the input is binary, or a text
  /// of which others read the lines before.
  void beginBinary() { this->Binary = true; }

  /// Number of the line that holds the next byte, from 1; 0 in binary data. LF, CR and CRLF end
  /// lines. Costs a look at the whole window: meant for errors.
  std::uint64_t line() const;

  [[noreturn]] void fail(ParseCode code, const std::string& message) const;

  /// What every parser asks first.
  /// @throws ParseError if there is no byte
  void requireBytes();

private:
  void refill(std::size_t count);

  Read Source;
  Seek Jump;
  std::vector<char> Buffer;
  const char* Window = nullptr; ///< first byte that is still there
  const char* Begin = nullptr;  ///< next byte
  const char* End = nullptr;
  std::uint64_t WindowOffset = 0;
  std::uint64_t Size = 0;
  std::uint64_t LinesBefore = 0; ///< line ends before the window
  char LastBefore = 0;           ///< last byte before the window
  bool Binary = false;
};

/// Open a regular file. Directories, pipes and devices are refused without being opened.
ParseStatus openFile(const std::string& path, ByteReader& input);
}

#endif
