#include "Linear/ShiftedSystem.h"

#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace conformal
{
//------------------------------------------------------------------------------
MultifrontalCholesky factorize(
  const SparseMatrix& matrix, const Points& places, int rings, const Run& run)
{
  EdgeWeights weights;
  std::vector<double> diagonal(matrix.rows(), 0.0);
  weights.Neighbors.Offsets.push_back(0);
  for (Index column = 0; column < matrix.cols(); ++column)
  {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
    {
      if (entry.row() == column)
      {
        diagonal[column] = entry.value();
      }
      else
      {
        weights.Neighbors.Ids.push_back(static_cast<int>(entry.row()));
        weights.Weights.push_back(-entry.value());
      }
    }
    weights.Neighbors.Offsets.push_back(static_cast<int>(weights.Neighbors.Ids.size()));
  }
  return MultifrontalCholesky(weights, diagonal, places, run, rings);
}

//------------------------------------------------------------------------------
ShiftedSystem::ShiftedSystem(const SparseMatrix& matrix, const MultifrontalCholesky& factor,
  double center, Columns right, int steps, const Run& run)
  : Center(center)
  , Recurrences(right.cols())
{
  constexpr double smallest = 1e-150; // of the length of a residual, which may vanish
  Columns residual = std::move(right), before = Columns::Zero(residual.rows(), residual.cols());
  for (int step = 0; step < steps; ++step)
  {
    Columns basis = residual;
    factor.solve(basis);
    Eigen::VectorXd lengths(residual.cols());
    for (Index c = 0; c < residual.cols(); ++c)
    {
      const double square = residual.col(c).dot(basis.col(c));
      lengths[c] = std::max(std::sqrt(std::max(square, 0.0)), smallest);
      basis.col(c) /= lengths[c];
      residual.col(c) /= lengths[c];
    }
    Columns product = matrix * basis;
    for (Index c = 0; c < residual.cols(); ++c)
    {
      Recurrence& own = this->Recurrences[c];
      if (step == 0)
      {
        own.Length = lengths[c];
      }
      else
      {
        own.Beside.push_back(lengths[c]);
        product.col(c) -= lengths[c] * before.col(c);
      }
      own.Diagonal.push_back(basis.col(c).dot(product.col(c)));
      product.col(c) -= own.Diagonal.back() * residual.col(c);
    }
    before = std::move(residual);
    residual = std::move(product);
    this->Basis.push_back(std::move(basis));
    run.report((step + 1.0) / steps);
  }
}

//------------------------------------------------------------------------------
Eigen::VectorXd ShiftedSystem::coefficients(const Recurrence& recurrence, double lambda) const
{
  const double share = lambda / this->Center;
  const auto size = static_cast<Index>(this->Basis.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (Index i = 0; i < size; ++i)
  {
    matrix(i, i) = share + (1.0 - share) * recurrence.Diagonal[i];
    if (i > 0)
    {
      matrix(i, i - 1) = matrix(i - 1, i) = (1.0 - share) * recurrence.Beside[i - 1];
    }
  }
  return matrix.partialPivLu().solve(recurrence.Length * Eigen::VectorXd::Unit(size, 0));
}

//------------------------------------------------------------------------------
Eigen::VectorXd ShiftedSystem::solution(Index column, double lambda) const
{
  const Eigen::VectorXd coefficients = this->coefficients(this->Recurrences[column], lambda);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(this->Basis.front().rows());
  for (std::size_t step = 0; step < this->Basis.size(); ++step)
  {
    x += coefficients[static_cast<Index>(step)] * this->Basis[step].col(column);
  }
  return x;
}

//------------------------------------------------------------------------------
double ShiftedSystem::product(Index column, double lambda) const
{
  const Recurrence& recurrence = this->Recurrences[column];
  return recurrence.Length * this->coefficients(recurrence, lambda)[0];
}
}
