#include "Harmonics/HarmonicFit.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Harmonics/HarmonicGrid.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Linear/ConjugateGradients.h"
#include "Mesh/MeshTopology.h"
#include "Sphere/SphereCoverage.h"
#include "Sphere/SphereLocator.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Return the triangles of a mesh, oriented counter-clockwise on the sphere seen from outside.
Triangles trianglesOnSphere(const MappedMesh& mesh, const Run& run)
{
  Triangles triangles = mesh.Triangles;
  const Index open = countOpenEdges(triangles, mesh.Positions.rows(), run);
  if (open > 0)
  {
    throw std::invalid_argument(
      "the surface is open, or its triangles are not oriented consistently, at " +
      std::to_string(open) + " edges, but must be closed. vtkGenusZeroCheck shows where.");
  }
  SphereCoverage coverage = measureSphereCoverage(mesh.SpherePositions, triangles, run);
  if (coverage.Degree == -1)
  {
    triangles.col(1).swap(triangles.col(2));
    coverage = measureSphereCoverage(mesh.SpherePositions, triangles, run);
  }
  if (coverage.Degree != 1 || coverage.NumberOfFolds > 0)
  {
    throw std::invalid_argument("the map to the sphere covers it " +
      std::to_string(coverage.Degree) + " times with " + std::to_string(coverage.NumberOfFolds) +
      " folded triangles, but must cover it once without folds");
  }
  return triangles;
}

// Samples of the surface and its area: small triangles at their vertices, large triangles on the
// grid.
struct SurfaceSamples
{
  Eigen::VectorXd VertexAreas;
  Columns Values;          ///< values at the grid nodes, linear in each triangle
  Eigen::VectorXd Density; ///< area of the surface per area of the sphere, at the grid nodes
  Eigen::VectorXd Counted; ///< Density in large triangles, 0 in small triangles
};

double longestSide(const Points& positions, const Triangles& triangles, Index triangle)
{
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 begin = positions.row(triangles(triangle, k)),
                  end = positions.row(triangles(triangle, next(k)));
    longest = std::max(longest, (end - begin).norm());
  }
  return longest;
}

// Find the small triangles, and distribute their areas to their vertices.
std::vector<char> countSmallTriangles(
  const MappedMesh& mesh, const Triangles& triangles, double longest, Eigen::VectorXd& vertexAreas)
{
  std::vector<char> isSmall(triangles.rows());
  vertexAreas = Eigen::VectorXd::Zero(mesh.Positions.rows());
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    isSmall[t] = longestSide(mesh.SpherePositions, triangles, t) <= longest ? 1 : 0;
    const double share = areaVector(mesh.Positions, triangles, t).norm() / 3.0;
    for (int k = 0; k < 3 && isSmall[t] != 0; ++k)
    {
      vertexAreas[triangles(t, k)] += share;
    }
  }
  return isSmall;
}

SurfaceSamples sampleSurface(const MappedMesh& mesh, const Triangles& triangles,
  const Columns& values, const HarmonicGrid& grid, double longest, const Run& run)
{
  constexpr Index blockSize = 512;
  Steps steps(run, { 0.1, 0.8, 0.1 }); // progress: small triangles, locator, samples
  steps.next();
  SurfaceSamples samples;
  const std::vector<char> isSmall =
    countSmallTriangles(mesh, triangles, longest, samples.VertexAreas);
  const SphereLocator locator(mesh.SpherePositions, triangles, steps.next());
  const Run sampling = steps.next();
  const Points directions = grid.directions();
  const double share = 4.0 * Pi / static_cast<double>(grid.size()), minimumArea = 1e-200;
  samples.Values.resize(grid.size(), values.cols());
  samples.Density.resize(grid.size());
  samples.Counted.resize(grid.size());
  forBlocksReporting(sampling, grid.size(), blockSize,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        const SphereLocation at = locator.locate(directions.row(i), hint);
        hint = at.Triangle;
        samples.Values.row(i).setZero();
        for (int k = 0; k < 3; ++k)
        {
          samples.Values.row(i) += at.Barycentric[k] * values.row(triangles(hint, k));
        }
        const double area = areaVector(mesh.Positions, triangles, hint).norm();
        const double onSphere = areaVector(mesh.SpherePositions, triangles, hint).norm();
        samples.Density[i] = area / std::max(onSphere, minimumArea);
        // A node in a sliver represents at most the area of the sliver.
        samples.Counted[i] = isSmall[hint] != 0 ? 0.0 : area / std::max(onSphere, share);
      }
    });
  return samples;
}

// Group of three columns, padded with columns of zeros. Each column is divided by a power of two,
// so that the columns have similar magnitudes.
struct ColumnGroup
{
  Points Values;
  Eigen::RowVector3d Units = Eigen::RowVector3d::Ones();

