#include "LeastSquaresPolish.h"

#include "FixedPointSums.h"
#include "FootPoints.h"
#include "MeshTopology.h"
#include "TriangleTree.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include <vector>

namespace conformal
{
namespace
{
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
constexpr int MaximumIterations = 25;

/// Feet slide along the surface slowly, round by round, always the same way; longer steps get them
/// there sooner. Measured: 1.7 saves a third of the rounds, 3 and more diverges.
constexpr double Overrelaxation = 1.7;

SparseMatrix uniformLaplacian(const Adjacency& neighbors, Index size)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < size; ++i)
  {
    entries.emplace_back(i, i, 1.0);
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      entries.emplace_back(i, *j, -1.0 / neighbors.size(i));
    }
  }
  SparseMatrix laplacian(size, size);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

/// B^T B and B^T x, gathered triangle by triangle.
struct NormalEquations
{
  explicit NormalEquations(Index triangles)
    : Sums(15 * triangles)
  {
  }
  void add(const FootPoint& foot, const Vector3& x, double weight)
  {
    Index at = 15 * Index(foot.Triangle);
    for (int k = 0; k < 3; ++k)
    {
      for (int l = k; l < 3; ++l)
      {
        this->Sums.add(at++, weight * foot.Barycentric[k] * foot.Barycentric[l]);
      }
      for (int c = 0; c < 3; ++c)
      {
        this->Sums.add(at++, weight * foot.Barycentric[k] * x[c]);
      }
    }
    this->Weight += weight;
    this->SquareError += foot.SquareDistance;
  }
  void assemble(const Triangles& faces, SparseMatrix& matrix, Points& right) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(9 * faces.rows());
    right.setZero();
    for (Index r = 0; r < faces.rows(); ++r)
    {
      Index at = 15 * r;
      for (int k = 0; k < 3; ++k)
      {
        for (int l = k; l < 3; ++l)
        {
          const double value = this->Sums[at++];
          entries.emplace_back(faces(r, k), faces(r, l), value);
          if (l > k)
          {
            entries.emplace_back(faces(r, l), faces(r, k), value);
          }
        }
        for (int c = 0; c < 3; ++c)
        {
          right(faces(r, k), c) += this->Sums[at++];
        }
      }
    }
    matrix.setFromTriplets(entries.begin(), entries.end());
  }

  FixedPointSums Sums;
  double Weight = 0.0;
  double SquareError = 0.0;
};
}

void polish(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const ParallelFor& parallelFor, const Progress& progress, ConformalSOMResult& result)
{
  const Triangles& faces = result.Network.Faces;
  const Index size = result.Weights.rows();
  const SparseMatrix laplacian = uniformLaplacian(vertexNeighbors(faces, size), size);
  const SparseMatrix bending = laplacian.transpose() * laplacian;
  TriangleTree surface(result.Weights, faces);
  SparseMatrix matrix(size, size);
  Points right(size, 3);
  for (int round = 0; round < options.NumberOfPolishRounds; ++round)
  {
    NormalEquations equations(faces.rows());
    const auto progressOfRound = [&](double fraction)
    { return !progress || progress((round + 0.9 * fraction) / options.NumberOfPolishRounds); };
    forEachFoot(
      samples, surface, samples.size(), {},
      [&](Index id, const Vector3& x, const FootPoint& foot)
      { equations.add(foot, x, samples.weight(id)); },
      parallelFor, progressOfRound);
    equations.assemble(faces, matrix, right);
    const double lambda = options.Smoothness * equations.Weight / size;
    const SparseMatrix system = matrix + lambda * bending;
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(system);
    solver.setMaxIterations(MaximumIterations);
    const Points before = result.Weights;
    forBlocks(parallelFor, 3, 1,
      [&](Index c, Index)
      { result.Weights.col(c) = solver.solveWithGuess(right.col(c), before.col(c)); });
    const bool last = round + 1 == options.NumberOfPolishRounds;
    result.Weights = before + (last ? 1.0 : Overrelaxation) * (result.Weights - before);
    surface.refit(result.Weights);

    TrainingRecord record;
    record.Frequency = options.Frequency;
    record.LearningRate = 1.0;
    record.MeanSquareError = equations.SquareError / samples.size();
    record.MeanDisplacement = (result.Weights - before).rowwise().norm().mean();
    result.History.push_back(record);
  }
}
}
