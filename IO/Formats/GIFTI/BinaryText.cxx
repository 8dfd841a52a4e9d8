#include "GIFTI/BinaryText.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace conformal
{
namespace
{
// Return the six bits that a base64 letter encodes, or -1 for any other character.
int bitsOf(char c)
{
  return c >= 'A' && c <= 'Z' ? c - 'A'
    : c >= 'a' && c <= 'z'    ? c - 'a' + 26
    : c >= '0' && c <= '9'    ? c - '0' + 52
    : c == '+'                ? 62
    : c == '/'                ? 63
                              : -1;
}
}

//------------------------------------------------------------------------------
class BinaryTextDecoder::Inflater
{
public:
  Inflater()
  {
    constexpr int zlibOrGzip = 15 + 32;
    if (inflateInit2(&this->Stream, zlibOrGzip) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Inflater() { inflateEnd(&this->Stream); }
  Inflater(const Inflater&) = delete;
  void operator=(const Inflater&) = delete;

  // Decompress bytes, and call `sink` for each piece of the result.
  template <typename Sink>
  void add(const unsigned char* bytes, std::size_t count, Sink sink)
  {
    std::array<unsigned char, 1 << 14> buffer;
    this->Stream.next_in = const_cast<unsigned char*>(bytes);
    this->Stream.avail_in = static_cast<uInt>(count);
    do
    {
      this->Stream.next_out = buffer.data();
      this->Stream.avail_out = static_cast<uInt>(buffer.size());
      const int code = this->IsAtEnd ? Z_STREAM_END : inflate(&this->Stream, Z_NO_FLUSH);
      if ((this->IsAtEnd && this->Stream.avail_in > 0) ||
        (code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR))
      {
        throw GIFTIError("found data that zlib cannot decompress");
      }
      this->IsAtEnd = code == Z_STREAM_END;
      sink(buffer.data(), buffer.size() - this->Stream.avail_out);
    } while (this->Stream.avail_out == 0 || (this->IsAtEnd && this->Stream.avail_in > 0));
  }

private:
  z_stream Stream = {};
  bool IsAtEnd = false;
};

//------------------------------------------------------------------------------
BinaryTextDecoder::BinaryTextDecoder(std::size_t expected, bool isCompressed)
  : Expected(expected)
  , Inflate(isCompressed ? std::make_unique<Inflater>() : nullptr)
{
}

BinaryTextDecoder::~BinaryTextDecoder() = default;

//------------------------------------------------------------------------------
void BinaryTextDecoder::add(std::string_view text)
{
  std::array<unsigned char, 1 << 12> decoded;
  std::size_t count = 0;
  const auto flush = [&]()
  {
    const auto keep = [&](const unsigned char* bytes, std::size_t size)
    { this->addBytes(bytes, size); };
    if (this->Inflate && count > 0)
    {
      this->Inflate->add(decoded.data(), count, keep);
    }
    else
    {
      keep(decoded.data(), count);
    }
    count = 0;
  };
  for (const char c : text)
  {
    if (c == ' ' || (c >= '\t' && c <= '\r'))
    {
      continue;
    }
    const int bits = bitsOf(c);
    this->IsPadded = this->IsPadded || c == '=';
    if (bits < 0 ? c != '=' : this->IsPadded)
    {
      throw GIFTIError("found a character that is not valid base64 at this place");
    }
    if (bits < 0)
    {
      continue;
    }
    this->Bits = (this->Bits << 6 | static_cast<unsigned int>(bits)) & 0xFFFFU;
    this->NumberOfBits += 6;
    if (this->NumberOfBits >= 8)
    {
      this->NumberOfBits -= 8;
      decoded[count++] = static_cast<unsigned char>(this->Bits >> this->NumberOfBits);
      if (count == decoded.size())
      {
        flush();
      }
    }
  }
  flush();
}

//------------------------------------------------------------------------------
void BinaryTextDecoder::addBytes(const unsigned char* bytes, std::size_t count)
{
  if (count > this->Expected - this->Bytes.size())
  {
    throw GIFTIError(
      "found more bytes than the " + std::to_string(this->Expected) + " of the dimensions");
  }
  if (count == 0)
  {
    return;
  }
  this->Bytes.extend(count);
  std::memcpy(this->Bytes.data() + this->Bytes.size() - count, bytes, count);
}

//------------------------------------------------------------------------------
OwnedArray<unsigned char> BinaryTextDecoder::take()
{
  if (this->Bytes.size() != this->Expected)
  {
    throw GIFTIError("found " + std::to_string(this->Bytes.size()) + " bytes, expected " +
      std::to_string(this->Expected) + " by the dimensions");
  }
  return std::move(this->Bytes);
}
}
