/// Points, polygons and arrays: the output of parsers and the input of writers.

#ifndef ConformalSurfaceData_h
#define ConformalSurfaceData_h

#include "Bytes/NamedArray.h"
#include "Bytes/OwnedArray.h"
#include "Bytes/ParseStatus.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace conformal
{
struct SurfaceData
{
  NamedArray Points;                   ///< #P by 3, Float32 or Float64
  std::vector<NamedArray> PointArrays; ///< #P tuples each, of unique names
  std::vector<NamedArray>
    PolygonArrays; ///< one tuple for each polygon; none if strips or a grid produced more polygons
  /// #F + 1: offset of the ids of each polygon; may be empty
  OwnedArray<std::int64_t> PolygonOffsets;
  OwnedArray<std::int64_t> PolygonIds; ///< in [0, #P), without repeated ids in a polygon

  std::uint64_t DroppedPoints = 0;   ///< points of a cloud with coordinates that are not finite
  std::uint64_t DroppedPolygons = 0; ///< polygons of fewer than 3 ids, or with a repeated id
  std::uint64_t ReplacedValues = 0;  ///< values of arrays that were not finite and became 0
  std::uint64_t SkippedLines = 0;    ///< lines of a text that are not points
  std::uint64_t UnreadBytes = 0;     ///< bytes after the data promised by the header
  std::uint64_t MissingScans = 0;    ///< scans listed in the file that do not exist
};

struct SurfaceResult
{
  ParseStatus Status;
  SurfaceData Data; ///< empty unless Status.ok()
};

/// Run a parser on empty data and return its data and status. Spare memory is released, and values
/// that are not finite are replaced. Arrays of one name are numbered from the second on.
SurfaceResult parseSurface(const std::function<void(SurfaceData&)>& parse);
}

#endif
