#include "GIFTI/GIFTIParser.h"

#include "Bytes/PolygonList.h"
#include "GIFTI/GIFTIFile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace conformal
{
namespace
{
bool isOf(const GIFTIArray& array, const char* intent)
{
  return array.Intent == intent;
}

std::string nameOf(const GIFTIArray& array)
{
  if (!array.Values.Name.empty())
  {
    return array.Values.Name;
  }
  std::string name = array.Intent.empty() ? "Array" : array.Intent;
  for (std::size_t i = 1; i < name.size(); ++i)
  {
    name[i] = name[i] >= 'A' && name[i] <= 'Z' ? static_cast<char>(name[i] - 'A' + 'a') : name[i];
  }
  return name;
}

void addArray(GIFTIArray& array, std::vector<NamedArray>& arrays)
{
  array.Values.Name = nameOf(array);
  arrays.push_back(std::move(array.Values));
}

// Find the array of an intent. There must be exactly one array of this intent.
GIFTIArray& find(const ByteReader& input, std::vector<GIFTIArray>& arrays, const char* intent)
{
  const auto isRight = [&](const GIFTIArray& array) { return isOf(array, intent); };
  if (std::count_if(arrays.begin(), arrays.end(), isRight) != 1)
  {
    input.fail(ParseCode::Malformed,
      std::string("expected one DataArray of the intent NIFTI_INTENT_") + intent);
  }
  return *std::find_if(arrays.begin(), arrays.end(), isRight);
}

bool areFinite(const NamedArray& points)
{
  return withType(points.Type,
    [&](auto zero)
    {
      for (std::size_t i = 0; i < points.Values.size(); i += sizeof(zero))
      {
        auto value = zero;
        std::memcpy(&value, points.Values.data() + i, sizeof(value));
        if (!std::isfinite(static_cast<double>(value)))
        {
          return false;
        }
      }
      return true;
    });
}

void addTriangles(const ByteReader& input, const NamedArray& triangles, SurfaceData& data)
{
  PolygonList polygons(input, data.Points.numberOfTuples(), data);
  data.PolygonOffsets.reserve(triangles.numberOfTuples() + 1);
  data.PolygonIds.reserve(3 * triangles.numberOfTuples());
  withType(triangles.Type,
    [&](auto zero)
    {
      for (std::size_t i = 0; i < triangles.Values.size(); i += 3 * sizeof(zero))
      {
        for (std::size_t c = 0; c < 3; ++c)
        {
          auto id = zero;
          std::memcpy(&id, triangles.Values.data() + i + c * sizeof(id), sizeof(id));
          polygons.add(static_cast<std::int64_t>(id));
        }
        polygons.end();
      }
    });
}
}

//------------------------------------------------------------------------------
SurfaceResult parseGIFTISurface(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data)
    {
      std::vector<GIFTIArray> arrays = readGIFTIFile(input, limits, run);
      data.Points = std::move(find(input, arrays, "POINTSET").Values);
      const NamedArray& triangles = find(input, arrays, "TRIANGLE").Values;
      if (!isFloating(data.Points.Type) || data.Points.Components != 3 ||
        isFloating(triangles.Type) || triangles.Components != 3)
      {
        input.fail(ParseCode::Malformed,
          "expected points of 3 floating numbers and triangles of 3 integers");
      }
      if (!areFinite(data.Points))
      {
        input.fail(ParseCode::Malformed, "found coordinates that are not finite");
      }
      addTriangles(input, triangles, data);
      for (GIFTIArray& array : arrays)
      {
        if (isOf(array, "POINTSET") || isOf(array, "TRIANGLE"))
        {
          continue;
        }
        if (array.Values.numberOfTuples() != data.Points.numberOfTuples())
        {
          input.fail(ParseCode::Malformed,
            "found an array of " + std::to_string(array.Values.numberOfTuples()) +
              " values, expected one for each point");
        }
        addArray(array, data.PointArrays);
      }
    });
}

//------------------------------------------------------------------------------
SurfaceResult parseGIFTIArrays(ByteReader& input, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data)
    {
      for (GIFTIArray& array : readGIFTIFile(input, limits, run))
      {
        if (!isOf(array, "POINTSET") && !isOf(array, "TRIANGLE"))
        {
          addArray(array, data.PointArrays);
        }
      }
    });
}
}
