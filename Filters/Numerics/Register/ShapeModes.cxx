#include "Register/ShapeModes.h"

#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Sphere/MoebiusTransform.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace conformal
{
namespace
{
/// Compute the areas around the vertices, averaged over the shapes, with sum 1.
Eigen::VectorXd vertexShares(const Triangles& triangles, const std::vector<Points>& shapes)
{
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(shapes.front().rows());
  for (const Points& shape : shapes)
  {
    const Eigen::VectorXd areas = vertexAreas(shape, triangles);
    shares += areas / areas.sum();
  }
  return shares / shares.sum();
}

double product(const Points& a, const Points& b, const Eigen::VectorXd& shares)
{
  return a.cwiseProduct(b).rowwise().sum().dot(shares);
}

Vector3 centerOf(const Points& shape, const Eigen::VectorXd& shares)
{
  return shape.transpose() * shares;
}

Points meanOf(const std::vector<Points>& shapes)
{
  Points mean = shapes.front();
  for (std::size_t s = 1; s < shapes.size(); ++s)
  {
    mean += shapes[s];
  }
  return mean / static_cast<double>(shapes.size());
}

/// Align centered shapes with each other.
/// @return mean of the aligned shapes
Points alignShapes(std::vector<Points>& shapes, const Eigen::VectorXd& shares,
  ShapeAlignment alignment, const Run& run)
{
  constexpr int maximum = 100;
  constexpr double accuracy = 1e-24; // maximum squared change of the mean, relative to its size
  const bool isSimilar = alignment == ShapeAlignment::Similarity;
  double size = 0.0;
  for (const Points& shape : shapes)
  {
    size += std::sqrt(product(shape, shape, shares)) / static_cast<double>(shapes.size());
  }
  Points mean = shapes.front();
  for (int round = 0; round < maximum; ++round)
  {
    run.forEach(static_cast<Index>(shapes.size()),
      [&](Index s)
      {
        Points turned = shapes[s] * closestRotation(shapes[s], mean, shares).transpose();
        const double square = product(turned, turned, shares);
        if (isSimilar && square > 0.0)
        {
          turned *= product(turned, mean, shares) / square;
        }
        shapes[s] = std::move(turned);
      });
    Points next = meanOf(shapes);
    const double square = product(next, next, shares);
    if (isSimilar && square > 0.0)
    {
      next *= size / std::sqrt(square);
    }
    const Points change = next - mean;
    mean = std::move(next);
    run.report((round + 1.0) / maximum);
    if (product(change, change, shares) <= accuracy * size * size)
    {
      break;
    }
  }
  return meanOf(shapes);
}

void addModes(ShapeModes& result, const std::vector<Points>& differences,
  const Eigen::VectorXd& shares, int numberOfModes, const Run& run)
{
  const auto size = static_cast<Index>(differences.size());
  Eigen::MatrixXd products(size, size);
  for (Index s = 0; s < size; ++s)
  {
    run.forEach(s + 1,
      [&](Index t)
      { products(s, t) = products(t, s) = product(differences[s], differences[t], shares); });
    run.report((s + 1.0) / static_cast<double>(size));
  }
  // The differences have the sum 0, so at most #S - 1 eigenvalues are above the minimum.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(products);
  const double all = std::max(0.0, products.trace());
  // Smaller eigenvalues are rounding errors of the points or of the largest eigenvalue.
  const double minimum = std::max(1e-20 * product(result.Mean, result.Mean, shares), 1e-13 * all);
  const double freedom = std::sqrt(static_cast<double>(size) - 1.0);
  std::vector<Eigen::VectorXd> scores;
  for (Index k = size - 1; k >= 1 && static_cast<int>(scores.size()) < numberOfModes; --k)
  {
    const double value = eigen.eigenvalues()[k];
    if (!(value > minimum))
    {
      break;
    }
    Eigen::VectorXd vector = eigen.eigenvectors().col(k);
    const double maximum = (1.0 - 1e-6) * vector.cwiseAbs().maxCoeff();
    Index first = 0;
    while (std::abs(vector[first]) < maximum)
    {
      ++first;
    }
    vector *= vector[first] < 0.0 ? -1.0 : 1.0;
    Points mode = Points::Zero(result.Mean.rows(), 3);
    for (Index s = 0; s < size; ++s)
    {
      mode += vector[s] / freedom * differences[s];
    }
    result.Modes.push_back(std::move(mode));
    result.Explained.push_back(value / all);
    scores.emplace_back(freedom * vector);
  }
  result.Scores.resize(size, static_cast<Index>(scores.size()));
  for (std::size_t k = 0; k < scores.size(); ++k)
  {
    result.Scores.col(static_cast<Index>(k)) = scores[k];
  }
}
}

//------------------------------------------------------------------------------
ShapeModes findShapeModes(const Triangles& triangles, const std::vector<Points>& shapes,
  const ShapeModesOptions& options, const Run& run)
{
  Steps steps(run, { 0.1, 0.85, 0.05 }); // areas, alignment, modes
  steps.next();
  const Eigen::VectorXd shares = vertexShares(triangles, shapes);
  std::vector<Points> aligned = shapes;
  ShapeModes result;
  const Run aligning = steps.next();
  if (options.Alignment == ShapeAlignment::None)
  {
    result.Mean = meanOf(aligned);
  }
  else
  {
    for (Points& shape : aligned)
    {
      const Vector3 center = centerOf(shape, shares);
      shape.rowwise() -= center.transpose();
    }
    const Points first = aligned.front();
    result.Mean = alignShapes(aligned, shares, options.Alignment, aligning);
    // Orient the result as the first shape.
    const Eigen::Matrix3d turn = closestRotation(result.Mean, first, shares).transpose();
    result.Mean = (result.Mean * turn).eval();
    for (Points& shape : aligned)
    {
      shape = (shape * turn).eval();
    }
  }
  result.Aligned = aligned;
  for (Points& shape : aligned)
  {
    shape -= result.Mean;
  }
  addModes(result, aligned, shares, options.NumberOfModes, steps.next());
  if (options.Alignment != ShapeAlignment::None)
  {
    const Eigen::RowVector3d center = centerOf(shapes.front(), shares).transpose();
    result.Mean.rowwise() += center;
    for (Points& shape : result.Aligned)
    {
      shape.rowwise() += center;
    }
  }
  return result;
}
}
