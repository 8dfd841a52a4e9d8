#include "Bytes/PolygonList.h"

#include <algorithm>
#include <string>
#include <vector>

namespace conformal
{
//------------------------------------------------------------------------------
std::int64_t checkedId(const ByteReader& input, std::int64_t id, std::uint64_t numberOfPoints)
{
  if (id < 0 || static_cast<std::uint64_t>(id) >= numberOfPoints)
  {
    input.fail(ParseCode::Malformed,
      "found id " + std::to_string(id) + ", expected 0 <= id < " + std::to_string(numberOfPoints));
  }
  return id;
}

//------------------------------------------------------------------------------
bool hasRepeatedId(const std::int64_t* ids, std::size_t count)
{
  constexpr std::size_t few = 16;
  if (count <= few)
  {
    for (std::size_t i = 1; i < count; ++i)
    {
      if (std::find(ids, ids + i, ids[i]) != ids + i)
      {
        return true;
      }
    }
    return false;
  }
  std::vector<std::int64_t> sorted(ids, ids + count);
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}
}
