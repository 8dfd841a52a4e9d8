#include "LeastSquaresPolish.h"

#include "FixedPointSums.h"
#include "FootPoints.h"
#include "MeshTopology.h"
#include "SurfaceSupport.h"
#include "TriangleTree.h"
#include "VertexNormals.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Where there are no patterns the surface shall be drawn straight across, not carry on bending.
constexpr double BareStiffness = 30.0;

/// Folds are pressed flat in the last rounds only; earlier it would cost fit without need.
constexpr int FoldRounds = 5;
constexpr double FoldStiffening = 3.0;

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
  void add(const FootPoint& foot, const Vector3& x, double priority)
  {
    Index at = 15 * Index(foot.Triangle);
    for (int k = 0; k < 3; ++k)
    {
      for (int l = k; l < 3; ++l)
      {
        this->Sums.add(at++, priority * foot.Barycentric[k] * foot.Barycentric[l]);
      }
      for (int c = 0; c < 3; ++c)
      {
        this->Sums.add(at++, priority * foot.Barycentric[k] * x[c]);
      }
    }
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
};

/// Every neuron half-way to the middle of its neighbours, but along the surface only.
Points relax(const Points& weights, const Triangles& faces, const Adjacency& neighbors)
{
  const Points normals = vertexNormals(weights, faces);
  Points relaxed = weights;
  for (Index i = 0; i < weights.rows(); ++i)
  {
    Vector3 step = -weights.row(i);
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      step += Vector3(weights.row(*j)) / neighbors.size(i);
    }
    const Vector3 normal = normals.row(i);
    relaxed.row(i) += 0.5 * (step - normal * normal.dot(step));
  }
  return relaxed;
}

/// Stiffen the neurons at edges whose triangles are folded on to each other.
void stiffenFolds(const Points& weights, const Triangles& faces, const Triangles& across,
  Eigen::VectorXd& stiffness)
{
  const auto normal = [&](Index r)
  {
    const Vector3 a = weights.row(faces(r, 0)), b = weights.row(faces(r, 1)),
                  c = weights.row(faces(r, 2));
    return Vector3((b - a).cross(c - a));
  };
  std::vector<bool> folded(weights.rows(), false);
  for (Index r = 0; r < faces.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (across(r, k) > r && normal(r).dot(normal(across(r, k))) < 0.0)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          folded[faces(r, corner)] = folded[faces(across(r, k), corner)] = true;
        }
      }
    }
  }
  for (Index i = 0; i < weights.rows(); ++i)
  {
    stiffness[i] = folded[i] ? std::min(stiffness[i] * FoldStiffening, 30.0) : stiffness[i];
  }
}

/// The root mean square distance of the samples around each neuron, over a few rings.
class LocalScale
{
public:
  explicit LocalScale(Index neurons)
    : Squares(2 * neurons)
    , Scale(neurons, std::numeric_limits<double>::infinity())
  {
  }

  /// Whether a sample is so much farther from the surface than its like around it that it does not
  /// belong to it: an outlier. A feature still to be learned has its samples together.
  bool outlying(const FootPoint& foot, const Triangles& faces) const
  {
    double scale = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      scale += foot.Barycentric[k] * this->Scale[faces(foot.Triangle, k)];
    }
    return foot.SquareDistance > OutlierRatio * OutlierRatio * scale * scale;
  }

  void add(const FootPoint& foot, const Triangles& faces, double weight)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index neuron = 2 * Index(faces(foot.Triangle, k));
      this->Squares.add(neuron, weight * foot.Barycentric[k]);
      this->Squares.add(neuron + 1, weight * foot.Barycentric[k] * foot.SquareDistance);
    }
  }

  /// Ready for the next round.
  void update(const Adjacency& neighbors)
  {
    const Index size = static_cast<Index>(this->Scale.size());
    Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> sums(size, 2);
    for (Index i = 0; i < sums.size(); ++i)
    {
      sums.data()[i] = this->Squares[i];
    }
    for (int ring = 0; ring < Rings; ++ring)
    {
      auto wider = sums;
      for (Index i = 0; i < size; ++i)
      {
        for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
        {
          wider.row(i) += sums.row(*j);
        }
      }
      sums.swap(wider);
    }
    for (Index i = 0; i < size; ++i)
    {
      this->Scale[i] = sums(i, 0) > 0.0 ? std::sqrt(sums(i, 1) / sums(i, 0))
                                        : std::numeric_limits<double>::infinity();
    }
    this->Squares = FixedPointSums(2 * size);
  }

private:
  static constexpr int Rings = 2;
  static constexpr double OutlierRatio = 6.0;
  FixedPointSums Squares;
  std::vector<double> Scale;
};

