#include "Learn/Fit/SurfaceQuality.h"

#include "Base/Steps.h"
#include "Cloud/CloudThinning.h"
#include "Cloud/FootPoints.h"
#include "Cloud/Orientation.h"
#include "Cloud/StrayPoints.h"
#include "Cloud/WindingNumbers.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/Mesh.h"
#include "Mesh/MeshTopology.h"
#include "Search/PointTree.h"
#include "Search/TriangleTree.h"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace conformal
{
namespace
{
constexpr double EvaluatedSamples = 10000.0;

// Wide enough that two sides of a surface through one set of samples cancel.
constexpr double WidthOfSpacing = 1.0, WidthOfNoise = 2.5;

double foldedFraction(const Points& positions, const Triangles& triangles)
{
  constexpr double cosine = -0.866; // of 150 degrees
  Points normals(triangles.rows(), 3);
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    normals.row(r) = areaVector(positions, triangles, r).stableNormalized();
  }
  const Triangles across = triangleNeighbors(triangles, positions.rows());
  Index folded = 0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int other = across(r, k);
      folded += other > r && normals.row(r).dot(normals.row(other)) < cosine;
    }
  }
  return static_cast<double>(folded) / (1.5 * static_cast<double>(triangles.rows()));
}

// Foot points of samples on the surface.
struct Feet
{
  Points Normals;              // #P by 3, of its triangles
  std::vector<double> Offsets; // along the normals, outward
};

Feet feetOf(
  const Points& points, const Points& positions, const Triangles& triangles, const Run& run)
{
  Steps steps(run, { 0.5, 0.5 }); // tree, foot points
  const TriangleTree tree(positions, triangles, steps.next());
  Feet feet;
  feet.Normals.resize(points.rows(), 3);
  feet.Offsets.resize(points.rows());
  forBlocksReporting(steps.next(), points.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        const FootPoint foot = tree.closestPoint(points.row(i), hint);
        hint = foot.Triangle;
        feet.Normals.row(i) = areaVector(positions, triangles, hint).stableNormalized();
        const Vector3 corner = positions.row(triangles(hint, 0));
        feet.Offsets[i] = std::copysign(
          std::sqrt(foot.SquareDistance), feet.Normals.row(i).dot(Vector3(points.row(i)) - corner));
      }
    });
  return feet;
}

// Compute the area that each sample represents: larger in sparse parts, and 0 for outliers. It is
// limited by that of the neighbors, so that a few isolated points do not count as a large part.
std::vector<double> weightsOf(const Points& points, const Run& run)
{
  constexpr double far = 2.5;
  constexpr int few = 4, neighbors = 8, rank = 2;
  constexpr double maximumRatio = 2.5; // times as much as among fewer neighbors
  const std::vector<std::uint8_t> isolated = isolatedPoints(points, far, run);
  const PointTree tree(points, run);
  const auto size = static_cast<std::size_t>(points.rows());
  std::vector<double> areas(size), weights(size, 0.0);
  std::vector<std::array<int, neighbors>> around(size); // the point itself is the first
  std::vector<Neighbor> nearest;
  for (std::size_t i = 0; i < size; ++i)
  {
    tree.nearest(points.row(static_cast<Index>(i)), neighbors + 1, nearest);
    areas[i] = Pi *
      std::min(nearest[neighbors].SquareDistance / neighbors,
        maximumRatio * nearest[few].SquareDistance / few);
    std::transform(nearest.begin(), nearest.begin() + neighbors, around[i].begin(),
      [](const Neighbor& neighbor) { return neighbor.Id; });
  }
  std::array<double, neighbors> theirs;
  for (std::size_t i = 0; i < size; ++i)
  {
    if (!isolated[i])
    {
      std::transform(around[i].begin(), around[i].end(), theirs.begin(),
        [&](int neighbor) { return areas[neighbor]; });
      std::nth_element(theirs.begin(), theirs.begin() + rank, theirs.end());
      weights[i] = theirs[rank];
    }
  }
  return weights;
}

