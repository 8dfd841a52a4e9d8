#include "Measure/SphericalAlignment.h"

#include "Base/Steps.h"
#include "Search/TriangleTree.h"
#include "Sphere/ClosestMoebiusTransform.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace conformal
{
//------------------------------------------------------------------------------
SphericalAlignmentResult alignSpheres(const Points& from, const Points& to,
  const Eigen::VectorXd& weights, AlignmentKind kind, const Run& run)
{
  const bool rotation = kind == AlignmentKind::Rotation;
  const Index needed = rotation ? 2 : 3;
  if (from.rows() < needed)
  {
    throw std::invalid_argument(std::to_string(needed) +
      " or more pairs of points are needed to determine a " +
      (rotation ? "rotation" : "Moebius transform") + ", not " + std::to_string(from.rows()));
  }
  SphericalAlignmentResult result;
  if (rotation)
  {
    result.Transform.Rotation = closestRotation(from, to, weights);
  }
  else
  {
    result.Transform = closestMoebiusTransform(from, to, weights, run);
  }
  for (Index i = 0; i < from.rows(); ++i)
  {
    result.Error +=
      weights[i] * (result.Transform(from.row(i)) - to.row(i).transpose()).squaredNorm();
  }
  result.Error = std::sqrt(result.Error / weights.sum());
  return result;
}

//------------------------------------------------------------------------------
Points carryMap(const Points& points, const MappedMesh& other, const Run& run)
{
  Steps steps(run, { 0.5, 0.5 }); // tree, foot points
  const TriangleTree tree(other.Positions, other.Triangles, steps.next());
  Points result(points.rows(), 3);
  constexpr Index blockSize = 256;
  forBlocksReporting(steps.next(), points.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const FootPoint foot = tree.closestPoint(points.row(i));
        Vector3 place = Vector3::Zero();
        for (int k = 0; k < 3; ++k)
        {
          place += foot.Barycentric[k] *
            other.SpherePositions.row(other.Triangles(foot.Triangle, k)).transpose();
        }
        result.row(i) = place.normalized();
      }
    });
  return result;
}
}
