/// Polygons read from a file, one point id after another.

#ifndef ConformalPolygonList_h
#define ConformalPolygonList_h

#include "Bytes/ByteReader.h"
#include "Bytes/SurfaceData.h"

#include <algorithm>
#include <cstdint>

namespace conformal
{
/// An id that one of so many points has.
/// @throws ParseError if it is none
std::int64_t checkedId(const ByteReader& input, std::int64_t id, std::uint64_t numberOfPoints);

/// Whether a polygon has an id twice.
bool hasRepeatedId(const std::int64_t* ids, std::size_t count);

/// Appends polygons to a surface. Those of fewer than 3 ids, or with an id twice, are dropped and
/// counted.
class PolygonList
{
public:
  PolygonList(const ByteReader& input, std::uint64_t numberOfPoints, SurfaceData& data)
    : Input(input)
    , NumberOfPoints(numberOfPoints)
    , Data(data)
  {
    if (data.PolygonOffsets.size() == 0)
    {
      data.PolygonOffsets.push(0);
    }
    this->Begin = data.PolygonIds.size();
  }

  /// Memory for so many polygons, and for their ids if they are triangles. An id takes a byte of
  /// the input at least.
  void reserve(std::size_t count)
  {
    this->Data.PolygonOffsets.reserve(this->Data.PolygonOffsets.size() + count);
    this->Data.PolygonIds.reserve(
      this->Data.PolygonIds.size() + std::min<std::uint64_t>(3 * count, this->Input.left()));
  }

  void add(std::int64_t id)
  {
    this->Data.PolygonIds.push(checkedId(this->Input, id, this->NumberOfPoints));
  }

  /// End the polygon. Returns whether it was kept.
  bool end()
  {
    auto& ids = this->Data.PolygonIds;
    const std::size_t corners = ids.size() - this->Begin;
    if (corners < 3 || hasRepeatedId(ids.data() + this->Begin, corners))
    {
      ids.resize(this->Begin);
      ++this->Data.DroppedPolygons;
      return false;
    }
    this->Begin = ids.size();
    this->Data.PolygonOffsets.push(static_cast<std::int64_t>(this->Begin));
    return true;
  }

private:
  const ByteReader& Input;
  const std::uint64_t NumberOfPoints;
  SurfaceData& Data;
  std::size_t Begin = 0;
};
}

#endif
