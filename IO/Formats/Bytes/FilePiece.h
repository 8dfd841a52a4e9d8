/// Divide the points of a file into parts, so that each of several ranks (processes) reads one
/// part.

#ifndef ConformalFilePiece_h
#define ConformalFilePiece_h

#include <cstdint>

namespace conformal
{
/// One of Count equal parts of a file. The default is the whole file. If the points of a file
/// cannot be divided, all points belong to the first part.
struct FilePiece
{
  std::uint64_t Number = 0; ///< index of the part, in [0, Count)
  std::uint64_t Count = 1;  ///< number of parts, at most 2^32

  bool isFirst() const { return this->Number == 0; }
  bool isLast() const { return this->Number + 1 == this->Count; }
  bool isWhole() const { return this->Count == 1; }

  /// Return the index of the first item (point or byte) of this part of a file of `size` items. The
  /// function end() returns the index of the first item of the next part.
  std::uint64_t begin(std::uint64_t size) const { return this->cut(size, this->Number); }
  std::uint64_t end(std::uint64_t size) const { return this->cut(size, this->Number + 1); }

private:
  // Compute size * number / Count without overflow.
  std::uint64_t cut(std::uint64_t size, std::uint64_t number) const
  {
    return size / this->Count * number + size % this->Count * number / this->Count;
  }
};
}

#endif
