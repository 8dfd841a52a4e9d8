/// Read the pages of an E57 file, and check their checksums.

#ifndef ConformalE57Pages_h
#define ConformalE57Pages_h

#include "Bytes/ByteReader.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace conformal
{
/// Return the checksum CRC-32C (polynomial 0x1EDC6F41, reflected) of bytes.
std::uint32_t crc32C(std::string_view bytes);

/// Reader of the contents of an E57 file. The file consists of pages of 1024 bytes. The last 4
/// bytes of a page are the checksum of its contents, which are the other 1020 bytes. A physical
/// offset counts the bytes of the file. Lengths of the file's parts, called logical, do not count
/// checksums. Source: ASTM E2807-11, sections 6 and 7.
class E57Pages
{
public:
  /// Read the header of the file.
  /// @throws ParseError if the file is not an E57 file, or if its length differs from the header
  explicit E57Pages(ByteReader& input);

  std::uint64_t xmlOffset() const { return this->XMLOffset; } ///< physical
  std::uint64_t xmlBytes() const { return this->XMLBytes; }   ///< logical

  /// Move to a physical offset.
  /// @throws ParseError if the file has no contents at this offset, or the checksum is wrong
  void seek(std::uint64_t offset);

  /// Read the next bytes of the contents.
  /// @throws ParseError if the file ends before these bytes, or a checksum is wrong
  void read(char* bytes, std::size_t count);

  /// Advance by a number of bytes of the contents.
  void skip(std::uint64_t count);

  [[noreturn]] void fail(ParseCode code, const std::string& message) const
  {
    this->Input.fail(code, message);
  }

private:
  void readPage();

  ByteReader& Input;
  std::string_view Left; ///< rest of the contents of the current page, in the window of the input
  std::uint64_t XMLOffset = 0;
  std::uint64_t XMLBytes = 0;
};
}

#endif
