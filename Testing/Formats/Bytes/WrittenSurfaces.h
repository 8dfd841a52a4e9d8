/// Make surfaces for tests of writers, and check that parsers read the same numbers, equal to the
/// last bit.

#ifndef ConformalWrittenSurfaces_h
#define ConformalWrittenSurfaces_h

#include "Bytes/ByteReader.h"
#include "ParsedArrays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace written
{
using conformal::makeArray;
using conformal::NamedArray;
using conformal::ScalarType;
using conformal::SurfaceData;
using conformal::SurfaceResult;

template <typename T>
NamedArray arrayOf(
  const char* name, ScalarType type, std::size_t components, const std::vector<T>& values)
{
  NamedArray array = makeArray(name, type, components);
  for (std::size_t i = 0; i < values.size(); i += components)
  {
    conformal::append(array, &values[i]);
  }
  return array;
}

template <typename T>
NamedArray randomArray(
  const char* name, ScalarType type, std::size_t components, std::size_t tuples, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<T> values;
  for (std::size_t i = 0; i < tuples * components; ++i)
  {
    values.push_back(
      static_cast<T>(std::is_floating_point<T>::value ? static_cast<double>(random()) / 1e7 - 100.0
                                                      : static_cast<double>(random() % 100)));
  }
  return arrayOf(name, type, components, values);
}

/// Return a tetrahedron of doubles with a given size, at a given distance from the origin.
inline SurfaceData distantTetrahedron(double size, double distance)
{
  SurfaceData data;
  std::vector<double> points;
  for (const double p : { 0.0, 0.0, 0.0, 0.9, 0.1, 0.0, 0.3, 0.7, 0.0, 0.2, 0.4, 0.8 })
  {
    points.push_back(distance + size * p);
  }
  data.Points = arrayOf("Points", ScalarType::Float64, 3, points);
  data.PolygonOffsets.push(0);
  for (const std::int64_t id : { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 })
  {
    data.PolygonIds.push(id);
    if (data.PolygonIds.size() % 3 == 0)
    {
      data.PolygonOffsets.push(static_cast<std::int64_t>(data.PolygonIds.size()));
    }
  }
  return data;
}

/// Expect an error if a writer of floats gets a surface far from the origin, whose shape rounding
/// would change. Surfaces closer to the origin must be written. Distant surfaces must also be
/// written if their coordinates are exact as floats.
template <typename Make>
void ExpectRefusesDistantSurfaces(Make make)
{
  EXPECT_NO_THROW(make(distantTetrahedron(1.0, 0.0)));
  EXPECT_NO_THROW(make(distantTetrahedron(1.0, 100.0)));
  EXPECT_NO_THROW(make(distantTetrahedron(1e-30, 1e-28)));
  EXPECT_NO_THROW(make(distantTetrahedron(1e30, 1e32)));
  EXPECT_NO_THROW(make(distantTetrahedron(0.0, 0.1))); // all points coincide
  SurfaceData floats = distantTetrahedron(1.0, 5e6);
  double* numbers = reinterpret_cast<double*>(floats.Points.Values.data());
  std::transform(numbers, numbers + 12, numbers,
    [](double p) { return static_cast<double>(static_cast<float>(p)); });
  EXPECT_NO_THROW(make(floats));
  for (const auto& [size, distance] : { std::pair{ 1.0, 1e3 }, std::pair{ 1.0, 5e6 },
         std::pair{ 1e-3, -1e8 }, std::pair{ 1e-30, 1.0 / 3.0 * 1e-26 } })
  {
    try
    {
      make(distantTetrahedron(size, distance));
      ADD_FAILURE() << size << " at " << distance << " was written";
    }
    catch (const std::invalid_argument& e)
    {
      EXPECT_NE(std::string(e.what()).find("too far from the origin"), std::string::npos)
        << e.what();
    }
  }
}

/// Return a tetrahedron of floats or doubles with numbers that are difficult to write exactly, such
/// as 1/3.
inline SurfaceData tetrahedron(bool isDouble)
{
  SurfaceData data;
  if (isDouble)
  {
    data.Points = arrayOf<double>("Points", ScalarType::Float64, 3,
      { 0.1, 1.0 / 3, 5e-324, 1234567.123456789, -1e300, 0, 0, 1, 0.7, -0.0, 0, 1e-3 });
  }
  else
  {
    data.Points = arrayOf<float>("Points", ScalarType::Float32, 3,
      { 0.1F, 1.0F / 3, 1e-45F, 1234567.1F, -1e38F, 0, 0, 1, 0.7F, -0.0F, 0, 1e-3F });
  }
  for (const std::int64_t id : { 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 })
  {
    data.PolygonIds.push(id);
  }
  for (const std::int64_t offset : { 0, 3, 6, 9, 12 })
  {
    data.PolygonOffsets.push(offset);
  }
  return data;
}

inline std::vector<double> asDoubles(const NamedArray& array)
{
  std::vector<double> result;
  conformal::withType(array.Type,
    [&](auto zero)
    {
      for (const auto value : samples::values<decltype(zero)>(array))
      {
        result.push_back(static_cast<double>(value));
      }
    });
  return result;
}

/// Expect arrays of the same names and values. If `areTypesKept` is true, also expect the same
/// types.
inline void ExpectSame(
  const std::vector<NamedArray>& read, const std::vector<NamedArray>& written, bool areTypesKept)
{
  ASSERT_EQ(read.size(), written.size());
  for (const NamedArray& array : written)
  {
    const NamedArray* other = samples::find(read, array.Name.c_str());
    ASSERT_NE(other, nullptr) << array.Name;
    EXPECT_EQ(other->Components, array.Components) << array.Name;
    EXPECT_EQ(asDoubles(*other), asDoubles(array)) << array.Name;
    if (areTypesKept)
    {
      EXPECT_EQ(other->Type, array.Type) << array.Name;
    }
  }
}

inline void ExpectSame(const SurfaceResult& read, const SurfaceData& written, bool areTypesKept)
{
  ASSERT_TRUE(read.Status.ok()) << read.Status.text();
  EXPECT_EQ(asDoubles(read.Data.Points), asDoubles(written.Points));
  EXPECT_EQ(samples::polygonIds(read.Data), samples::polygonIds(written));
  EXPECT_EQ(samples::polygonOffsets(read.Data), samples::polygonOffsets(written));
  if (areTypesKept)
  {
    EXPECT_EQ(read.Data.Points.Type, written.Points.Type);
  }
  ExpectSame(read.Data.PointArrays, written.PointArrays, areTypesKept);
  ExpectSame(read.Data.PolygonArrays, written.PolygonArrays, areTypesKept);
}

template <typename Parse>
SurfaceResult read(const std::string& bytes, Parse parse)
{
  conformal::ByteReader input{ std::string_view(bytes) };
  return parse(input);
}

inline NamedArray spherePositions()
{
  return arrayOf<double>(
    "SpherePosition", ScalarType::Float64, 3, { 0, 0, 1, 1, 0, 0, 0, -1, 0, 0.6, 0, 0.8 });
}

/// Return tetrahedra whose map has one position without a direction: zero, NaN or infinite.
inline std::vector<SurfaceData> surfacesWithABrokenMap()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<SurfaceData> surfaces;
  for (const std::array<double, 3>& direction : { std::array<double, 3>{ 0, 0, 0 }, { 1, nan, 0 },
         { 0, 0, std::numeric_limits<double>::infinity() } })
  {
    surfaces.push_back(tetrahedron(false));
    NamedArray map = makeArray("SpherePosition", ScalarType::Float64, 3);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::array<double, 3> north = { 0, 0, 1 };
      append(map, (i == 2 ? direction : north).data());
    }
    surfaces.back().PointArrays.push_back(std::move(map));
  }
  return surfaces;
}

/// Return a surface with a quadrilateral and a polygon of 2 corners, which together have as many
/// corners as two triangles.
inline SurfaceData surfaceWithAQuad()
{
  SurfaceData quads = tetrahedron(false);
  quads.PolygonOffsets[1] = 4;
  return quads;
}

template <typename Make>
void ExpectStopsWhenAsked(Make make)
{
  const conformal::Run stop({}, [](double) { return false; });
  EXPECT_THROW(make(tetrahedron(false), stop), conformal::Aborted);
}
}

#endif
