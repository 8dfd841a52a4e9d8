#include "Learn/Fit/VertexSupport.h"

#include "Base/MortonOrder.h"
#include "Base/Steps.h"
#include "Cloud/SampleSpacing.h"
#include "Mesh/Mesh.h"
#include "Mesh/VertexNormals.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
constexpr Index SamplesOfSupport = 4;

/// Return a smooth step from 1 at 0 to 0 at 1 and beyond, with zero derivatives at both.
double fall(double x)
{
  const double t = std::clamp(x, 0.0, 1.0);
  return 1.0 - t * t * (3.0 - 2.0 * t);
}

/// Normal of the triangle closest to each sample.
Points normalsAtFeet(const Points& samples, const Points& positions, const Triangles& triangles,
  const TriangleTree& tree, const Run& run)
{
  Points normals(samples.rows(), 3);
  // The samples are in the cube [-1, 1]^3. Neighbors on the curve are near the same triangles.
  const std::vector<int> order = mortonOrder(
    samples.rows(), [&](Index i) { return Vector3(0.5 * (samples.row(i).array() + 1.0)); },
    run.unwatched());
  forBlocksReporting(run, samples.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        hint = tree.closestPoint(samples.row(order[i]), hint).Triangle;
        normals.row(order[i]) = areaVector(positions, triangles, hint).stableNormalized();
      }
    });
  return normals;
}
}

std::vector<double> supportOfVertices(const TrainingSamples& samples, const Points& positions,
  const Triangles& triangles, const Run& run)
{
  constexpr double near = 1.6, far = 2.4; // distances of the sixth neighbor
  // Limits in typical spacings: few samples lie in a ring around a pole of scan lines, and outliers
  // are far apart.
  constexpr double narrowest = 0.5, widest = 4.0;
  constexpr double opposite = -0.2;        // cosine; normals vary at sharp edges
  constexpr int first = 8, farthest = 128; // neighbors tested for their side
  const Index size = positions.rows();
  Steps steps(run, { 0.1, 0.4, 0.5 }); // tree, feet, distances
  const TriangleTree tree(positions, triangles, steps.next().unwatched());
  const Points selected = selectedSamples(samples, SamplesOfSupport * size);
  const Points sides = normalsAtFeet(selected, positions, triangles, tree, steps.next());
  const Points normals = vertexNormals(positions, triangles);
  const SampleSpacing spacing(selected);
  std::vector<double> distances(size), spacings(size), support(size);
  forBlocksReporting(steps.next(), size, HeavyBlock,
    [&](Index begin, Index end)
    {
      std::vector<Neighbor> around;
      for (Index i = begin; i < end; ++i)
      {
        const auto isOnThisSide = [&](const Neighbor& neighbor)
        { return sides.row(neighbor.Id).dot(normals.row(i)) > opposite; };
        Neighbor nearest;
        for (int count = first; count <= farthest && nearest.Id < 0; count *= 4)
        {
          spacing.tree().nearest(positions.row(i), count, around);
          const auto found = std::find_if(around.begin(), around.end(), isOnThisSide);
          nearest = found != around.end() ? *found : count == farthest ? around.back() : Neighbor();
        }
        distances[i] = std::sqrt(nearest.SquareDistance);
        spacings[i] = spacing.at(nearest.Id, around).Radius;
      }
    });
  std::vector<double> sorted = spacings;
  std::nth_element(sorted.begin(), sorted.begin() + size / 2, sorted.end());
  const double usual = sorted[size / 2];
  for (Index i = 0; i < size; ++i)
  {
    const double unit = std::clamp(spacings[i], narrowest * usual, widest * usual);
    support[i] =
      unit > 0.0 ? fall((distances[i] / unit - near) / (far - near)) : double(distances[i] == 0.0);
  }
  return support;
}
}
