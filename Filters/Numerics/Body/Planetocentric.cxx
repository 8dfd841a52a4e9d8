#include "Body/Planetocentric.h"

#include "Base/Steps.h"
#include "Search/OutermostHits.h"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace conformal
{
//------------------------------------------------------------------------------
PlanetocentricFrame planetocentricFrame(const BodyCoordinatesOptions& options)
{
  PlanetocentricFrame frame;
  frame.Center = options.Center;
  const Vector3 north = options.RotationAxis.stableNormalized();
  const Vector3 zero = options.UseMarkerPoint ? Vector3(options.MarkerPoint - options.Center)
                                              : towardsLongitudeZero(north);
  const Vector3 across = zero - zero.dot(north) * north;
  constexpr double least = 1e-9; // of a vector on an oblique axis, rounding leaves about 1e-16
  if (!(across.stableNorm() > least * zero.stableNorm()))
  {
    throw std::invalid_argument("MarkerPoint is on the rotation axis, so it has no longitude");
  }
  const Vector3 x = across.stableNormalized();
  frame.Axes << x, north.cross(x), north;
  return frame;
}

//------------------------------------------------------------------------------
Points planetocentricCoordinates(
  const Points& points, const PlanetocentricFrame& frame, const Run& run)
{
  Points result(points.rows(), 3);
  forBlocks(run, points.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 x = frame.Axes.transpose() * (points.row(i).transpose() - frame.Center);
        const Vector2 degrees = toLongitudeLatitude(x);
        result.row(i) << degrees[0], degrees[1], x.norm();
      }
    });
  return result;
}

//------------------------------------------------------------------------------
void paintPlanetocentricMap(const Mesh& body, const PlanetocentricFrame& frame,
  const MapImage& image, const PixelSink& sink, const Run& run)
{
  if (image.Grid.size() == 0 || body.Triangles.rows() == 0)
  {
    throw std::invalid_argument("a map needs pixels, and a body with triangles");
  }
  Steps steps(run, { 0.1, 0.9 });
  const OutermostHits hits(body.Positions, body.Triangles, steps.next());
  forBlocksReporting(steps.next(), image.Grid.size(), LightBlock,
    [&](Index begin, Index end)
    {
      std::vector<SurfacePlace> places(end - begin);
      for (Index i = begin; i < end; ++i)
      {
        Vector3 n;
        if (!image.directionOf(i, n))
        {
          continue;
        }
        const RayHit hit = hits.along(frame.Center, (frame.Axes * n).normalized());
        if (hit.Triangle >= 0)
        {
          SurfacePlace& place = places[i - begin];
          place.Weights = hit.Barycentric;
          for (int k = 0; k < 3; ++k)
          {
            place.Ids[k] = body.Triangles(hit.Triangle, k);
          }
        }
      }
      sink(begin, places);
    });
}
}
