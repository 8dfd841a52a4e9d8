#include "Register/PreparedSurface.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/GeodesicSphere.h"
#include "Register/SphereFeatures.h"
#include "Sphere/SphereCoverage.h"
#include "Sphere/SphereOrientation.h"

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace conformal
{
namespace
{
constexpr int FeatureFrequency = 20;
// Weights of the features: mean distance, two nearby areas, two curvatures. The weight of the
// stretch is 1.
constexpr double ShapeWeights[] = { 0.4, 0.4, 0.4, 0.2, 0.2 };
const std::vector<double> AreaRadii = { 0.17, 0.35 };
// Smoothing radius of a curvature, and the curvature at which its arc tangent saturates.
struct CurvatureFeature
{
  double Scale, Saturation;
};
constexpr CurvatureFeature CurvatureFeatures[] = { { 0.21, 8.5 }, { 0.07, 17.0 } };

// Move the center of a surface to the origin, and scale its area to 4 pi. Return the areas around
// the vertices before.
Eigen::VectorXd centerAndScale(Points& positions, const Triangles& triangles)
{
  Eigen::VectorXd areas = vertexAreas(positions, triangles);
  const double area = areas.sum() / 6.0; // each triangle is counted twice at three corners
  const Eigen::RowVector3d center = areas.transpose() * positions / areas.sum();
  positions.rowwise() -= center;
  positions *= std::sqrt(4.0 * Pi / area);
  return areas;
}
}

//------------------------------------------------------------------------------
std::vector<double> shapeFeatureWeights()
{
  return { std::begin(ShapeWeights), std::end(ShapeWeights) };
}

//------------------------------------------------------------------------------
PreparedSurface::PreparedSurface(const RegisteredSurface& input, const std::vector<int>& landmarks,
  bool withShape, bool withPositions, const std::string& name, const Run& run)
  : Surface(input.Surface)
  , Given(input.Features)
{
  SphereCoverage coverage =
    measureSphereCoverage(this->Surface.SpherePositions, this->Surface.Triangles);
  if (coverage.Degree == -1)
  {
    this->Mirrored = true;
    this->Surface.SpherePositions.col(0) *= -1.0;
    coverage = measureSphereCoverage(this->Surface.SpherePositions, this->Surface.Triangles);
  }
  const Index folds = countFlippedTriangles(this->Surface.SpherePositions, this->Surface.Triangles);
  if (coverage.Degree != 1 || folds > 0)
  {
    throw std::invalid_argument("the map of the " + name + " surface to the sphere covers it " +
      std::to_string(coverage.Degree) + " times with " + std::to_string(folds) +
      " folded triangles, but must cover it once without folds");
  }
  if (withPositions)
  {
    this->Expected = input.Expected.rows() > 0 ? input.Expected : this->Surface.Positions;
    centerAndScale(this->Expected, this->Surface.Triangles);
  }
  const Eigen::VectorXd areas = centerAndScale(this->Surface.Positions, this->Surface.Triangles);
  normalizeFeatures(this->Given, areas);
  this->Own = SphereGrid(Mesh{ this->Surface.SpherePositions, this->Surface.Triangles });
  if (withShape)
  {
    this->computeShape(landmarks, run);
  }
}

SampledSurface PreparedSurface::sampled(int frequency) const
{
  SampledSurface result;
  result.Grid = SphereGrid(makeGeodesicSphere(frequency));
  const Points& directions = result.Grid.mesh().Positions;
  const Index shape = this->Shape.cols(), given = this->Given.cols(),
              proximities = this->Proximities.cols(), expected = this->Expected.rows() > 0 ? 3 : 0;
  result.Values.resize(result.Grid.size(), 3 + shape + given + expected + proximities);
  result.Values.leftCols<3>() = this->positionsAt(directions);
  if (shape > 0)
  {
    result.Values.middleCols(3, shape) = sampleAt(this->ShapeGrid, this->Shape, directions);
  }
  if (given > 0)
  {
    result.Values.middleCols(3 + shape, given) = this->averagedOn(result.Grid);
  }
  if (expected > 0)
  {
    result.Values.middleCols(3 + shape + given, expected) =
      sampleAt(this->Own, this->Expected, directions);
  }
  if (proximities > 0)
  {
    result.Values.rightCols(proximities) = sampleAt(this->ShapeGrid, this->Proximities, directions);
  }
  return result;
}

Points PreparedSurface::positionsAt(const Points& directions) const
{
  return sampleAt(this->Own, this->Surface.Positions, directions);
}

Rows PreparedSurface::featuresAt(const Points& directions) const
{
  const Index shape = this->Shape.cols(), given = this->Given.cols();
  Rows result(directions.rows(), shape + given);
  if (shape > 0)
  {
    result.leftCols(shape) = sampleAt(this->ShapeGrid, this->Shape, directions);
  }
  if (given > 0)
  {
    result.rightCols(given) = sampleAt(this->Own, this->Given, directions);
  }
  return result;
}

void PreparedSurface::computeShape(const std::vector<int>& landmarks, const Run& run)
{
  this->ShapeGrid = SphereGrid(makeGeodesicSphere(FeatureFrequency));
  const Mesh even = { this->positionsAt(this->ShapeGrid.mesh().Positions),
    this->ShapeGrid.mesh().Triangles };
  const Eigen::VectorXd areas = vertexAreas(even.Positions, even.Triangles);
  Steps steps(run, { 0.95, 0.05 });
  GeodesicFeatureOptions options;
  options.Radii = AreaRadii;
  const Rows distances = geodesicFeatures(even, options, steps.next());
  Index column = distances.cols();
  this->Shape.resize(distances.rows(), column + std::size(CurvatureFeatures));
  this->Shape.leftCols(column) = distances;
  for (const CurvatureFeature& feature : CurvatureFeatures)
  {
    this->Shape.col(column++) =
      (smoothMeanCurvature(even, feature.Scale).array() / feature.Saturation).atan().matrix();
  }
  normalizeFeatures(this->Shape, areas);
  // The proximity of a single landmark is 1 everywhere.
  if (landmarks.size() >= 2)
  {
    Points positions(static_cast<Index>(landmarks.size()), 3);
    for (Index k = 0; k < positions.rows(); ++k)
    {
      positions.row(k) = this->Surface.Positions.row(landmarks[k]);
    }
    this->Proximities = landmarkProximities(even, positions, steps.next());
  }
}

// Average features around the vertices of a grid, so that details below the grid's resolution are
// not aliased.
Rows PreparedSurface::averagedOn(const SphereGrid& grid) const
{
  const Eigen::VectorXd areas = vertexAreas(this->Surface.Positions, this->Surface.Triangles);
  // Weight of values interpolated at a vertex, for vertices without samples nearby.
  constexpr double few = 1e-6;
  const double minimum = few * areas.sum() / static_cast<double>(grid.size());
  Rows sums = minimum * sampleAt(this->Own, this->Given, grid.mesh().Positions);
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(grid.size(), minimum);
  int hint = -1;
  for (Index v = 0; v < areas.size(); ++v)
  {
    const SphereWeights at = grid.weightsAt(this->Surface.SpherePositions.row(v), hint);
    hint = at.Triangle;
    for (int k = 0; k < 3; ++k)
    {
      const double weight = at.Weights[k] * areas[v];
      sums.row(at.Ids[k]) += weight * this->Given.row(v);
      weights[at.Ids[k]] += weight;
    }
  }
  return weights.cwiseInverse().asDiagonal() * sums;
}
}