// Compute the weighted fraction of the samples that lie off the plane of their neighbors.
double undersampledFraction(const Points& asked, const std::vector<double>& weights,
  const TrainingSamples& samples, double noise, const Run& run)
{
  constexpr double maximum = 50000.0, distanceOfShape = 0.02, distanceOfNoise = 4.0;
  constexpr int neighbors = 8;
  const double distance = std::max(distanceOfShape, distanceOfNoise * noise);
  const Points cloud = selectSamples(samples, maximum).Positions;
  if (cloud.rows() <= neighbors)
  {
    return 0.0;
  }
  const PointTree tree(cloud, run);
  std::vector<std::uint8_t> off(asked.rows(), 0);
  forBlocks(run, asked.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        off[i] = std::abs(planeNear(cloud, tree, asked.row(i), neighbors).Offset) > distance;
      }
    });
  double all = 0.0, undersampled = 0.0;
  for (std::size_t i = 0; i < off.size(); ++i)
  {
    all += weights[i];
    undersampled += off[i] ? weights[i] : 0.0;
  }
  return all > 0.0 ? undersampled / all : 0.0;
}

// Compute the mean square distance of neighbors from a quadratic polynomial over the tangent plane.
// It is small if the samples lie on one curved surface, however far they are from the flat
// triangles of a coarse mesh.
double squareOffQuadric(
  const Points& points, const std::vector<int>& ids, const Vector3& place, const Vector3& normal)
{
  constexpr Index coefficients = 6;
  const auto size = static_cast<Index>(ids.size());
  const Vector3 u = normal.unitOrthogonal(), v = normal.cross(u);
  Eigen::MatrixXd terms(size, coefficients);
  Eigen::VectorXd heights(size);
  double maximum = 0.0;
  for (Index k = 0; k < size; ++k)
  {
    const Vector3 x = Vector3(points.row(ids[static_cast<std::size_t>(k)])) - place;
    terms(k, 1) = u.dot(x);
    terms(k, 2) = v.dot(x);
    heights[k] = normal.dot(x);
    maximum = std::max({ maximum, std::abs(terms(k, 1)), std::abs(terms(k, 2)) });
  }
  terms.middleCols(1, 2) /= maximum > 0.0 ? maximum : 1.0;
  terms.col(0).setOnes();
  terms.col(3) = terms.col(1).cwiseAbs2();
  terms.col(4) = terms.col(1).cwiseProduct(terms.col(2));
  terms.col(5) = terms.col(2).cwiseAbs2();
  const Eigen::VectorXd fitted = terms * terms.colPivHouseholderQr().solve(heights);
  return (heights - fitted).squaredNorm() / static_cast<double>(size - coefficients);
}

// Iteration over samples with enough neighbors on their side of the surface.
class NeighborsOnSide
{
public:
  static constexpr int Count = 24;

  NeighborsOnSide(const Points& asked, const Feet& feet, double near, const Run& run)
    : Asked(asked)
    , Offsets(feet.Offsets)
    , Normals(feet.Normals)
    , Near(near)
    , Tree(asked, run)
  {
  }

  template <typename Body>
  void forEach(Index begin, Index end, const Body& body) const
  {
    constexpr double sameSide = 0.5;
    std::vector<Neighbor> nearest;
    std::vector<int> ids;
    for (Index i = begin; i < end; ++i)
    {
      this->Tree.nearest(this->Asked.row(i), Count, nearest);
      ids.clear();
      for (const Neighbor& neighbor : nearest)
      {
        if (std::abs(this->Offsets[neighbor.Id]) <= this->Near &&
          this->Normals.row(i).dot(this->Normals.row(neighbor.Id)) > sameSide)
        {
          ids.push_back(neighbor.Id);
        }
      }
      if (2 * ids.size() >= Count)
      {
        body(i, ids);
      }
    }
  }

private:
  const Points& Asked;
  const std::vector<double>& Offsets;
  const Points& Normals;
  const double Near;
  PointTree Tree;
};

