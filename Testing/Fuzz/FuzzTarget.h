// Run a parser in a fuzzer, and check its result.
#ifndef FuzzTarget_h
#define FuzzTarget_h

#include "Bytes/ByteReader.h"
#include "Bytes/SurfaceData.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace fuzz
{
inline void require(bool condition)
{
  if (!condition)
  {
    std::abort();
  }
}

inline void requireWhole(const conformal::NamedArray& array, std::size_t tuples)
{
  require(array.Values.size() == tuples * array.tupleBytes());
  conformal::withType(array.Type,
    [&](auto zero)
    {
      for (std::size_t i = 0; i < array.Values.size(); i += sizeof(zero))
      {
        auto value = zero;
        std::memcpy(&value, array.Values.data() + i, sizeof(value));
        require(std::isfinite(static_cast<double>(value)));
      }
    });
}

inline void requireWhole(const conformal::SurfaceData& data, bool hasPoints)
{
  const std::size_t points = data.Points.numberOfTuples();
  requireWhole(data.Points, points);
  for (const conformal::NamedArray& array : data.PointArrays)
  {
    requireWhole(array, hasPoints ? points : array.numberOfTuples());
  }
  const std::size_t polygons = data.PolygonOffsets.size() > 0 ? data.PolygonOffsets.size() - 1 : 0;
  for (const conformal::NamedArray& array : data.PolygonArrays)
  {
    requireWhole(array, polygons);
  }
  for (std::size_t i = 0; i < polygons; ++i)
  {
    require(data.PolygonOffsets[i + 1] >= data.PolygonOffsets[i] + 3);
  }
  for (std::size_t i = 0; i < data.PolygonIds.size(); ++i)
  {
    require(data.PolygonIds[i] >= 0 && data.PolygonIds[i] < static_cast<std::int64_t>(points));
  }
}

/// Parse bytes. Abort the process unless the result is valid data, or an empty result with an error
/// message and a position.
template <typename Parse>
int run(const std::uint8_t* bytes, std::size_t size, Parse parse, bool hasPoints = true)
{
  conformal::ByteReader input{ std::string_view(reinterpret_cast<const char*>(bytes), size) };
  const conformal::SurfaceResult result = parse(input);
  if (result.Status.ok())
  {
    requireWhole(result.Data, hasPoints);
  }
  else
  {
    require(!result.Status.Message.empty() && result.Status.Offset <= size);
    require(result.Data.Points.Values.size() == 0 && result.Data.PolygonIds.size() == 0);
  }
  return 0;
}
}

#endif
