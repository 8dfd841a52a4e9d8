#include "Bytes/SurfacePairing.h"

#include "Bytes/UnitVectors.h"

#include <algorithm>

namespace conformal
{
namespace
{
template <typename T>
bool areSame(const OwnedArray<T>& a, const OwnedArray<T>& b)
{
  return a.size() == b.size() && std::equal(a.data(), a.data() + a.size(), b.data());
}

// Open and parse a file. Return false if the surface was not read, the path is empty, or parsing
// failed.
bool readBeside(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse,
  SurfaceResult& beside)
{
  if (!surface.Status.ok() || path.empty())
  {
    return false;
  }
  ByteReader input;
  beside.Status = openFile(path, input);
  if (beside.Status.ok())
  {
    beside = parse(input);
  }
  return beside.Status.ok();
}

void fail(SurfaceResult& surface, const std::string& path, ParseStatus status)
{
  status.Message += " (in " + path + ")";
  surface.Data = SurfaceData();
  surface.Status = std::move(status);
}

NamedArray asDoubles(const NamedArray& points)
{
  NamedArray doubles = makeArray("SpherePosition", ScalarType::Float64, 3);
  const std::size_t count = 3 * points.numberOfTuples();
  doubles.Values.resize(count * sizeof(double));
  withType(points.Type,
    [&](auto zero)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        auto value = zero;
        std::memcpy(&value, points.Values.data() + i * sizeof(value), sizeof(value));
        const auto converted = static_cast<double>(value);
        std::memcpy(doubles.Values.data() + i * sizeof(converted), &converted, sizeof(converted));
      }
    });
  return doubles;
}
}

//------------------------------------------------------------------------------
void addSphere(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse)
{
  SurfaceResult sphere;
  if (!readBeside(surface, path, parse, sphere))
  {
    if (!sphere.Status.ok())
    {
      fail(surface, path, sphere.Status);
    }
    return;
  }
  const SurfaceData& data = surface.Data;
  if (data.Points.numberOfTuples() != sphere.Data.Points.numberOfTuples() ||
    !areSame(data.PolygonOffsets, sphere.Data.PolygonOffsets) ||
    !areSame(data.PolygonIds, sphere.Data.PolygonIds))
  {
    fail(surface, path,
      { ParseCode::Malformed, 0, 0, "expected a sphere of the surface's points and polygons" });
    return;
  }
  NamedArray positions = asDoubles(sphere.Data.Points);
  if (!makeUnitVectors(positions))
  {
    fail(surface, path,
      { ParseCode::Malformed, 0, 0, "found a sphere point at the center of the sphere" });
    return;
  }
  auto& arrays = surface.Data.PointArrays;
  arrays.erase(std::remove_if(arrays.begin(), arrays.end(),
                 [&](const NamedArray& array) { return array.Name == positions.Name; }),
    arrays.end());
  arrays.push_back(std::move(positions));
}

//------------------------------------------------------------------------------
void addPointArrays(SurfaceResult& surface, const std::string& path, const ParseSurfaceFile& parse)
{
  SurfaceResult arrays;
  if (!readBeside(surface, path, parse, arrays))
  {
    if (!arrays.Status.ok())
    {
      fail(surface, path, arrays.Status);
    }
    return;
  }
  const std::size_t points = surface.Data.Points.numberOfTuples();
  for (NamedArray& array : arrays.Data.PointArrays)
  {
    if (array.numberOfTuples() != points)
    {
      fail(surface, path,
        { ParseCode::Malformed, 0, 0,
          "found " + std::to_string(array.numberOfTuples()) + " values, expected one for each of " +
            std::to_string(points) + " points" });
      return;
    }
    surface.Data.PointArrays.push_back(std::move(array));
  }
  makeNamesUnique(surface.Data.PointArrays);
  surface.Data.ReplacedValues += arrays.Data.ReplacedValues;
}
}
