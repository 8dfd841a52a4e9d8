#include "Texture/PictureDensity.h"

#include "Mesh/GeodesicSphere.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>

namespace conformal
{
namespace
{
constexpr int MaximumProbeFrequency = 300; // 900,002 directions

/// Compute the slope of a picture by central differences along two axes.
double change(
  const Picture& picture, const SphereImage& image, const Vector3& direction, double step)
{
  const Vector3 u = direction.unitOrthogonal(), v = direction.cross(u);
  double squares = 0.0;
  for (const Vector3& axis : { u, v })
  {
    const PixelMix ahead = picture.Grid.mixAt(sphereToTexture(direction + step * axis, image)),
                   behind = picture.Grid.mixAt(sphereToTexture(direction - step * axis, image));
    for (int c = 0; c < picture.NumberOfComponents; ++c)
    {
      double difference = 0.0;
      for (std::size_t k = 0; k < ahead.Pixels.size(); ++k)
      {
        const Index components = picture.NumberOfComponents;
        difference += ahead.Weights[k] * picture.Values[ahead.Pixels[k] * components + c] -
          behind.Weights[k] * picture.Values[behind.Pixels[k] * components + c];
      }
      squares += difference * difference;
    }
  }
  return std::sqrt(squares) / (2.0 * step);
}

bool hasOneColor(const Picture& picture)
{
  const auto components = static_cast<std::size_t>(std::max(1, picture.NumberOfComponents));
  return picture.Values.size() <= components ||
    std::equal(picture.Values.begin() + static_cast<std::ptrdiff_t>(components),
      picture.Values.end(), picture.Values.begin());
}
}

//------------------------------------------------------------------------------
SphereDensity pictureDensity(Picture picture, const SphereImage& image)
{
  const Index size = picture.Grid.size();
  if (size <= 0 || picture.NumberOfComponents < 1 ||
    static_cast<Index>(picture.Values.size()) != size * picture.NumberOfComponents ||
    !std::all_of(picture.Values.begin(), picture.Values.end(),
      [](double value) { return std::isfinite(value); }))
  {
    throw std::invalid_argument("a picture needs pixels, and finite values for each of them");
  }
  const auto pixels = static_cast<double>(size);
  const double step = std::min(0.5, std::sqrt(4.0 * Pi / pixels));
  const int frequency =
    std::clamp(static_cast<int>(std::sqrt(pixels / 10.0)), 10, MaximumProbeFrequency);
  SphereDensity density;
  density.Directions = makeGeodesicSphere(frequency).Positions;
  density.Areas.assign(
    density.Directions.rows(), 4.0 * Pi / static_cast<double>(density.Directions.rows()));
  const auto kept = std::make_shared<const Picture>(std::move(picture));
  density.At = [kept, image, step](const Vector3& direction)
  { return change(*kept, image, direction, step); };
  return density;
}

//------------------------------------------------------------------------------
SphereDensity withDetails(
  SphereDensity density, Picture picture, const SphereImage& image, const Run& run)
{
  double largest = 0.0;
  for (const double value : picture.Values)
  {
    largest = std::max(largest, std::abs(value));
  }
  for (double& value : picture.Values)
  {
    value = largest > 0.0 ? value / largest : 0.0;
  }
  const bool isPlain = hasOneColor(picture); // rounding errors are no details
  SphereDensity details = pictureDensity(std::move(picture), image);
  if (isPlain || !isAnywhere(details, run))
  {
    return density;
  }
  return equalShares({ std::move(density), std::move(details) }, run);
}
}
