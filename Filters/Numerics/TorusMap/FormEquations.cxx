#include "TorusMap/FormEquations.h"

#include "Base/NumericalFailure.h"
#include "Linear/EdgeWeights.h"
#include "Linear/HarmonicExtension.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
namespace
{
// Positions of vertices by numbers of edges: coordinate k is the smallest number of edges to a
// vertex that is far from the previous ones. Neighbors are close to each other, even if the
// vertices of a surface with folds or long edges are not.
Points placesByEdges(const Adjacency& neighbors, Index size)
{
  Points places = Points::Constant(size, 3, -1.0);
  int source = 0;
  for (int k = 0; k < 3; ++k)
  {
    std::vector<int> queue = { source };
    places(source, k) = 0.0;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (const int* u = neighbors.begin(queue[i]); u != neighbors.end(queue[i]); ++u)
      {
        if (places(*u, k) < 0.0)
        {
          places(*u, k) = places(queue[i], k) + 1.0;
          queue.push_back(*u);
        }
      }
    }
    Index farthest = 0;
    places.leftCols(k + 1).rowwise().minCoeff().maxCoeff(&farthest);
    source = static_cast<int>(farthest);
  }
  return places;
}

// Weights of edges. Each side of a triangle has half of the cotangent of its opposite corner.
EdgeWeights edgeWeights(const FormEquations& equations, Index size)
{
  Points cotangents(equations.Triangles.rows(), 3);
  for (Index t = 0; t < cotangents.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      cotangents(t, previous(k)) = 2.0 * equations.Weights[3 * t + k];
    }
  }
  return cotangentWeights(equations.Triangles, size, cotangents);
}
}

//------------------------------------------------------------------------------
Columns FormEquations::solve(const Points& places, const Run& run) const
{
  const Index size = places.rows();
  Columns values = Columns::Zero(size, 2);
  for (int side = 0; side < static_cast<int>(this->Weights.size()); ++side)
  {
    const Eigen::RowVector2d flux = this->Weights[side] * this->Forms.row(side).cast<double>();
    values.row(this->from(side)) += flux;
    values.row(this->to(side)) -= flux;
  }
  const EdgeWeights weights = edgeWeights(*this, size);
  // The sum of the right-hand sides is 0. An addition to the diagonal of vertex 0 therefore makes
  // the value of this vertex 0, and makes the matrix positive definite.
  std::vector<double> diagonal(size);
  for (Index v = 0; v < size; ++v)
  {
    diagonal[v] = weights.sumAt(v);
  }
  diagonal[0] += std::max(1.0, std::abs(diagonal[0]));
  const Columns right = values;
  try
  {
    solveByCholesky(weights, diagonal, places, values, run.part(0.0, 0.9));
  }
  catch (const NumericalFailure&)
  {
    values = right;
    solveByCholesky(
      weights, diagonal, placesByEdges(weights.Neighbors, size), values, run.part(0.9, 1.0));
  }
  if (!values.allFinite() || !(values.cwiseAbs().maxCoeff() < 1e6))
  {
    throw NumericalFailure("the equations of the map to a torus have no finite solution");
  }
  return values;
}

//------------------------------------------------------------------------------
Eigen::Matrix2d FormEquations::energyMatrix(const Columns& values) const
{
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (int side = 0; side < static_cast<int>(this->Weights.size()); ++side)
  {
    const Eigen::Vector2d d = this->difference(values, side);
    sum += this->Weights[side] * d * d.transpose();
  }
  return sum;
}

//------------------------------------------------------------------------------
std::vector<double> boundedWeights(const Points& points, const Triangles& triangles)
{
  constexpr double minimumExcess = 1e-5; // of the sum of two edges over the third, in edge lengths
  constexpr double noLength = 1e-12;     // in the unit box
  std::vector<double> weights(triangles.size());
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    Vector3 lengths;
    for (int k = 0; k < 3; ++k)
    {
      lengths[k] = (points.row(triangles(t, next(k))) - points.row(triangles(t, k))).norm();
    }
    const double longest = std::max(lengths.maxCoeff(), noLength);
    const double excess = lengths.sum() - 2.0 * lengths.maxCoeff();
    lengths.array() += std::max(0.0, minimumExcess * longest - excess);
    const double perimeter = lengths.sum();
    double product = perimeter; // 16 times the squared area, by Heron's formula
    for (int k = 0; k < 3; ++k)
    {
      product *= perimeter - 2.0 * lengths[k];
    }
    const Vector3 squares = lengths.cwiseAbs2();
    for (int k = 0; k < 3; ++k)
    {
      weights[3 * t + k] = 0.5 * (squares.sum() - 2.0 * squares[k]) / std::sqrt(product);
    }
  }
  return weights;
}
}
