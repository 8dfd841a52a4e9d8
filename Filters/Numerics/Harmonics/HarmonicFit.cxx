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
  const Index open = countOpenEdges(mesh.Triangles, mesh.Positions.rows(), run);
  if (open > 0)
  {
    throw std::invalid_argument(
      "the surface is open, or its triangles are not oriented consistently, at " +
      std::to_string(open) + " edges, but must be closed. vtkGenusZeroCheck shows where.");
  }
  return turnedToCoverOnce(mesh.SpherePositions, mesh.Triangles, "the map to the sphere", run);
}

// Samples of the surface: the vertices, and points inside large triangles. Rotations of the sphere
// rotate the samples, and change nothing else.
struct SurfaceSamples
{
  Points Directions;     ///< vertices first, then points inside large triangles
  Eigen::VectorXd Areas; ///< area of the surface that each sample represents
  Columns Values;        ///< values at the samples, linear in each triangle
  /// Area of the surface per area of the sphere, at the grid nodes; only for the preconditioner
  Eigen::VectorXd Density;
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

// Part of a large triangle.
struct Part
{
  Eigen::Matrix3d Corners;     // on the sphere, one per column
  Eigen::Matrix3d Barycentric; // coordinates of the corners in the triangle, one per column
  double Area;                 // area on the surface

  // Return the square of the longest side on the sphere, opposite corner k. If sides are equally
  // long up to rounding, the first is chosen, so that rotations of the sphere do not matter.
  double longest(int& k) const
  {
    constexpr double longer = 1.0 + 1e-9;
    double longest = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double square =
        (this->Corners.col(next(i)) - this->Corners.col(previous(i))).squaredNorm();
      if (square > longer * longest)
      {
        longest = square;
        k = i;
      }
    }
    return longest;
  }

  // Return the half at corner next(k), after the side opposite corner k is divided in its middle.
  // With k and its neighbor exchanged by the caller, the other half.
  Part half(int keptCorner, int movedCorner) const
  {
    Part result = *this;
    result.Corners.col(movedCorner) =
      (this->Corners.col(keptCorner) + this->Corners.col(movedCorner)).normalized();
    result.Barycentric.col(movedCorner) =
      0.5 * (this->Barycentric.col(keptCorner) + this->Barycentric.col(movedCorner));
    result.Area = 0.5 * this->Area;
    return result;
  }
};

struct InnerSample
{
  Vector3 Direction, Barycentric;
  Index Triangle;
  double Area;
};

// Divide a large triangle at the middle of its longest side, and so on, until no side on the sphere
// is longer than a limit. The centers of the parts are samples.
void sampleInside(const MappedMesh& mesh, const Triangles& triangles, Index triangle,
  double longest, std::vector<InnerSample>& samples)
{
  Part whole{ Eigen::Matrix3d(), Eigen::Matrix3d::Identity(),
    areaVector(mesh.Positions, triangles, triangle).norm() };
  for (int k = 0; k < 3; ++k)
  {
    whole.Corners.col(k) = mesh.SpherePositions.row(triangles(triangle, k));
  }
  std::vector<Part> parts = { whole };
  while (!parts.empty())
  {
    const Part part = parts.back();
    parts.pop_back();
    int k = 0;
    if (part.longest(k) > longest * longest)
    {
      parts.push_back(part.half(next(k), previous(k)));
      parts.push_back(part.half(previous(k), next(k)));
      continue;
    }
    samples.push_back({ part.Corners.rowwise().sum().normalized(),
      part.Barycentric.rowwise().sum() / 3.0, triangle, part.Area });
  }
}

// Sample small triangles at their vertices, and large triangles inside.
void addSamples(const MappedMesh& mesh, const Triangles& triangles, const Columns& values,
  double longest, SurfaceSamples& samples)
{
  std::vector<InnerSample> inner;
  const Index size = mesh.Positions.rows();
  Eigen::VectorXd vertexAreas = Eigen::VectorXd::Zero(size);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    if (longestSide(mesh.SpherePositions, triangles, t) > longest)
    {
      sampleInside(mesh, triangles, t, longest, inner);
      continue;
    }
    const double share = areaVector(mesh.Positions, triangles, t).norm() / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      vertexAreas[triangles(t, k)] += share;
    }
  }
  const Index all = size + static_cast<Index>(inner.size());
  samples.Directions.resize(all, 3);
  samples.Areas.resize(all);
  samples.Values = Columns::Zero(all, values.cols());
  samples.Directions.topRows(size) = mesh.SpherePositions;
  samples.Areas.head(size) = vertexAreas;
  samples.Values.topRows(size) = values;
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    const Index row = size + static_cast<Index>(i);
    samples.Directions.row(row) = inner[i].Direction;
    samples.Areas[row] = inner[i].Area;
    for (int k = 0; k < 3; ++k)
    {
      samples.Values.row(row) +=
        inner[i].Barycentric[k] * values.row(triangles(inner[i].Triangle, k));
    }
  }
}

SurfaceSamples sampleSurface(const MappedMesh& mesh, const Triangles& triangles,
  const Columns& values, const HarmonicGrid& grid, double longest, const Run& run)
{
  constexpr Index blockSize = 512;
  Steps steps(run, { 0.1, 0.8, 0.1 }); // progress: samples, locator, density
  steps.next();
  SurfaceSamples samples;
  addSamples(mesh, triangles, values, longest, samples);
  const SphereLocator locator(mesh.SpherePositions, triangles, steps.next());
  const Run sampling = steps.next();
  const Points directions = grid.directions();
  const double minimumArea = 1e-200;
  samples.Density.resize(grid.size());
  forBlocksReporting(sampling, grid.size(), blockSize,
    [&](Index begin, Index end)
    {
      int hint = -1;
      for (Index i = begin; i < end; ++i)
      {
        hint = locator.locate(directions.row(i), hint).Triangle;
        const double area = areaVector(mesh.Positions, triangles, hint).norm();
        const double onSphere = areaVector(mesh.SpherePositions, triangles, hint).norm();
        samples.Density[i] = area / std::max(onSphere, minimumArea);
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
    harmonicMoments(samples.Directions, samples.Areas, 2 * degree, steps.next());
  const Eigen::VectorXd density = grid.synthesize(masses, run.unwatched());
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

  const Columns moments = harmonicMoments(
    samples.Directions, samples.Areas.asDiagonal() * samples.Values, degree, steps.next());
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