  ColumnGroup(const Columns& values, Index first)
    : Values(Points::Zero(values.rows(), 3))
  {
    for (Index c = 0; c < 3 && first + c < values.cols(); ++c)
    {
      int exponent = 0;
      std::frexp(values.col(first + c).cwiseAbs().maxCoeff(), &exponent);
      this->Units[c] = std::ldexp(1.0, exponent);
      this->Values.col(c) = values.col(first + c) / this->Units[c];
    }
  }
};

constexpr int MaximumNumberOfSteps = 200;
constexpr double WantedAccuracy = 1e-28; // square of the relative residual at which to stop
constexpr double MaximumResidual = 1e-8;

// Progress reports by the residual, which decreases by a nearly constant factor per step.
class Descent
{
public:
  explicit Descent(Run run)
    : Watched(std::move(run))
  {
  }

  void report(double square)
  {
    this->First = this->First > 0.0 ? this->First : square;
    const double fallen =
      square > 0.0 ? std::log(square / this->First) / std::log(WantedAccuracy) : 1.0;
    this->Reached = std::clamp(fallen, this->Reached, 1.0);
    this->Watched.report(this->Reached);
  }

private:
  Run Watched;
  double First = 0.0;
  double Reached = 0.0;
};
}

//------------------------------------------------------------------------------
Columns fitHarmonics(const MappedMesh& mesh, const Columns& values, int degree, const Run& run)
{
  // The grid is exact for products of a harmonic, a density of degree 2 L, and a harmonic.
  const HarmonicGrid grid(4 * degree);
  const Index groups = (values.cols() + 2) / 3;
  // Progress: triangles, samples, density, moments, and the equations of each group of columns.
  std::vector<double> shares = { 0.05, 0.2, 0.45, 0.2 };
  shares.insert(shares.end(), groups, 0.1 / static_cast<double>(groups));
  Steps steps(run, shares);
  steps.next();
  const Triangles triangles = trianglesOnSphere(mesh, run.unwatched());
  const SurfaceSamples samples =
    sampleSurface(mesh, triangles, values, grid, degree > 0 ? Pi / degree : 2.0, steps.next());

  const Columns masses =
    harmonicMoments(mesh.SpherePositions, samples.VertexAreas, 2 * degree, steps.next());
  const Eigen::VectorXd density = grid.synthesize(masses, run.unwatched()) + samples.Counted;
  const double area = std::sqrt(4.0 * Pi) * grid.analyze(density, 0, run.unwatched())(0, 0);
  if (!(area > 0.0))
  {
    throw std::invalid_argument("the surface has no area");
  }
  // Where the surface is almost collapsed, limit the preconditioner by a minimum density.
  const double minimumDensity = 1e-3 * area / (4.0 * Pi);
  const Eigen::VectorXd inverse = samples.Density.cwiseMax(minimumDensity).cwiseInverse();
  const auto timesDensity = [&](const Eigen::VectorXd& factor, const Points& coefficients)
  {
    Columns product = grid.synthesize(coefficients, run.unwatched());
    product.array().colwise() *= factor.array();
    return grid.analyze(product, degree, run.unwatched());
  };

  Columns moments = harmonicMoments(
    mesh.SpherePositions, samples.VertexAreas.asDiagonal() * values, degree, steps.next());
  moments += grid.analyze(samples.Counted.asDiagonal() * samples.Values, degree, run.unwatched());
  if (!moments.allFinite())
  {
    throw std::invalid_argument("values are too large for their harmonics");
  }
  ConjugateGradientsOptions options;
  options.NumberOfSteps = MaximumNumberOfSteps;
  options.Accuracy = WantedAccuracy;
  Columns coefficients(moments.rows(), moments.cols());
  for (Index group = 0; group < groups; ++group)
  {
    const Index first = 3 * group, size = std::min<Index>(3, values.cols() - first);
    ColumnGroup own(moments, first);
    const double before = own.Values.norm();
    Descent descent(steps.next());
    const Points solution = conjugateGradients(
      own.Values, [&](const Points& c, Points& product) { product = timesDensity(density, c); },
      [&](const Points& residual, Points& product)
      {
        product = timesDensity(inverse, residual);
        descent.report(residual.cwiseProduct(product).sum());
      },
      options);
    if (!(own.Values.norm() <= MaximumResidual * before))
    {
      throw NumericalFailure("the harmonics did not converge within " +
        std::to_string(MaximumNumberOfSteps) +
        " steps: the area distortion of the map to the sphere is too large. Map the surface with "
        "an AreaBalance, or use a lower Degree.");
    }
    coefficients.middleCols(first, size) = (solution * own.Units.asDiagonal()).leftCols(size);
  }
  return coefficients;
}
}
