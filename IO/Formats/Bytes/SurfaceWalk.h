/// Access the points, polygons and arrays of a surface, for writers.

#ifndef ConformalSurfaceWalk_h
#define ConformalSurfaceWalk_h

#include "Base/Run.h"
#include "Bytes/ByteOrder.h"
#include "Bytes/NumberText.h"
#include "Bytes/SurfaceData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
/// Find the array with a given name, a given number of components, and a type that satisfies
/// fits(). Return null if there is no such array.
template <typename Fits>
const NamedArray* findArray(
  const std::vector<NamedArray>& arrays, std::string_view name, std::size_t components, Fits fits)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(),
    [&](const NamedArray& array)
    { return array.Name == name && array.Components == components && fits(array.Type); });
  return found == arrays.end() ? nullptr : &*found;
}

/// Find the array "RGBA", or else the array "RGB". Return null if both are missing.
inline const NamedArray* findColors(const std::vector<NamedArray>& arrays)
{
  const NamedArray* colors = findArray(arrays, "RGBA", 4, isByte);
  return colors ? colors : findArray(arrays, "RGB", 3, isByte);
}

/// Return one number of an array as a double. The index counts the numbers of all tuples.
inline double valueOf(const NamedArray& array, std::size_t index)
{
  return withType(array.Type,
    [&](auto zero)
    {
      auto value = zero;
      std::memcpy(&value, array.Values.data() + index * sizeof(value), sizeof(value));
      return static_cast<double>(value);
    });
}

/// Find the array "SpherePosition", the positions of the points on the unit sphere. Return null if
/// there is no such array.
/// @throws std::invalid_argument if a position is zero or not finite
inline const NamedArray* findSpherePositions(const SurfaceData& surface)
{
  const NamedArray* sphere = findArray(surface.PointArrays, "SpherePosition", 3, isFloating);
  for (std::size_t i = 0; sphere && i < 3 * sphere->numberOfTuples(); i += 3)
  {
    const double length =
      std::hypot(valueOf(*sphere, i), valueOf(*sphere, i + 1), valueOf(*sphere, i + 2));
    if (!std::isfinite(length) || length == 0.0)
    {
      throw std::invalid_argument(
        "\"SpherePosition\" of point " + std::to_string(i / 3) + " is zero or not finite");
    }
  }
  return sphere;
}

/// Array "SpherePosition" of a surface, multiplied by 100. Neuroimaging programs map cortical
/// surfaces (of the brain) to spheres of radius 100.
/// @throws std::invalid_argument if there is no array "SpherePosition", or a position is zero or
///   not finite
class CorticalSphere
{
public:
  explicit CorticalSphere(const SurfaceData& surface)
    : Positions(findSpherePositions(surface))
  {
    if (!this->Positions)
    {
      throw std::invalid_argument("the surface has no array \"SpherePosition\" of 3 numbers");
    }
  }

  /// Return one coordinate. The index counts the coordinates of all points.
  double coordinate(std::size_t index) const { return Radius * valueOf(*this->Positions, index); }

private:
  static constexpr double Radius = 100.0;
  const NamedArray* Positions;
};

/// Append the numbers of a tuple as text, each after a blank.
inline void appendTuple(std::string& text, const NamedArray& array, std::size_t tuple)
{
  for (std::size_t c = 0; c < array.Components; ++c)
  {
    text += ' ';
    appendNumber(text, valueOf(array, tuple * array.Components + c));
  }
}

/// Append a color as text. Each number of the color, a byte, is divided by 255 and follows a blank.
/// The parsers of this library convert the fractions back to equal bytes. Other programs take a
/// number without a point for a byte, so that 0 and 1 are written as 0.0 and 1.0.
inline void appendColor(
  std::string& text, const NamedArray& colors, std::size_t tuple, std::size_t components)
{
  constexpr float whole = 255.0F;
  for (std::size_t c = 0; c < components; ++c)
  {
    const auto value = static_cast<float>(valueOf(colors, tuple * colors.Components + c)) / whole;
    text += ' ';
    appendNumber(text, value);
    text += value == 0.0F || value == 1.0F ? ".0" : "";
  }
}

inline void appendColor(std::string& text, const NamedArray& colors, std::size_t tuple)
{
  appendColor(text, colors, tuple, colors.Components);
}

inline std::size_t numberOfPolygons(const SurfaceData& surface)
{
  return surface.PolygonOffsets.size() > 0 ? surface.PolygonOffsets.size() - 1 : 0;
}

/// Call usePoint with the index of each point. Then call usePolygon with the index, the ids and the
/// number of ids of each polygon.
/// @throws Aborted if the progress callback of `run` returns false
template <typename UsePoint, typename UsePolygon>
void walk(const SurfaceData& surface, const Run& run, UsePoint usePoint, UsePolygon usePolygon)
{
  const std::size_t points = surface.Points.numberOfTuples();
  const std::size_t polygons = numberOfPolygons(surface);
  constexpr std::size_t step = 1 << 14;
  for (std::size_t i = 0; i < points + polygons; ++i)
  {
    if (i % step == 0)
    {
      run.report(static_cast<double>(i) / (points + polygons));
    }
    if (i < points)
    {
      usePoint(i);
      continue;
    }
    const std::size_t polygon = i - points;
    const std::int64_t begin = surface.PolygonOffsets[polygon];
    usePolygon(polygon, surface.PolygonIds.data() + begin,
      static_cast<std::size_t>(surface.PolygonOffsets[polygon + 1] - begin));
  }
}

/// Require that all polygons are triangles.
/// @throws std::invalid_argument if a polygon has fewer or more than 3 corners
inline void requireTriangles(const SurfaceData& surface)
{
  for (std::size_t polygon = 0; polygon < numberOfPolygons(surface); ++polygon)
  {
    if (surface.PolygonOffsets[polygon + 1] - surface.PolygonOffsets[polygon] != 3)
    {
      throw std::invalid_argument(
        "the surface has polygons that are not triangles; divide them into triangles first");
    }
  }
}
}

#endif