// Central moments of the offsets of neighbors from the surface, summed over samples.
struct OffsetMoments
{
  double Second = 0.0, SquareOfSecond = 0.0, Fourth = 0.0;

  void add(const std::vector<double>& offsets)
  {
    const auto count = static_cast<double>(offsets.size());
    const double mean = std::accumulate(offsets.begin(), offsets.end(), 0.0) / count;
    double second = 0.0, fourth = 0.0;
    for (const double offset : offsets)
    {
      const double square = (offset - mean) * (offset - mean);
      second += square / count;
      fourth += square * square / count;
    }
    this->Second += second;
    this->SquareOfSecond += second * second;
    this->Fourth += fourth;
  }

  void add(const OffsetMoments& other)
  {
    this->Second += other.Second;
    this->SquareOfSecond += other.SquareOfSecond;
    this->Fourth += other.Fourth;
  }
};

OffsetMoments offsetMoments(
  const NeighborsOnSide& neighbors, const Feet& feet, Index size, const Run& run)
{
  std::vector<OffsetMoments> sums((size + HeavyBlock - 1) / HeavyBlock);
  forBlocks(run, size, HeavyBlock,
    [&](Index begin, Index end)
    {
      std::vector<double> offsets;
      neighbors.forEach(begin, end,
        [&](Index, const std::vector<int>& ids)
        {
          offsets.clear();
          for (const int id : ids)
          {
            offsets.push_back(feet.Offsets[id]);
          }
          sums[begin / HeavyBlock].add(offsets);
        });
    });
  OffsetMoments all;
  for (const OffsetMoments& sum : sums)
  {
    all.add(sum);
  }
  return all;
}

// Compute the distance between two layers of samples, or 0 for one layer.
double layerDistance(const Points& asked, const Feet& feet, double near, const Run& run)
{
  constexpr double minimumDistance = 0.004, maximumKurtosis = 2.15;
  constexpr double minimumOffQuadric = 0.5; // of the offsets' variance; about 1 for layers
  if (asked.rows() < NeighborsOnSide::Count)
  {
    return 0.0;
  }
  const NeighborsOnSide neighbors(asked, feet, near, run);
  const OffsetMoments all = offsetMoments(neighbors, feet, asked.rows(), run);
  const double apart = all.Second > 0.0 ? 2.0 * std::sqrt(all.SquareOfSecond / all.Second) : 0.0;
  if (!(apart > minimumDistance && all.Fourth < maximumKurtosis * all.SquareOfSecond))
  {
    return 0.0;
  }
  // Offsets from the triangles of a coarse mesh have two values, too: at corners and inside.
  std::vector<double> squares((asked.rows() + HeavyBlock - 1) / HeavyBlock, 0.0);
  forBlocks(run, asked.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      neighbors.forEach(begin, end,
        [&](Index i, const std::vector<int>& ids)
        {
          squares[begin / HeavyBlock] +=
            squareOffQuadric(asked, ids, asked.row(i), feet.Normals.row(i));
        });
    });
  const double offQuadric = std::accumulate(squares.begin(), squares.end(), 0.0);
  return offQuadric > minimumOffQuadric * all.Second ? apart : 0.0;
}

// Compute the outward directions of the surface at the points.
Points outwardDirections(
  const OrientedPoints& asked, const Points& normals, double width, const Run& run)
{
  const WindingNumbers numbers(asked.Positions, run);
  if (asked.Normals.rows() > 0)
  {
    Points areas = areaVectors(asked.Positions, asked.Normals, run);
    if (turnOutward(numbers, areas, width, run))
    {
      // Single normals may be wrong. All of them together are right, except between close sides.
      constexpr double opposite = -0.5; // cosine
      const Points outward = numbers.descentAtPoints(areas, width, run);
      for (Index i = 0; i < areas.rows(); ++i)
      {
        const double cosine =
          areas.row(i).stableNormalized().dot(outward.row(i).stableNormalized());
        areas.row(i) *= cosine < opposite ? -1.0 : 1.0;
      }
      return areas;
    }
  }
  return numbers.descentAtPoints(areaVectors(asked.Positions, normals, run), width, run);
}
}

