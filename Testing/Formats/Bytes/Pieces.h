// Read bytes piece by piece, as from a file.
#ifndef Pieces_h
#define Pieces_h

#include "Bytes/ByteReader.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>

namespace samples
{
inline conformal::ByteReader InPieces(const std::string& bytes)
{
  auto position = std::make_shared<std::size_t>(0);
  return conformal::ByteReader(
    [bytes, position](char* buffer, std::size_t size)
    {
      const std::size_t count = std::min(size, bytes.size() - *position);
      std::memcpy(buffer, bytes.data() + *position, count);
      *position += count;
      return count;
    },
    bytes.size(), [position](std::uint64_t offset) { *position = offset; });
}
}

#endif
