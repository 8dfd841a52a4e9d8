/// Define a surface of points, polygons and arrays, the output of parsers and the input of writers.

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
/// Surface of #P points and #F polygons. A surface without polygons is a cloud.
struct SurfaceData
{
  NamedArray Points;                   ///< #P by 3, Float32 or Float64
  std::vector<NamedArray> PointArrays; ///< #P tuples each; names are unique
  std::vector<NamedArray>
    PolygonArrays; ///< one tuple for each polygon; no arrays if a file has strips or a grid
  /// #F + 1 offsets of the polygons in PolygonIds; may be empty
  OwnedArray<std::int64_t> PolygonOffsets;
  OwnedArray<std::int64_t> PolygonIds; ///< point ids in [0, #P), without repeated ids in a polygon

  std::uint64_t DroppedPoints = 0; ///< number of points omitted because a coordinate is not finite
  std::uint64_t DroppedPolygons = 0; ///< number of polygons omitted: under 3 ids, or a repeated id
  std::uint64_t ReplacedValues = 0;  ///< number of array values that were not finite, replaced by 0
  std::uint64_t SkippedLines = 0;    ///< number of text lines that are not points
  std::uint64_t UnreadBytes = 0;     ///< number of bytes after the data that the header states
  std::uint64_t MissingScans = 0;    ///< number of listed scans that do not exist
};

struct SurfaceResult
{
  ParseStatus Status;
  SurfaceData Data; ///< empty unless Status.ok()
};

/// Run a parser on an empty surface, and return the surface and the status. Memory that is not used
/// is released. Values that are not finite are replaced by 0. If several arrays have the same name,
/// a number is appended to the names of the second and further arrays.
SurfaceResult parseSurface(const std::function<void(SurfaceData&)>& parse);
}

#endif
