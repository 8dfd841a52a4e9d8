#include "Texture/AveragedTexture.h"

#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Search/PointTree.h"
#include "Search/TriangleTree.h"
#include "Sphere/SphereLocator.h"
#include "Sphere/SphereOrientation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace conformal
{
namespace
{
constexpr int FewestPoints = 3; // of a mean, where the scan has few points
constexpr int MostPoints = 64;  // of a mean, where it has many
constexpr double Widening =
  1.05; // of the radius, so that the last of the fewest points has a weight
// Part of a pixel's radius within which all points have about equal weights.
constexpr double Core = 0.5;
constexpr Index MostSamples = 4; // along a side of a pixel

Points copyOf(const PointView& cloud)
{
  Points positions(cloud.size(), 3);
  for (Index i = 0; i < cloud.size(); ++i)
  {
    positions.row(i) = cloud[i];
  }
  return positions;
}

// Surface that finds its points by texture coordinates of an image.
class PicturedSurface
{
public:
  PicturedSurface(const MappedMesh& surface, const SphereImage& image, const Run& run)
    : Surface(surface)
    , Image(image)
    , Triangles(turnedOutward(surface.Triangles, surface.SpherePositions))
    , Locator(surface.SpherePositions, this->Triangles, run)
  {
  }

  // Return false at holes of the map.
  bool find(const Vector2& st, Vector3& x) const
  {
    const SphereLocation location = this->Locator.locate(textureToSphere(st, this->Image));
    if (location.Triangle < 0)
    {
      return false;
    }
    x.setZero();
    for (int k = 0; k < 3; ++k)
    {
      x += location.Barycentric[k] *
        Vector3(this->Surface.Positions.row(this->Triangles(location.Triangle, k)));
    }
    return true;
  }

  // Return half the size of a pixel on the surface: the longer of the ways to its sides.
  double radius(const Vector2& st, const Vector3& x, const PixelGrid& grid) const
  {
    double longest = 0.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double half = 0.5 / static_cast<double>(axis == 0 ? grid.Width : grid.Height);
      double shortest = std::numeric_limits<double>::infinity();
      for (const double step : { -half, half })
      {
        Vector2 side = st;
        side[axis] += 0.999 * step; // within the image
        Vector3 y;
        if (this->find(side, y))
        {
          shortest = std::min(shortest, (y - x).norm()); // the other side may be across a seam
        }
      }
      longest = std::max(longest, std::isfinite(shortest) ? shortest : 0.0);
    }
    return longest;
  }

private:
  const MappedMesh& Surface;
  const SphereImage& Image;
  conformal::Triangles Triangles;
  SphereLocator Locator;
};

// Mean of the points near x. The weights are those of \cite Franke1980 for scattered data, except
// that they are bounded in the middle of a pixel.
class PointMean
{
public:
  PointMean(const PointView& cloud, const Run& run)
    : Tree(cloud, run)
  {
  }

  void operator()(
    const Vector3& x, double radius, std::vector<Neighbor>& near, PointMixture& mixture) const
  {
    for (int count = 2 * FewestPoints;; count *= 2)
    {
      this->Tree.nearest(x, count, near);
      if (count >= MostPoints || static_cast<int>(near.size()) < count ||
        near.back().SquareDistance >= radius * radius)
      {
        break;
      }
    }
    const auto last = std::min<std::size_t>(FewestPoints, near.size()) - 1;
    const double outer = std::max(radius, Widening * std::sqrt(near[last].SquareDistance));
    const double core = std::max(Core * radius, 1e-6 * outer);
    double sum = 0.0;
    for (const Neighbor& neighbor : near)
    {
      const double distance = std::sqrt(neighbor.SquareDistance);
      if (distance < outer)
      {
        const double weight = (1.0 - distance / outer) * (outer / std::max(distance, core));
        mixture.emplace_back(neighbor.Id, weight * weight);
        sum += weight * weight;
      }
    }
    if (!(sum > 0.0)) // all distances are 0
    {
      mixture.assign(1, { near.front().Id, 1.0 });
      sum = 1.0;
    }
    for (auto& [id, weight] : mixture)
    {
      weight /= sum;
    }
  }

private:
  PointTree Tree;
};

double meanEdge(const Points& positions, const Triangles& triangles)
{
  double sum = 0.0;
  for (Index i = 0; i < triangles.rows(); ++i)
  {
    sum += (positions.row(triangles(i, 0)) - positions.row(triangles(i, 1))).norm();
  }
  return sum / static_cast<double>(triangles.rows());
}

// Mean of the closest points of triangles, over samples of a pixel.
class TriangleMean
{
public:
  TriangleMean(const PointView& cloud, const Triangles& triangles, const Run& run)
    : Corners(triangles)
  {
    const Points positions = copyOf(cloud);
    if (!positions.allFinite())
    {
      throw std::invalid_argument("points of the source are not finite");
    }
    this->Edge = meanEdge(positions, triangles);
    this->Tree = TriangleTree(positions, triangles, run);
  }

  Index samplesFor(double radius) const
  {
    const double samples = this->Edge > 0.0 ? std::ceil(2.0 * radius / this->Edge) : 1.0;
    return std::clamp<Index>(static_cast<Index>(std::min(samples, 1e3)), 2, MostSamples);
  }

  void add(const Vector3& x, int& hint, PointMixture& mixture) const
  {
    const FootPoint foot = this->Tree.closestPoint(x, hint);
    hint = foot.Triangle;
    for (int k = 0; k < 3 && hint >= 0; ++k)
    {
      mixture.emplace_back(this->Corners(hint, k), foot.Barycentric[k]);
    }
  }

private:
  Triangles Corners;
  TriangleTree Tree;
  double Edge = 0.0;
};

void scale(PointMixture& mixture)
{
  double sum = 0.0;
  for (const auto& [id, weight] : mixture)
  {
    sum += weight;
  }
  for (auto& [id, weight] : mixture)
  {
    weight /= sum;
  }
}

using Mix = std::function<void(const Vector2& st, PointMixture& mixture, int& hint)>;

void forPixels(const PixelGrid& grid, const Mix& mix, const MixtureSink& sink, const Run& run)
{
  forBlocksReporting(run, grid.size(), HeavyBlock,
    [&](Index begin, Index end)
    {
      std::vector<PointMixture> mixtures(end - begin);
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        mix(grid.middleOf(i), mixtures[i - begin], hint);
      }
      sink(begin, mixtures);
    });
}

