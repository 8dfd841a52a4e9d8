#include "Body/MapAreas.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace conformal
{
namespace
{
// Triangle of the body: its area, its position on the sphere, and the ratio of both areas.
struct MappedTriangle
{
  double Area, Ratio;
  Vector3 Direction;
};

std::vector<MappedTriangle> mappedTriangles(const MappedMesh& body)
{
  std::vector<MappedTriangle> result;
  for (Index r = 0; r < body.Triangles.rows(); ++r)
  {
    const double area = areaVector(body.Positions, body.Triangles, r).norm(),
                 onSphere = areaVector(body.SpherePositions, body.Triangles, r).norm();
    Vector3 middle = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      middle += body.SpherePositions.row(body.Triangles(r, k)).transpose();
    }
    const double ratio = std::log(area) - std::log(onSphere), length = middle.norm();
    if (std::isfinite(ratio) && length > 0.0)
    {
      result.push_back({ area, ratio, middle / length });
    }
  }
  return result;
}

double varianceOnCapsule(const std::vector<MappedTriangle>& triangles, double aspect)
{
  double sum = 0.0, first = 0.0, second = 0.0;
  for (const MappedTriangle& triangle : triangles)
  {
    const double d = triangle.Ratio -
      2.0 * std::log(capsuleScale(triangle.Direction, MapProjection::Capsule, aspect));
    sum += triangle.Area;
    first += triangle.Area * d;
    second += triangle.Area * d * d;
  }
  return sum > 0.0 ? second / sum - (first / sum) * (first / sum) : 0.0;
}
}

//------------------------------------------------------------------------------
double findCapsuleAspect(const MappedMesh& body, const Run& run)
{
  if (body.Triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  const std::vector<MappedTriangle> triangles = mappedTriangles(body);
  double best = 1.0, least = varianceOnCapsule(triangles, best), step = 1.0;
  // First all whole numbers, then smaller steps around the best aspect.
  constexpr int levels = 3;
  for (int level = 0; level < levels; ++level, step *= 0.1)
  {
    const double from = level == 0 ? 1.0 : best - 10.0 * step,
                 to = level == 0 ? MaximumCapsuleAspect : best + 10.0 * step;
    const int steps = static_cast<int>(std::lround((to - from) / step));
    for (int i = 0; i <= steps; ++i)
    {
      run.report((level + double(i) / steps) / levels);
      const double aspect = from + i * step;
      const double variance = aspect >= 1.0 && aspect <= MaximumCapsuleAspect + 1e-9
        ? varianceOnCapsule(triangles, aspect)
        : least;
      if (variance < least)
      {
        least = variance;
        best = aspect;
      }
    }
  }
  return std::clamp(std::round(100.0 * best) / 100.0, 1.0, MaximumCapsuleAspect);
}

//------------------------------------------------------------------------------
double capsuleAspectOf(
  const MappedMesh& body, MapProjection projection, double aspect, const Run& run)
{
  if (!std::isfinite(aspect))
  {
    throw std::invalid_argument("CapsuleAspect must be finite");
  }
  if (projection != MapProjection::Capsule)
  {
    return 1.0;
  }
  return aspect >= 1.0 ? std::min(aspect, MaximumCapsuleAspect) : findCapsuleAspect(body, run);
}

//------------------------------------------------------------------------------
double areaOfPixel(
  const MappedMesh& body, const MapImage& image, Index pixel, const SurfacePlace& place)
{
  Vector3 middle;
  if (place.Ids[0] < 0 || !image.directionOf(pixel, middle))
  {
    return 0.0;
  }
  const Vector2 pixels = image.Grid.middleOf(pixel).cwiseProduct(
    Vector2(double(image.Grid.Width), double(image.Grid.Height)));
  // Intersection of a direction with the plane of the triangle, from differences: triangles of long
  // bodies can be tiny on the sphere.
  const auto at = [&](const Vector3& n)
  {
    Vector3 sum = Vector3::Zero();
    double weights = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 a = body.SpherePositions.row(place.Ids[(k + 1) % 3]).transpose() - n,
                    b = body.SpherePositions.row(place.Ids[(k + 2) % 3]).transpose() - n;
      const double weight = n.dot(a.cross(b));
      sum += weight * body.Positions.row(place.Ids[k]).transpose();
      weights += weight;
    }
    return Vector3(sum / weights);
  };
  // Beyond the outline of the map, the difference is one-sided.
  const auto derivative = [&](const Vector2& step)
  {
    Vector3 before = middle, after = middle;
    const double width = double(image.fromPixels(pixels - step, before)) +
      double(image.fromPixels(pixels + step, after));
    return Vector3((at(after) - at(before)) / (std::max(width, 1.0) * step.sum()));
  };
  constexpr double step = 0.1; // pixels
  const double area = derivative({ step, 0.0 }).cross(derivative({ 0.0, step })).norm();
  return std::isfinite(area) ? area : 0.0;
}

//------------------------------------------------------------------------------
PixelAreas comparePixelAreas(std::vector<double> areas)
{
  PixelAreas result;
  std::vector<double> shown;
  std::copy_if(
    areas.begin(), areas.end(), std::back_inserter(shown), [](double area) { return area > 0.0; });
  double sum = 0.0;
  for (const double area : shown)
  {
    sum += area;
  }
  const double mean = shown.empty() ? 1.0 : sum / double(shown.size());
  for (double& area : areas)
  {
    area /= mean;
  }
  std::sort(shown.begin(), shown.end());
  constexpr double tail = 0.05;
  double before = 0.0;
  for (const double area : shown)
  {
    result.Low = before < tail * sum ? area / mean : result.Low;
    result.High = before <= (1.0 - tail) * sum ? area / mean : result.High;
    before += area;
  }
  result.Scales = std::move(areas);
  return result;
}
}
