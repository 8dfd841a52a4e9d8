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
    PolygonArrays; ///< one tuple for each polygon; none for files with triangle strips or grids
  /// #F + 1 offsets: the ids of polygon f are PolygonIds[i] for PolygonOffsets[f] <= i <
  /// PolygonOffsets[f + 1]. If there are no polygons, the array may be empty
  OwnedArray<std::int64_t> PolygonOffsets;
  OwnedArray<std::int64_t> PolygonIds; ///< point ids in [0, #P), without repeated ids in a polygon

  /// Position of the scanner that measured all points, 3 numbers; empty if unknown
  std::vector<double> ScannerPosition;

  /// Vector that the parser subtracted from the coordinates of the file, 3 numbers; empty if none
  std::vector<double> CoordinateShift;

  std::uint64_t DroppedPoints = 0; ///< number of points omitted because a coordinate is not finite
  std::uint64_t DroppedPolygons = 0; ///< number of polygons omitted: under 3 ids, or a repeated id
  std::uint64_t ReplacedValues = 0;  ///< number of array values that were not finite, replaced by 0
  std::uint64_t SkippedLines = 0;    ///< number of lines omitted because they are not points
  std::uint64_t UnreadBytes = 0; ///< number of extra bytes after all data that the header declares
  /// Number of scans whose files do not exist, although a list of scans (.conf) contains them.
  std::uint64_t MissingScans = 0;
};

struct SurfaceResult
{
  ParseStatus Status;
  SurfaceData Data; ///< empty unless Status.ok()
};

/// Run a parser on an empty surface, and return the surface and the status. Reserved memory that is
/// not used is released. Array values that are not finite are replaced by 0. If several arrays have
/// the same name, a number is appended to the names of the second and further arrays.
SurfaceResult parseSurface(const std::function<void(SurfaceData&)>& parse);
}

#endif