void check(const MappedMesh& surface, const PointView& cloud)
{
  if (surface.Triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  if (cloud.size() == 0)
  {
    throw std::invalid_argument("the source has no points");
  }
  unitBoxOf(surface.Positions); // throws if they are not finite
}
}

//------------------------------------------------------------------------------
void averageSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const MixtureSink& sink, const Run& run)
{
  if (grid.Width < 1 || grid.Height < 1)
  {
    throw std::invalid_argument("an image must have at least one pixel");
  }
  check(surface, cloud);
  Steps steps(run, { 0.1, 0.1, 0.8 }); // locator, tree, pixels
  const PicturedSurface pictured(surface, image, steps.next());
  if (cloudTriangles.rows() == 0)
  {
    const PointMean mean(cloud, steps.next());
    forPixels(
      grid,
      [&](const Vector2& st, PointMixture& mixture, int&)
      {
        Vector3 x;
        if (pictured.find(st, x))
        {
          std::vector<Neighbor> near;
          mean(x, pictured.radius(st, x, grid), near, mixture);
        }
      },
      sink, steps.next());
    return;
  }
  const TriangleMean mean(cloud, cloudTriangles, steps.next());
  forPixels(
    grid,
    [&](const Vector2& st, PointMixture& mixture, int& hint)
    {
      Vector3 x;
      if (!pictured.find(st, x))
      {
        return;
      }
      const Index samples = mean.samplesFor(pictured.radius(st, x, grid));
      for (Index k = 0; k < samples * samples; ++k)
      {
        const auto offset = [&](Index i, Index size)
        {
          return ((static_cast<double>(i) + 0.5) / static_cast<double>(samples) - 0.5) /
            static_cast<double>(size);
        };
        const Vector2 at =
          st + Vector2(offset(k % samples, grid.Width), offset(k / samples, grid.Height));
        if (pictured.find(at, x))
        {
          mean.add(x, hint, mixture);
        }
      }
      scale(mixture);
    },
    sink, steps.next());
}

//------------------------------------------------------------------------------
double widthPerHeight(const SphereImage& image)
{
  switch (image.Projection)
  {
    case SphereProjection::LongitudeLatitude:
      return 2.0;
    case SphereProjection::CubeMap:
      return 1.5;
    default:
      return image.Scale[0] / image.Scale[1];
  }
}

//------------------------------------------------------------------------------
Index imageHeightFor(const MappedMesh& surface, const PointView& cloud, const SphereImage& image,
  double pixelsPerPoint, const Run& run)
{
  constexpr Index numberOfSamples = 20000, step = 64, highest = 4096;
  constexpr double share = 0.95;
  constexpr int around = 8;
  check(surface, cloud);
  if (!(pixelsPerPoint > 0.0) || !std::isfinite(pixelsPerPoint))
  {
    throw std::invalid_argument("the number of pixels for each point must be above 0");
  }
  Steps steps(run, { 0.3, 0.3, 0.4 }); // trees, samples
  const PointTree points(cloud, steps.next());
  const TriangleTree triangles(surface.Positions, surface.Triangles, steps.next());
  const Index count = std::min(cloud.size(), numberOfSamples);
  std::vector<double> heights(count);
  const double ratio = widthPerHeight(image);
  forBlocksReporting(steps.next(), count, HeavyBlock,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> near;
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 x = cloud[i * cloud.size() / count];
        points.nearest(x, around + 1, near); // with the point itself
        const double square = near.back().SquareDistance;
        const int triangle = triangles.closestPoint(x).Triangle;
        if (triangle < 0 || near.size() < 2)
        {
          continue;
        }
        Vector3 corners[3];
        Vector2 st[3];
        int patch = -1;
        for (int k = 0; k < 3; ++k)
        {
          const int id = surface.Triangles(triangle, k);
          corners[k] = surface.Positions.row(id);
          const Vector3 n = surface.SpherePositions.row(id);
          patch = patch < 0 ? patchOf(n, image) : patch;
          st[k] = patchToTexture(n, image, patch); // without a jump at a seam
        }
        const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
        const Vector2 a = st[1] - st[0], b = st[2] - st[0];
        const double ofImage = std::abs(a[0] * b[1] - a[1] * b[0]);
        const double areaOfPoint = Pi * square / static_cast<double>(near.size() - 1);
        // Let H be the height; ratio * H^2 * ofImage / area * areaOfPoint = pixelsPerPoint.
        heights[i] = std::sqrt(pixelsPerPoint * area / (ratio * ofImage * areaOfPoint));
      }
    });
  heights.erase(std::remove_if(heights.begin(), heights.end(),
                  [](double height) { return !std::isfinite(height) || height <= 0.0; }),
    heights.end());
  if (heights.empty())
  {
    return step;
  }
  const auto place = heights.begin() + static_cast<std::ptrdiff_t>(share * (heights.size() - 1));
  std::nth_element(heights.begin(), place, heights.end());
  const double steps64 = std::ceil(std::min(*place, double(highest)) / double(step));
  return std::clamp(static_cast<Index>(steps64) * step, step, highest);
}
}
