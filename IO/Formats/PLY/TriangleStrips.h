/// Convert triangle strips to triangles.

#ifndef ConformalTriangleStrips_h
#define ConformalTriangleStrips_h

#include "Bytes/OwnedArray.h"

#include <cstdint>

namespace conformal
{
/// Convert triangle strips to triangles. In a strip, each id after the second forms a triangle with
/// the two ids before it. Every second triangle is reversed, so that all triangles have the
/// orientation of the first triangle. Repeated ids in files serve only to join strips or to change
/// the direction of a strip. Triangles with a repeated id are therefore no part of the surface, and
/// are omitted.
class TriangleStrips
{
public:
  TriangleStrips(OwnedArray<std::int64_t>& offsets, OwnedArray<std::int64_t>& ids)
    : Offsets(offsets)
    , Ids(ids)
  {
  }

  void endStrip() { this->Length = 0; }

  void add(std::int64_t id)
  {
    const std::int64_t a = this->First;
    const std::int64_t b = this->Second;
    this->First = b;
    this->Second = id;
    ++this->Length;
    if (this->Length < 3 || a == b || b == id || id == a)
    {
      return;
    }
    const bool isTurned = this->Length % 2 == 0;
    this->Ids.push(isTurned ? b : a);
    this->Ids.push(isTurned ? a : b);
    this->Ids.push(id);
    this->Offsets.push(static_cast<std::int64_t>(this->Ids.size()));
  }

private:
  OwnedArray<std::int64_t>& Offsets;
  OwnedArray<std::int64_t>& Ids;
  std::int64_t First = 0;
  std::int64_t Second = 0;
  std::uint64_t Length = 0;
};
}

#endif
