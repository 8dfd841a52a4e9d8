#include "Register/SphereSamples.h"

#include "Base/Steps.h"

#include <utility>

namespace conformal
{
//------------------------------------------------------------------------------
SphereGrid::SphereGrid(Mesh sphere, const Run& run)
  : Sphere(std::move(sphere))
  , Locator(this->Sphere.Positions, this->Sphere.Triangles, run)
{
}

//------------------------------------------------------------------------------
SphereWeights SphereGrid::weightsAt(const Vector3& direction, int hint) const
{
  SphereWeights result;
  const SphereLocation location = this->Locator.locate(direction, hint);
  result.Triangle = location.Triangle;
  result.Weights = location.Barycentric;
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k)
  {
    result.Ids[k] = this->Sphere.Triangles(location.Triangle, k);
    corners.row(k) = this->Sphere.Positions.row(result.Ids[k]);
  }
  // Let W be the matrix whose rows are the dual basis of the corners. The line of direction p
  // intersects the plane of the triangle. The barycentric weights of the intersection are W p,
  // scaled to sum 1.
  Eigen::Matrix3d dual;
  for (int k = 0; k < 3; ++k)
  {
    dual.row(k) = corners.row(next(k)).cross(corners.row(previous(k)));
  }
  dual /= corners.row(0).dot(dual.row(0));
  const Eigen::RowVector3d sum = dual.colwise().sum();
  result.Slopes = (dual - result.Weights * sum) / sum.dot(direction);
  return result;
}

//------------------------------------------------------------------------------
Rows sampleAt(const SphereGrid& grid, const Rows& values, const Points& directions, const Run& run)
{
  Rows result(directions.rows(), values.cols());
  forBlocksReporting(run, directions.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        const SphereWeights at = grid.weightsAt(directions.row(i), hint);
        hint = at.Triangle;
        result.row(i) = at.Weights[0] * values.row(at.Ids[0]) +
          at.Weights[1] * values.row(at.Ids[1]) + at.Weights[2] * values.row(at.Ids[2]);
      }
    });
  return result;
}
}
