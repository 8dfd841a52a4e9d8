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
  std::vector<NamedArray> PointArrays; ///< #P tuples each, of names of their own
  std::vector<NamedArray>
    PolygonArrays; ///< one tuple for each polygon; none if strips or a grid gave more polygons
  OwnedArray<std::int64_t> PolygonOffsets; ///< #F + 1: where each polygon's ids begin; may be empty
  OwnedArray<std::int64_t> PolygonIds;     ///< in [0, #P), no id twice in a polygon

  std::uint64_t DroppedPoints = 0;   ///< of a cloud, whose coordinates were not finite
  std::uint64_t DroppedPolygons = 0; ///< of fewer than 3 ids, or with an id twice
  std::uint64_t ReplacedValues = 0;  ///< of point and polygon arrays, not finite, now 0
  std::uint64_t SkippedLines = 0;    ///< of a text, which were no points
  std::uint64_t UnreadBytes = 0;     ///< behind all that the file's header promises
  std::uint64_t MissingScans = 0;    ///< that the file names and that are not there
};

struct SurfaceResult
{
  ParseStatus Status;
  SurfaceData Data; ///< empty unless Status.ok()
};

/// Run a parser on empty data; what it throws becomes the status. Spare memory is given back,
/// values that are not finite are replaced, and of several arrays of one name all but the first get
/// a number behind it.
SurfaceResult parseSurface(const std::function<void(SurfaceData&)>& parse);
}

#endif
