#include "Text/BinaryTextEncoder.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>

namespace conformal
{
namespace
{
// Compress bytes piece by piece, so that the run can be aborted.
std::string deflated(std::string_view bytes, const Run& run)
{
  constexpr std::size_t piece = 1 << 18;
  z_stream stream = {};
  if (deflateInit(&stream, Z_DEFAULT_COMPRESSION) != Z_OK)
  {
    throw std::bad_alloc();
  }
  const std::unique_ptr<z_stream, int (*)(z_stream*)> atEnd(&stream, deflateEnd);
  std::string result;
  std::size_t begin = 0;
  do
  {
    run.report(static_cast<double>(begin) / std::max<std::size_t>(bytes.size(), 1));
    const std::size_t size = std::min(piece, bytes.size() - begin);
    stream.next_in =
      const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.substr(begin, size).data()));
    stream.avail_in = static_cast<uInt>(size);
    begin += size;
    const int flush = begin == bytes.size() ? Z_FINISH : Z_NO_FLUSH;
    do
    {
      std::array<char, 1 << 14> buffer;
      stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream.avail_out = static_cast<uInt>(buffer.size());
      deflate(&stream, flush);
      result.append(buffer.data(), buffer.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  } while (begin < bytes.size());
  return result;
}
}

//------------------------------------------------------------------------------
std::string encodeBinaryText(std::string_view bytes, bool isCompressed, const Run& run)
{
  std::string compressed;
  if (isCompressed)
  {
    compressed = deflated(bytes, run);
    bytes = compressed;
  }
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    unsigned int bits = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t j = 0; j < 3; ++j)
    {
      bits = bits << 8 | (j < count ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j)
    {
      text += j <= count ? letters[bits >> (18 - 6 * j) & 63U] : '=';
    }
  }
  return text;
}
}
