#include "Texture/SphericalTexture.h"

#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Texture/SeamSplit.h"
#include "Texture/SphereViewChoice.h"

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
  const Points& spherePositions, const SphericalTextureOptions& options, const Run& run)
{
  check(options);
  // View, coordinates, seams.
  Steps steps(run, { options.UseViewPoint ? 2.4 : 0.3, 0.1, options.SplitSeam ? 0.6 : 0.0 });
  SphericalTexture texture;
  const Run choosing = steps.next();
  texture.Image = { options.Projection, {}, options.FieldOfView, options.Scale, options.Margin };
  if (isHemisphere(options.Projection)) // the view is not used
  {
    requireMap(points, triangles, spherePositions);
    unitBoxOf(points); // rejects points that are not finite
  }
  else
  {
    texture.Image.View = chooseSphereView(points, triangles, spherePositions, options, choosing);
  }
  texture.Coordinates.resize(spherePositions.rows(), 2);
  texture.OutsideImage.resize(spherePositions.rows());
  constexpr Index blockSize = 1 << 12;
  forBlocksReporting(steps.next(), spherePositions.rows(), blockSize,
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
    splitAtSeams(texture, triangles, spherePositions, options.Wrap, steps.next());
  }
  return texture;
}
}
