/// Append polygons of a file to a surface, one point id after another.

#ifndef ConformalPolygonList_h
#define ConformalPolygonList_h

#include "Bytes/ByteReader.h"
#include "Bytes/SurfaceData.h"

#include <algorithm>
#include <cstdint>

namespace conformal
{
/// Check that a number read from a file is a point id, and return this id.
/// @throws ParseError if no point has this id
std::int64_t checkedId(const ByteReader& input, std::int64_t id, std::uint64_t numberOfPoints);

/// Test whether a polygon has a point id twice.
bool hasRepeatedId(const std::int64_t* ids, std::size_t count);

/// Builder of the polygons of a surface. Polygons of fewer than 3 ids, or with a repeated id, are
/// dropped and counted in SurfaceData::DroppedPolygons.
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

  /// Reserve memory for `count` polygons, and for the ids of `count` triangles. The number of
  /// reserved ids does not exceed the number of remaining bytes of the input, since each id needs
  /// at least one byte.
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

  /// Finish the current polygon.
  /// @return whether the polygon was kept
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
