#include "Motion/TriangleCorrespondence.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Sphere/SphereLocator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
using Parts = std::vector<std::pair<int, double>>; // ids and weights

/// Locate points of target triangles in the source.
class Sampler
{
public:
  Sampler(const MappedMesh& source, const MappedMesh& target, int maximum, const Run& run)
    : Source(source)
    , Target(target)
    , Maximum(maximum)
    , Locator(source.SpherePositions, source.Triangles, run)
  {
  }

  /// Find the source triangles that cover a target triangle.
  /// @param[in,out] hint  source triangle that may be near
  Parts trianglesOf(Index r, int& hint) const
  {
    const Vector3 third = Vector3::Constant(1.0 / 3.0);
    hint = this->locate(this->directionOf(r, third), hint).Triangle;
    const int n = this->subdivision(r, hint);
    if (n == 1)
    {
      return { { hint, 1.0 } };
    }
    std::vector<int> ids;
    const auto add = [&](double i, double j)
    {
      const Vector3 weights(1.0 - (i + j) / n, i / n, j / n);
      ids.push_back(this->locate(this->directionOf(r, weights), hint).Triangle);
    };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n - i; ++j)
      {
        add(i + 1.0 / 3.0, j + 1.0 / 3.0);
        if (j < n - i - 1)
        {
          add(i + 2.0 / 3.0, j + 2.0 / 3.0);
        }
      }
    }
    std::sort(ids.begin(), ids.end());
    Parts parts;
    for (const int id : ids)
    {
      if (parts.empty() || parts.back().first != id)
      {
        parts.emplace_back(id, 0.0);
      }
      parts.back().second += 1.0;
    }
    return parts;
  }

  /// Find the corners of the source triangle at a target vertex.
  Parts cornersOf(Index v, int& hint) const
  {
    const SphereLocation place = this->locate(this->Target.SpherePositions.row(v), hint);
    hint = place.Triangle;
    Parts parts;
    for (int k = 0; k < 3; ++k)
    {
      parts.emplace_back(this->Source.Triangles(hint, k), place.Barycentric[k]);
    }
    return parts;
  }

private:
  SphereLocation locate(const Vector3& direction, int hint) const
  {
    SphereLocation location = this->Locator.locate(direction, hint);
    if (location.Triangle < 0) // cannot occur if the source covers the sphere
    {
      location = { 0, Vector3::UnitX() };
    }
    return location;
  }

  Vector3 directionOf(Index r, const Vector3& weights) const
  {
    const Points& sphere = this->Target.SpherePositions;
    const auto ids = this->Target.Triangles.row(r);
    const Vector3 direction = weights[0] * sphere.row(ids[0]) + weights[1] * sphere.row(ids[1]) +
      weights[2] * sphere.row(ids[2]);
    const Vector3 unit = unitVector(direction);
    // Only a triangle as large as the sphere has a point at its center.
    return unit.allFinite() ? unit : Vector3(sphere.row(ids[0]));
  }

  int subdivision(Index r, int id) const
  {
    const double own = areaVector(this->Target.SpherePositions, this->Target.Triangles, r).norm();
    const double other =
      areaVector(this->Source.SpherePositions, this->Source.Triangles, id).norm();
    const double wanted = other > 0.0 ? std::ceil(2.0 * std::sqrt(own / other)) : 1.0;
    return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(this->Maximum)));
  }

  const MappedMesh& Source;
  const MappedMesh& Target;
  int Maximum;
  SphereLocator Locator;
};

/// Collect the rows of a matrix of weights, which are computed on all threads.
template <typename PartsOf>
ResampleWeights collected(Index size, const PartsOf& partsOf, const Run& run)
{
  std::vector<Parts> rows(size);
  forBlocksReporting(run, size, HeavyBlock,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        rows[i] = partsOf(i, hint);
      }
    });
  ResampleWeights weights;
  for (const Parts& parts : rows)
  {
    weights.add(parts);
  }
  return weights;
}
}

//------------------------------------------------------------------------------
SurfaceCorrespondence correspondingTriangles(const MappedMesh& source, const MappedMesh& target,
  const TriangleCorrespondenceOptions& options, const Run& run)
{
  Steps steps(run, { 0.2, 0.65, 0.15 }); // locator, triangles, vertices
  const Sampler sampler(source, target, options.MaximumSubdivision, steps.next());
  SurfaceCorrespondence result;
  result.TriangleWeights = collected(
    target.Triangles.rows(), [&](Index r, int& hint) { return sampler.trianglesOf(r, hint); },
    steps.next());
  result.VertexWeights = collected(
    target.SpherePositions.rows(), [&](Index v, int& hint) { return sampler.cornersOf(v, hint); },
    steps.next());
  return result;
}
}