/// See AutomaticPriority.
double automaticPriority(double squareDistance, double meanSquare)
{
  return meanSquare > 0.0 ? std::sqrt(std::clamp(squareDistance / meanSquare, 0.1, 8.0)) : 1.0;
}
}

std::vector<double> polish(const TrainingSamples& samples, const PolishOptions& options,
  const ParallelFor& parallelFor, const Progress& progress, ConformalSOMResult& result)
{
  const Triangles& faces = result.Network.Faces;
  const Index size = result.Weights.rows();
  const Adjacency neighbors = vertexNeighbors(faces, size);
  const SparseMatrix laplacian = uniformLaplacian(neighbors, size);
  Eigen::VectorXd stiffness = Eigen::VectorXd::Ones(size);
  Eigen::VectorXd folds = Eigen::VectorXd::Ones(size);
  const Triangles across = triangleNeighbors(faces, size);
  const int frequency = static_cast<int>(std::lround(std::sqrt(faces.rows() / 20.0)));
  TriangleTree surface(result.Weights, faces);
  SparseMatrix matrix(size, size);
  Points right(size, 3);
  std::vector<double> masses(faces.rows(), 0.0);
  double meanSquare = 0.0;
  LocalScale scale(size);
  const auto belongs = [&](const Vector3& x) { return !options.Belongs || options.Belongs(x); };
  if (options.NumberOfRounds > 0)
  {
    // Before anything moves: outliers must not pull even once.
    forEachFoot(
      samples, surface, samples.size(), {},
      [&](Index id, const Vector3& x, const FootPoint& foot)
      { scale.add(foot, faces, belongs(x) ? samples.weight(id) : 0.0); },
      parallelFor, partOf(progress, 0.0, 0.05));
    scale.update(neighbors);
  }
  for (int round = 0; round < options.NumberOfRounds; ++round)
  {
    const Points before = result.Weights;
    if (round < options.RelaxedRounds)
    {
      result.Weights = relax(result.Weights, faces, neighbors);
      surface.refit(result.Weights);
    }
    NormalEquations equations(faces.rows());
    FixedPointSums counts(faces.rows());
    double weights = 0.0, squares = 0.0;
    const LocalScale outlying = scale; // as the last round left it
    const double begin = 0.05 + 0.95 * round / options.NumberOfRounds;
    forEachFoot(
      samples, surface, samples.size(), {},
      [&](Index id, const Vector3& x, const FootPoint& foot)
      {
        const double weight = belongs(x) ? samples.weight(id) : 0.0;
        scale.add(foot, faces, weight);
        if (weight == 0.0 || outlying.outlying(foot, faces))
        {
          return;
        }
        const double priority =
          options.AutomaticPriority ? automaticPriority(foot.SquareDistance, meanSquare) : 1.0;
        equations.add(foot, x, weight * priority);
        counts.add(foot.Triangle, weight);
        weights += weight;
        squares += weight * foot.SquareDistance;
      },
      parallelFor, partOf(progress, begin, begin + 0.85 / options.NumberOfRounds));
    scale.update(neighbors);
    meanSquare = weights > 0.0 ? squares / weights : 0.0;

    equations.assemble(faces, matrix, right);
    const double way = static_cast<double>(round) / std::max(1, options.NumberOfRounds - 1);
    const double smoothness =
      std::pow(options.FirstSmoothness, 1.0 - way) * std::pow(options.LastSmoothness, way);
    const SparseMatrix bending =
      laplacian.transpose() * stiffness.cwiseProduct(folds).asDiagonal() * laplacian;
    const SparseMatrix system = matrix + smoothness * weights / size * bending;
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(system);
    solver.setMaxIterations(MaximumIterations);
    const Points start = result.Weights;
    forBlocks(parallelFor, 3, 1,
      [&](Index c, Index)
      { result.Weights.col(c) = solver.solveWithGuess(right.col(c), start.col(c)); });
    const bool last = round + 1 == options.NumberOfRounds;
    result.Weights = start + (last ? 1.0 : Overrelaxation) * (result.Weights - start);
    surface.refit(result.Weights);

    TrainingRecord record;
    record.Frequency = frequency;
    record.LearningRate = 1.0;
    record.MeanSquareError = meanSquare;
    record.MeanDisplacement = (result.Weights - before).rowwise().norm().mean();
    result.History.push_back(record);
    for (std::size_t r = 0; r < masses.size(); ++r)
    {
      masses[r] = counts[static_cast<Index>(r)];
    }
    const std::vector<bool> bare = unsupportedVertices(result.Weights, faces, neighbors, masses);
    for (Index i = 0; i < size; ++i)
    {
      stiffness[i] = bare[i] ? BareStiffness : 1.0;
    }
    if (round >= options.NumberOfRounds - FoldRounds)
    {
      stiffenFolds(result.Weights, faces, across, folds);
    }
  }
  return masses;
}
}
