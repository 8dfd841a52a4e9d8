#include "Harmonics/HarmonicAlignment.h"

#include "Harmonics/HarmonicGrid.h"
#include "Harmonics/HarmonicSurface.h"
#include "Harmonics/SphericalHarmonics.h"
#include "Linear/EdgeWeights.h"

#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
using Eigen::AngleAxisd;
using Eigen::Matrix3d;

constexpr int ComparedDegree = 12;

// Return the coefficients up to a degree, or all coefficients if there are fewer degrees. The row
// of degree 0 is set to 0.
Columns shapeOf(const Columns& coefficients, int degree)
{
  Columns shape = coefficients.topRows(std::min(coefficients.rows(), numberOfHarmonics(degree)));
  shape.row(0).setZero();
  return shape;
}

// Axes of the ellipsoid by descending length. The axes on the sphere and the axes in space form
// right-handed frames, one axis per column.
struct EllipsoidAxes
{
  Matrix3d OnSphere = Matrix3d::Identity();
  Matrix3d InSpace = Matrix3d::Identity();
  Vector3 Lengths = Vector3::Zero();
};

EllipsoidAxes axesOf(const Columns& coefficients)
{
  EllipsoidAxes axes;
  if (coefficients.rows() < 4)
  {
    return axes;
  }
  Matrix3d linear; // map from a position p on the sphere to the ellipsoid
  linear.col(0) = coefficients.row(harmonicIndex(1, 1));
  linear.col(1) = coefficients.row(harmonicIndex(1, -1));
  linear.col(2) = coefficients.row(harmonicIndex(1, 0));
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  axes.OnSphere = svd.matrixV();
  axes.InSpace = svd.matrixU();
  axes.Lengths = svd.singularValues();
  for (Matrix3d* frame : { &axes.OnSphere, &axes.InSpace })
  {
    frame->col(2) = frame->col(0).cross(frame->col(1));
  }
  return axes;
}

// Compute the skewness of a surface along axes through its center: the third moment, divided by the
// third absolute moment. Moments are integrals over the area of the surface.
Vector3 skewnessAlong(const Matrix3d& inSpace, const Columns& coefficients)
{
  constexpr int frequency = 24;
  const HarmonicSurface surface =
    makeHarmonicSurface(shapeOf(coefficients, ComparedDegree), frequency);
  const Eigen::VectorXd areas = vertexAreas(surface.Positions, surface.Triangles);
  const Eigen::RowVector3d center = areas.transpose() * surface.Positions / areas.sum();
  const Points along = (surface.Positions.rowwise() - center) * inSpace;
  const Points cubes = along.array().cube();
  const Vector3 moments = cubes.transpose() * areas, sizes = cubes.cwiseAbs().transpose() * areas;
  constexpr double noExtent = 1e-300;
  return moments.cwiseQuotient(sizes.cwiseMax(noExtent));
}

// Choose the ends of the axes. Of the four choices that keep the frames right-handed, the best one
// has the largest sum of the skewness along the axes.
// @return difference of the largest and the second-largest sum
double chooseEnds(EllipsoidAxes& axes, const Columns& coefficients)
{
  constexpr double asGoodAsNone = 1e-3; // error of the integrals
  // Without skewness, the coordinate of largest magnitude on the sphere is positive at the end.
  for (int k = 0; k < 2; ++k)
  {
    Index largest = 0;
    axes.OnSphere.col(k).cwiseAbs().maxCoeff(&largest);
    if (axes.OnSphere(largest, k) < 0.0)
    {
      axes.OnSphere.col(k) *= -1.0;
      axes.InSpace.col(k) *= -1.0;
    }
  }
  const auto complete = [](Matrix3d& frame) { frame.col(2) = frame.col(0).cross(frame.col(1)); };
  complete(axes.OnSphere);
  complete(axes.InSpace);
  const Vector3 skewness = skewnessAlong(axes.InSpace, coefficients);
  const std::array<Vector3, 4> choices = { Vector3(1.0, 1.0, 1.0), Vector3(1.0, -1.0, -1.0),
    Vector3(-1.0, 1.0, -1.0), Vector3(-1.0, -1.0, 1.0) };
  std::array<double, 4> sums{};
  std::size_t best = 0;
  for (std::size_t i = 0; i < choices.size(); ++i)
  {
    sums[i] = skewness.dot(choices[i]);
    best = sums[i] > sums[best] + asGoodAsNone ? i : best;
  }
  axes.OnSphere = axes.OnSphere * choices[best].asDiagonal();
  axes.InSpace = axes.InSpace * choices[best].asDiagonal();
  const double sum = sums[best];
  sums[best] = -3.0;
  return std::max(0.0, sum - *std::max_element(sums.begin(), sums.end()));
}

Matrix3d turn(double angle, int axis)
{
  return AngleAxisd(angle, Vector3::Unit(axis)).toRotationMatrix();
}

