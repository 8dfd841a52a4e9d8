#include "Measure/SurfaceShape.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Linear/MultifrontalCholesky.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
void requireScale(double scale, double minimum, const char* name)
{
  if (!(scale >= minimum && scale <= 1.0))
  {
    throw std::invalid_argument(std::string(name) + " is out of its range");
  }
}

// Corner of a triangle and the edges at it.
struct Corner
{
  Corner(const Mesh& surface, Index triangle, int k)
  {
    const auto& ids = surface.Triangles.row(triangle);
    const Vector3 here = surface.Positions.row(ids[k]);
    this->ToNext = surface.Positions.row(ids[next(k)]).transpose() - here;
    this->ToPrevious = surface.Positions.row(ids[previous(k)]).transpose() - here;
    this->Sine = this->ToNext.cross(this->ToPrevious).norm();
    this->Cosine = this->ToNext.dot(this->ToPrevious);
  }

  Vector3 ToNext, ToPrevious;
  double Sine, Cosine; // sine and cosine of the angle, times the product of the edge lengths
};
}

//------------------------------------------------------------------------------
Eigen::VectorXd meanCurvatureIntegrals(const Mesh& surface)
{
  const Index size = surface.Positions.rows();
  const Triangles neighbors = triangleNeighbors(surface.Triangles, size);
  Eigen::VectorXd integrals = Eigen::VectorXd::Zero(size);
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    const Vector3 normal = areaVector(surface.Positions, surface.Triangles, r);
    for (int k = 0; k < 3; ++k)
    {
      const int other = neighbors(r, k);
      if (other > r)
      {
        const int a = surface.Triangles(r, k), b = surface.Triangles(r, next(k));
        const Vector3 edge = surface.Positions.row(b) - surface.Positions.row(a);
        const Vector3 across = areaVector(surface.Positions, surface.Triangles, other);
        const double length = edge.norm();
        const double angle = length > 0.0
          ? std::atan2(normal.cross(across).dot(edge) / length, normal.dot(across))
          : 0.0;
        integrals[a] += 0.25 * angle * length;
        integrals[b] += 0.25 * angle * length;
      }
    }
  }
  return integrals;
}

//------------------------------------------------------------------------------
Eigen::VectorXd gaussianCurvatureIntegrals(const Mesh& surface)
{
  Eigen::VectorXd integrals = Eigen::VectorXd::Constant(surface.Positions.rows(), 2.0 * Pi);
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Corner corner(surface, r, k);
      integrals[surface.Triangles(r, k)] -= std::atan2(corner.Sine, corner.Cosine);
    }
  }
  return integrals;
}

//------------------------------------------------------------------------------
Eigen::VectorXd nearestAreas(const Mesh& surface)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.Positions.rows());
  for (Index r = 0; r < surface.Triangles.rows(); ++r)
  {
    const Corner corners[] = { { surface, r, 0 }, { surface, r, 1 }, { surface, r, 2 } };
    const double area = 0.5 * corners[0].Sine;
    const bool isObtuse = std::any_of(std::begin(corners), std::end(corners),
      [](const Corner& corner) { return corner.Cosine <= 0.0; });
    for (int k = 0; k < 3; ++k)
    {
      const Corner &at = corners[k], &after = corners[next(k)], &before = corners[previous(k)];
      areas[surface.Triangles(r, k)] += isObtuse
        ? (at.Cosine <= 0.0 ? 0.5 : 0.25) * area
        : (at.ToPrevious.squaredNorm() * after.Cosine + at.ToNext.squaredNorm() * before.Cosine) /
          (16.0 * area);
    }
  }
  return areas;
}

//------------------------------------------------------------------------------
Columns smoothDensities(
  const Mesh& surface, const Eigen::VectorXd& areas, double time, Columns integrals, const Run& run)
{
  const Index size = surface.Positions.rows();
  // Without negative strings the result is a mean of values.
  EdgeWeights strings = harmonicStrings(surface.Positions, surface.Triangles).Strings;
  for (double& string : strings.Weights)
  {
    constexpr double weakest = 1e-3, strongest = 1e3;
    string = time * std::clamp(string, weakest, strongest);
  }
  std::vector<double> diagonal(size);
  for (Index v = 0; v < size; ++v)
  {
    diagonal[v] = areas[v] + strings.sumAt(v);
  }
  const MultifrontalCholesky factor(strings, diagonal, surface.Positions, run);
  factor.solve(integrals);
  return integrals;
}

//------------------------------------------------------------------------------
SurfaceShape measureSurfaceShape(
  const Mesh& surface, const SurfaceShapeOptions& options, const Run& run)
{
  requireScale(options.CurvatureScale, 0.0, "CurvatureScale");
  requireScale(options.DepthScale, 1e-3, "DepthScale");
  const Index size = surface.Positions.rows();
  Steps steps(run, { 0.1, options.CurvatureScale > 0.0 ? 0.9 : 0.0, 0.9 }); // integrals, solutions
  steps.next();
  Eigen::VectorXd areas = nearestAreas(surface);
  const double area = areas.sum();
  if (!(area > 0.0))
  {
    throw std::invalid_argument("the surface has no area");
  }
  constexpr double speck = 1e-9; // relative to the mean: keeps densities at thin triangles finite
  areas = areas.cwiseMax(speck * area / static_cast<double>(size));
  Columns integrals(size, 2);
  integrals << meanCurvatureIntegrals(surface), gaussianCurvatureIntegrals(surface);

  const Run smoothing = steps.next();
  const double scale = options.CurvatureScale;
  const Columns curvatures = scale > 0.0
    ? smoothDensities(surface, areas, scale * scale * area, integrals, smoothing)
    : Columns(areas.cwiseInverse().asDiagonal() * integrals);

  const double time = options.DepthScale * options.DepthScale * area;
  const double mean = integrals.col(0).sum() / areas.sum();
  const Columns sources = 2.0 * time * (mean * areas - integrals.col(0));
  const Columns depth = smoothDensities(surface, areas, time, sources, steps.next());
  return { curvatures.col(0), curvatures.col(1), depth.col(0) };
}
}
