#include "SphericalTexture.h"

#include "SeamSplit.h"

#include <stdexcept>

namespace conformal
{
namespace
{
void check(const SphericalTextureOptions& options)
{
  for (double factor : { options.Scale[0], options.Scale[1] })
  {
    if (!(factor >= MinimumScale && factor <= MaximumScale))
    {
      throw std::invalid_argument("Scale must lie between 0.001 and 1000");
    }
  }
  if (!(options.Margin >= 0.0 && options.Margin <= MaximumMargin))
  {
    throw std::invalid_argument("Margin must lie between 0 and 1/4");
  }
}
}

//------------------------------------------------------------------------------
SphericalTexture makeSphericalTexture(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const SphericalTextureOptions& options,
  const ParallelFor& parallelFor, const Progress& progress)
{
  check(options);
  SphericalTexture texture;
  texture.Image = { options.Projection,
    chooseSphereView(points, triangles, spherePositions, options, partOf(progress, 0.0, 0.5)),
    options.FieldOfView, options.Scale, options.Margin };
  texture.Coordinates.resize(spherePositions.rows(), 2);
  texture.OutsideImage.resize(spherePositions.rows());
  constexpr Index blockSize = 1 << 12;
  forBlocks(parallelFor, spherePositions.rows(), blockSize, partOf(progress, 0.5, 0.7),
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const WrappedPlace place =
          wrapped(sphereToTexture(spherePositions.row(i), texture.Image), options.Wrap);
        texture.Coordinates.row(i) = place.Coordinates;
        texture.OutsideImage[i] = place.IsOutside;
      }
    });
  if (options.SplitSeam)
  {
    splitAtSeams(
      texture, triangles, spherePositions, options.Wrap, parallelFor, partOf(progress, 0.7, 1.0));
  }
  return texture;
}
}
