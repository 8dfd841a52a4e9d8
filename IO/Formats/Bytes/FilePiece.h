/// The part of a file's points that one of several processes reads.

#ifndef ConformalFilePiece_h
#define ConformalFilePiece_h

#include <cstdint>

namespace conformal
{
/// One of so many equal parts, the whole by default. What cannot be cut belongs to the first.
struct FilePiece
{
  std::uint64_t Number = 0; ///< in [0, Count)
  std::uint64_t Count = 1;  ///< at most 2^32

  bool isFirst() const { return this->Number == 0; }
  bool isLast() const { return this->Number + 1 == this->Count; }
  bool isWhole() const { return this->Count == 1; }

  /// Where it begins among so many things, and where the next one does.
  std::uint64_t begin(std::uint64_t size) const { return this->cut(size, this->Number); }
  std::uint64_t end(std::uint64_t size) const { return this->cut(size, this->Number + 1); }

private:
  // size * number / Count, without an overflow.
  std::uint64_t cut(std::uint64_t size, std::uint64_t number) const
  {
    return size / this->Count * number + size % this->Count * number / this->Count;
  }
};
}

#endif