//------------------------------------------------------------------------------
SurfaceQuality evaluateSurface(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run)
{
  constexpr double distanceOfSpacing = 1.5, distanceOfNoise = 5.0;
  SurfaceQuality quality;
  quality.FoldedFraction = foldedFraction(positions, triangles);
  const OrientedPoints asked = selectSamples(samples, EvaluatedSamples);
  const Index size = asked.Positions.rows();
  if (size < MinimumEvaluated || samples.dimension() < 3)
  {
    quality.UndersampledFraction = samples.dimension() < 3 ? 0.0 : 1.0;
    return quality;
  }
  Steps steps(run, { 0.15, 0.85 }); // foot points, winding numbers
  const Feet feet = feetOf(asked.Positions, positions, triangles, steps.next());
  steps.next();
  const double spacing = typicalSpacing(asked.Positions, run.unwatched());
  const double spacingOfAll =
    spacing * std::sqrt(static_cast<double>(size) / static_cast<double>(samples.totalSize()));
  const Points outward = outwardDirections(
    asked, feet.Normals, std::max(WidthOfSpacing * spacing, WidthOfNoise * noise), run.unwatched());
  const double near = std::max(distanceOfSpacing * spacingOfAll, distanceOfNoise * noise);
  const std::vector<double> weights = weightsOf(asked.Positions, run.unwatched());
  double counted = 0.0, uncovered = 0.0, inverted = 0.0;
  for (Index i = 0; i < size; ++i)
  {
    counted += weights[i];
    if (std::abs(feet.Offsets[i]) > near)
    {
      uncovered += weights[i];
    }
    else if (feet.Normals.row(i).dot(outward.row(i)) < 0.0)
    {
      inverted += weights[i];
    }
  }
  quality.UndersampledFraction =
    undersampledFraction(asked.Positions, weights, samples, noise, run.unwatched());
  quality.LayerDistance = layerDistance(asked.Positions, feet, near, run.unwatched());
  if (counted > 0.0)
  {
    quality.UncoveredFraction = uncovered / counted;
    quality.InvertedFraction = inverted / counted;
  }
  return quality;
}

//------------------------------------------------------------------------------
Index countBeyondReach(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, double noise, const Run& run)
{
  constexpr double deviations = 5.0, largestSpacing = 0.01;
  const double spacing =
    std::sqrt(surfaceArea(positions, triangles) / static_cast<double>(samples.totalSize()));
  const double limit = std::max(deviations * noise, std::min(spacing, largestSpacing));
  const TriangleTree tree(positions, triangles, run.unwatched());
  std::int64_t count = 0;
  forEachFoot(
    samples, tree, samples.size(), [](Index i) { return i; },
    [&](Index, const Vector3&, const FootPoint& foot)
    { count += foot.SquareDistance > limit * limit; },
    run);
  samples.reduce().sum(&count, 1);
  return count;
}

//------------------------------------------------------------------------------
SurfaceQuality withoutLeftOut(SurfaceQuality quality, Index leftOut, Index all)
{
  quality.UncoveredFraction -= static_cast<double>(leftOut) / static_cast<double>(all);
  return quality;
}

//------------------------------------------------------------------------------
double defectScore(const SurfaceQuality& quality)
{
  using Tolerated = ToleratedQuality;
  return std::max({ quality.UncoveredFraction / Tolerated::UncoveredFraction,
    quality.InvertedFraction / Tolerated::InvertedFraction,
    quality.FoldedFraction / Tolerated::FoldedFraction });
}
}
