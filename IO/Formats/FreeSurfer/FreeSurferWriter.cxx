#include "FreeSurfer/FreeSurferWriter.h"

#include "Bytes/FloatRange.h"
#include "Bytes/SurfaceWalk.h"

#include <stdexcept>

namespace conformal
{
namespace
{
// Write the triangles of a surface. The function `coordinate` returns the coordinates of the
// points.
template <typename Coordinate>
std::string makeFreeSurfer(const SurfaceData& surface, Coordinate coordinate, const Run& run)
{
  requireTriangles(surface);
  const std::size_t size = 3 * surface.Points.numberOfTuples();
  requireFloatRange(size, coordinate);
  requireFinePositions(floatRoundingOf(size, coordinate));
  std::string bytes = "\xFF\xFF\xFE"
                      "created by ConformalSOM\n\n";
  appendBytes(bytes, static_cast<std::int32_t>(surface.Points.numberOfTuples()), true);
  appendBytes(bytes, static_cast<std::int32_t>(numberOfPolygons(surface)), true);
  walk(
    surface, run,
    [&](std::size_t point)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        appendBytes(bytes, static_cast<float>(coordinate(3 * point + c)), true);
      }
    },
    [&](std::size_t, const std::int64_t* ids, std::size_t count)
    {
      for (std::size_t c = 0; c < count; ++c)
      {
        appendBytes(bytes, static_cast<std::int32_t>(ids[c]), true);
      }
    });
  return bytes;
}
}

//------------------------------------------------------------------------------
std::string makeFreeSurferSurface(const SurfaceData& surface, const Run& run)
{
  return makeFreeSurfer(
    surface, [&](std::size_t i) { return valueOf(surface.Points, i); }, run);
}

//------------------------------------------------------------------------------
std::string makeFreeSurferSphere(const SurfaceData& surface, const Run& run)
{
  const CorticalSphere sphere(surface);
  return makeFreeSurfer(
    surface, [&](std::size_t i) { return sphere.coordinate(i); }, run);
}

//------------------------------------------------------------------------------
std::string makeFreeSurferCurv(
  const NamedArray& values, std::size_t numberOfPolygons, const Run& run)
{
  run.report(0.0);
  std::string bytes = "\xFF\xFF\xFF";
  appendBytes(bytes, static_cast<std::int32_t>(values.numberOfTuples()), true);
  appendBytes(bytes, static_cast<std::int32_t>(numberOfPolygons), true);
  appendBytes(bytes, std::int32_t(1), true);
  for (std::size_t i = 0; i < values.numberOfTuples(); ++i)
  {
    appendBytes(bytes, floatOf(valueOf(values, i), values.Name), true);
  }
  return bytes;
}
}
