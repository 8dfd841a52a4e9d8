#include "E57/E57Pages.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FileValues.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace conformal
{
namespace
{
constexpr std::size_t PageBytes = 1024;
constexpr std::size_t ContentBytes = PageBytes - sizeof(std::uint32_t);
constexpr std::string_view Signature = "ASTM-E57";

using ChecksumTables = std::array<std::array<std::uint32_t, 256>, 8>;

// Return the tables for eight bytes at once. Table k contains the checksum of a byte that k zeros
// follow.
constexpr ChecksumTables makeChecksumTables()
{
  constexpr std::uint32_t polynomial = 0x82F63B78U; // with its bits in reverse order
  ChecksumTables tables = {};
  for (std::uint32_t byte = 0; byte < 256; ++byte)
  {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit)
    {
      sum = (sum >> 1) ^ ((sum & 1U) != 0 ? polynomial : 0U);
    }
    tables[0][byte] = sum;
  }
  for (std::size_t k = 1; k < tables.size(); ++k)
  {
    for (std::size_t byte = 0; byte < 256; ++byte)
    {
      const std::uint32_t sum = tables[k - 1][byte];
      tables[k][byte] = (sum >> 8) ^ tables[0][sum & 255U];
    }
  }
  return tables;
}

constexpr ChecksumTables Tables = makeChecksumTables();

std::uint32_t littleEndian(const char* bytes)
{
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
  {
    value = (value << 8) | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

std::uint32_t bigEndian(const char* bytes)
{
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i)
  {
    value = (value << 8) | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}
}

//------------------------------------------------------------------------------
std::uint32_t crc32C(std::string_view bytes)
{
  std::uint32_t sum = ~0U;
  for (; bytes.size() >= 8; bytes.remove_prefix(8))
  {
    const std::uint32_t low = sum ^ littleEndian(bytes.data());
    const std::uint32_t high = littleEndian(bytes.data() + 4);
    sum = Tables[7][low & 255U] ^ Tables[6][(low >> 8) & 255U] ^ Tables[5][(low >> 16) & 255U] ^
      Tables[4][low >> 24] ^ Tables[3][high & 255U] ^ Tables[2][(high >> 8) & 255U] ^
      Tables[1][(high >> 16) & 255U] ^ Tables[0][high >> 24];
  }
  for (const char byte : bytes)
  {
    sum = (sum >> 8) ^ Tables[0][(sum ^ static_cast<unsigned char>(byte)) & 255U];
  }
  return ~sum;
}

//------------------------------------------------------------------------------
E57Pages::E57Pages(ByteReader& input)
  : Input(input)
{
  input.requireBytes();
  if (input.peek(Signature.size()).substr(0, Signature.size()) != Signature)
  {
    input.fail(ParseCode::UnrecognizedType, "expected ASTM-E57 at the beginning of an E57 file");
  }
  input.beginBinary();
  const std::uint64_t size = input.size();
  if (input.peek(PageBytes).size() < PageBytes)
  {
    input.fail(ParseCode::PrematureEnd, "the file ends inside its first page of 1024 bytes");
  }
  BinaryValues values(input, !isLittleEndianMachine());
  values.skip(ScalarType::Int8, Signature.size());
  const auto major = values.next<std::uint32_t>();
  values.skip(ScalarType::UInt32, 1); // minor versions are compatible
  const auto bytes = values.next<std::uint64_t>();
  this->XMLOffset = values.next<std::uint64_t>();
  this->XMLBytes = values.next<std::uint64_t>();
  const auto pageBytes = values.next<std::uint64_t>();
  if (major != 1 || pageBytes != PageBytes)
  {
    input.fail(ParseCode::Malformed,
      "found version " + std::to_string(major) + " with pages of " + std::to_string(pageBytes) +
        " bytes, expected version 1 with pages of 1024 bytes");
  }
  if (bytes != size || size % PageBytes != 0)
  {
    input.fail(bytes > size ? ParseCode::PrematureEnd : ParseCode::Malformed,
      "found " + std::to_string(size) + " bytes, expected " + std::to_string(bytes) +
        ", a multiple of 1024");
  }
  this->seek(0); // also checks the checksum of the header
}

//------------------------------------------------------------------------------
void E57Pages::seek(std::uint64_t offset)
{
  const std::uint64_t inPage = offset % PageBytes;
  if (offset >= this->Input.size() || inPage >= ContentBytes || !this->Input.seek(offset - inPage))
  {
    this->fail(ParseCode::Malformed,
      "found a reference to byte " + std::to_string(offset) + ", where the file has no contents");
  }
  this->readPage();
  this->Left.remove_prefix(inPage);
}

//------------------------------------------------------------------------------
void E57Pages::readPage()
{
  const std::string_view page = this->Input.peek(PageBytes).substr(0, PageBytes);
  if (page.size() < PageBytes)
  {
    this->fail(ParseCode::PrematureEnd, "the file ends, expected another page");
  }
  this->Left = page.substr(0, ContentBytes);
  if (crc32C(this->Left) != bigEndian(page.data() + ContentBytes))
  {
    this->fail(ParseCode::Malformed,
      "the checksum of this page of 1024 bytes is wrong: the file was damaged, for example during "
      "a transfer");
  }
  this->Input.advance(PageBytes);
}

//------------------------------------------------------------------------------
void E57Pages::read(char* bytes, std::size_t count)
{
  while (count > 0)
  {
    if (this->Left.empty())
    {
      this->readPage();
    }
    const std::size_t step = std::min(count, this->Left.size());
    std::memcpy(bytes, this->Left.data(), step);
    this->Left.remove_prefix(step);
    bytes += step;
    count -= step;
  }
}

//------------------------------------------------------------------------------
void E57Pages::skip(std::uint64_t count)
{
  while (count > 0)
  {
    if (this->Left.empty())
    {
      this->readPage();
    }
    const std::size_t step =
      static_cast<std::size_t>(std::min<std::uint64_t>(count, this->Left.size()));
    this->Left.remove_prefix(step);
    count -= step;
  }
}
}
