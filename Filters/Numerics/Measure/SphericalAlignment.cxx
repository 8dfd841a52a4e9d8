#include "Measure/SphericalAlignment.h"

#include "Base/Steps.h"
#include "Search/TriangleTree.h"
#include "Sphere/ClosestMoebiusTransform.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace conformal
{
namespace
{
// Throw if pairs do not determine a rotation, such as copies of one pair, or antipodal points.
void requireRotation(const Points& from, const Points& to, const Eigen::VectorXd& weights)
{
  constexpr double least = 1e-12;
  const Eigen::Matrix3d correlation = to.transpose() * weights.asDiagonal() * from;
  const Vector3 values = Eigen::JacobiSVD<Eigen::Matrix3d>(correlation).singularValues();
  if (!(values[1] > least * values[0]))
  {
    throw std::invalid_argument("the pairs of points are equal or antipodal, or have no weight, so "
                                "that they determine no rotation; add a pair at another place");
  }
}

// Throw if fewer than three pairs have a weight and differ in both of their points.
void requireMoebius(const Points& from, const Points& to, const Eigen::VectorXd& weights)
{
  constexpr double least = 1e-12;
  std::vector<Index> different;
  for (Index i = 0; i < from.rows() && different.size() < 3; ++i)
  {
    const bool isOther = std::all_of(different.begin(), different.end(),
      [&](Index j)
      {
        return (from.row(i) - from.row(j)).squaredNorm() > least * least &&
          (to.row(i) - to.row(j)).squaredNorm() > least * least;
      });
    if (isOther && weights[i] > 0.0)
    {
      different.push_back(i);
    }
  }
  if (different.size() < 3)
  {
    throw std::invalid_argument("only " + std::to_string(different.size()) +
      " pairs of points are different and have a weight, but a Moebius transform needs 3; add "
      "pairs at other places");
  }
}
}

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
    requireRotation(from, to, weights);
    result.Transform.Rotation = closestRotation(from, to, weights);
  }
  else
  {
    requireMoebius(from, to, weights);
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