// Return the axes about which the lengths do not determine a rotation, since the other two axes are
// similar.
std::vector<int> openAxes(const Vector3& lengths)
{
  constexpr double alike = 0.9;
  const bool first = lengths[1] > alike * lengths[0], last = lengths[2] > alike * lengths[1];
  if (first && last)
  {
    return { 0, 1, 2 };
  }
  return first ? std::vector<int>{ 2 } : last ? std::vector<int>{ 0 } : std::vector<int>{};
}

// Return candidates that are close enough together for a local search. The search then reduces its
// angles step by step.
std::vector<Matrix3d> candidateTurns(const std::vector<int>& open)
{
  std::vector<Matrix3d> turns;
  if (open.size() == 3)
  {
    constexpr int steps = 24; // a step is 15 degrees
    for (int i = 0; i < steps; ++i)
    {
      for (int j = 0; j < steps / 2; ++j)
      {
        for (int k = 0; k < steps; ++k)
        {
          const double unit = 2.0 * Pi / steps;
          turns.push_back(turn(unit * i, 2) * turn(unit * (j + 0.5), 1) * turn(unit * k, 2));
        }
      }
    }
    return turns;
  }
  constexpr int steps = 72; // a step is 5 degrees
  for (int flip = 0; flip < 4; ++flip)
  {
    const Matrix3d flipped =
      flip == 0 ? Matrix3d(Matrix3d::Identity()) : Matrix3d(turn(Pi, flip - 1));
    for (int i = 0; i < (open.empty() ? 1 : steps); ++i)
    {
      turns.push_back(
        open.empty() ? flipped : Matrix3d(flipped * turn(2.0 * Pi * i / steps, open.front())));
    }
  }
  return turns;
}

// Correlation between a moving and a fixed surface, computed on a grid.
class Correlation
{
public:
  Correlation(const Columns& moving, const Columns& fixed)
    : Moving(shapeOf(moving, ComparedDegree))
    , Grid(2 * ComparedDegree)
    , Directions(Grid.directions())
    , Fixed(Grid.synthesize(shapeOf(fixed, ComparedDegree)))
  {
  }

  double operator()(const HarmonicAlignment& alignment) const
  {
    const Points asked = this->Directions * alignment.MapRotation;
    const Columns there =
      evaluateHarmonics(this->Moving, asked) * alignment.SurfaceRotation.transpose();
    const Eigen::VectorXd products = there.cwiseProduct(this->Fixed).rowwise().sum();
    return this->Grid.analyze(products, 0)(0, 0);
  }

private:
  Columns Moving;
  HarmonicGrid Grid;
  Points Directions;
  Columns Fixed;
};
}

//------------------------------------------------------------------------------
Columns rotateHarmonics(const Columns& coefficients, const Matrix3d& rotation, const Run& run)
{
  const int degree = degreeOfHarmonics(coefficients.rows());
  const HarmonicGrid grid(2 * degree);
  const Points asked = grid.directions() * rotation;
  return grid.analyze(evaluateHarmonics(coefficients, asked, run), degree, run.unwatched());
}

//------------------------------------------------------------------------------
HarmonicAlignment alignToEllipsoid(const Columns& coefficients)
{
  EllipsoidAxes axes = axesOf(coefficients);
  const Vector3 center = coefficients.row(0) / std::sqrt(4.0 * Pi);
  const double margin = coefficients.rows() < 4 ? 0.0 : chooseEnds(axes, coefficients);
  return { axes.OnSphere.transpose(), axes.InSpace.transpose(), center, margin };
}

//------------------------------------------------------------------------------
HarmonicAlignment alignToReference(
  const Columns& coefficients, const Columns& reference, bool movesSurface, const Run& run)
{
  const EllipsoidAxes own = axesOf(coefficients), other = axesOf(reference);
  const Vector3 center = coefficients.row(0) / std::sqrt(4.0 * Pi);
  const auto alignmentOf = [&](const Matrix3d& turned)
  {
    HarmonicAlignment alignment;
    alignment.MapRotation = other.OnSphere * turned * own.OnSphere.transpose();
    if (movesSurface)
    {
      alignment.SurfaceRotation = other.InSpace * turned * own.InSpace.transpose();
      alignment.Center = center;
    }
    return alignment;
  };
  const Correlation correlation(coefficients, reference);
  const std::vector<int> open = openAxes(own.Lengths);
  const std::vector<Matrix3d> turns = candidateTurns(open);
  std::vector<double> scores(turns.size());
  forBlocksReporting(run, static_cast<Index>(turns.size()), 1,
    [&](Index i, Index) { scores[i] = correlation(alignmentOf(turns[i])); });
  const auto best = std::max_element(scores.begin(), scores.end());
  double score = *best;
  Matrix3d turned = turns[best - scores.begin()];
  double angle = 0.1;
  for (int halving = 0; halving < 20; ++halving, angle *= 0.5)
  {
    for (const int axis : open)
    {
      for (const double signedAngle : { angle, -angle })
      {
        const Matrix3d tried = turned * turn(signedAngle, axis);
        const double reached = correlation(alignmentOf(tried));
        if (reached > score)
        {
          score = reached;
          turned = tried;
        }
      }
    }
  }
  return alignmentOf(turned);
}
}
