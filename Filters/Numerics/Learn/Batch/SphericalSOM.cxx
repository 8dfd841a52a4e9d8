#include "Learn/Batch/SphericalSOM.h"

#include "Base/Random.h"
#include "Base/Steps.h"
#include "Cloud/SampleRotation.h"
#include "Learn/Batch/NetworkDiffusion.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleInSpace.h"
#include "Search/TriangleTree.h"
#include "Sphere/SphereLocator.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace conformal
{
namespace
{
constexpr int FirstFrequency = 2;
constexpr int PassesPerLevel =
  20; // by iris and wine: with 5, quantization errors are larger by 5 %
constexpr Index RowsPerNeuron = 12; // in a pass; if there are fewer rows, all are used
constexpr Index MinimumNumberOfNeurons = 12;

/// Sums of each neuron: the total weight C of its rows, then the weighted sum S of its rows.
using NeuronSums = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Change of units: value = Center + Unit * learned value.
struct ColumnUnits
{
  Eigen::VectorXd Center, Unit;
  double Distance = 1.0; ///< unit of distances
};

/// Shift the values of each column to the mean 0. Divide each column by its standard deviation or,
/// without standardization, all columns by one number.
ColumnUnits normalize(Columns& rows, bool standardize)
{
  const Eigen::VectorXd low = rows.rowwise().minCoeff(), high = rows.rowwise().maxCoeff();
  const Eigen::VectorXd middle = 0.5 * low + 0.5 * high;
  Eigen::VectorXd half = 0.5 * high - 0.5 * low;
  const double largest = half.maxCoeff() > 0.0 ? half.maxCoeff() : 1.0;
  half = standardize ? Eigen::VectorXd((half.array() > 0.0).select(half, 1.0))
                     : Eigen::VectorXd::Constant(half.size(), largest);
  // In these units, values are within [-1, 1], so that squares neither overflow nor underflow.
  rows = (rows.colwise() - middle).array().colwise() / half.array();
  const Eigen::VectorXd mean = rows.rowwise().mean();
  rows.colwise() -= mean;
  ColumnUnits units = { middle + half.cwiseProduct(mean), half, standardize ? 1.0 : largest };
  if (standardize)
  {
    Eigen::VectorXd deviation = rows.rowwise().squaredNorm() / static_cast<double>(rows.cols());
    deviation = (deviation.array() > 0.0).select(deviation.cwiseSqrt(), 1.0);
    rows.array().colwise() /= deviation.array();
    units.Unit = units.Unit.cwiseProduct(deviation);
  }
  return units;
}

/// The two candidates that are closest to a point.
struct TwoClosest
{
  int First = -1, Second = -1;
};

/// Find the two closest candidates of each point, by matrix products of blocks. If several
/// candidates are equally close, the lowest ids are found.
/// @param[in] points      D by #P
/// @param[in] candidates  D by #N
std::vector<TwoClosest> closestOf(const Columns& points, const Columns& candidates, const Run& run)
{
  constexpr Index pointsAtATime = 64, candidatesAtATime = 512;
  constexpr double workBetweenReports = 2e8; // multiplications, about 0.1 s
  const Eigen::RowVectorXd squares = candidates.colwise().squaredNorm();
  std::vector<TwoClosest> result(points.cols());
  const auto search = [&](Index begin, Index end)
  {
    Eigen::MatrixXd products;
    std::vector<double> first(end - begin, std::numeric_limits<double>::infinity()), second = first;
    for (Index start = 0; start < candidates.cols(); start += candidatesAtATime)
    {
      const Index count = std::min(candidatesAtATime, candidates.cols() - start);
      products.noalias() =
        candidates.middleCols(start, count).transpose() * points.middleCols(begin, end - begin);
      for (Index p = begin; p < end; ++p)
      {
        TwoClosest& found = result[p];
        double &best = first[p - begin], &next = second[p - begin];
        for (Index k = 0; k < count; ++k)
        {
          // The squared distance, without the square of the point
          const double distance = squares[start + k] - 2.0 * products(k, p - begin);
          if (distance < best)
          {
            next = std::exchange(best, distance);
            found.Second = std::exchange(found.First, static_cast<int>(start + k));
          }
          else if (distance < next)
          {
            next = distance;
            found.Second = static_cast<int>(start + k);
          }
        }
      }
    }
  };
  const double work = static_cast<double>(points.rows()) * static_cast<double>(candidates.cols());
  const Index chunk = pointsAtATime *
    static_cast<Index>(std::clamp(workBetweenReports / (work * pointsAtATime), 1.0, 256.0));
  for (Index start = 0; start < points.cols(); start += chunk)
  {
    const Index size = std::min(chunk, points.cols() - start);
    forBlocks(run, size, pointsAtATime,
      [&](Index begin, Index end) { search(start + begin, start + end); });
    run.report(static_cast<double>(start + size) / static_cast<double>(points.cols()));
  }
  return result;
}

/// Return orthogonal axes along which the rows vary most, D by 3, scaled by the standard
/// deviations. If D is below 3, the other axes are 0. Own construction: orthogonal iteration needs
/// few operations if D is large, and rough axes suffice.
Columns largestAxes(const Columns& rows, unsigned int seed, const Run& run)
{
  constexpr Index maximumRows = 10000;
  constexpr int iterations = 20;
  const Index size = std::min(maximumRows, rows.cols()), dimension = rows.rows();
  Columns some(dimension, size);
  for (Index i = 0; i < size; ++i)
  {
    some.col(i) = rows.col(i * rows.cols() / size);
  }
  Random random(seed);
  const Index count = std::min<Index>(3, dimension);
  Columns axes(dimension, count);
  for (Index k = 0; k < axes.size(); ++k)
  {
    axes.data()[k] = random.uniform() - 0.5;
  }
  for (int i = 0; i < iterations; ++i)
  {
    const Columns along = some.transpose() * axes;
    const Columns stretched = some * along + 1e-9 * axes; // the last term keeps the rank
    axes =
      Eigen::HouseholderQR<Columns>(stretched).householderQ() * Columns::Identity(dimension, count);
    run.report((i + 1.0) / iterations);
  }
  Columns scaled = Columns::Zero(dimension, 3);
  for (Index k = 0; k < count; ++k)
  {
    const double variance =
      (some.transpose() * axes.col(k)).squaredNorm() / static_cast<double>(size);
    scaled.col(k) = std::sqrt(variance) * axes.col(k);
  }
  return scaled;
}

/// Network with its weight vectors.
struct Level
{
  Mesh Network;
  Columns Weights; ///< D by #N
};

/// Replace a network by a finer one. Weight vectors are interpolated.
void refine(Level& level, int frequency, const Run& run)
{
  Mesh finer = makeGeodesicSphere(frequency, run.unwatched());
  const SphereLocator locator(level.Network.Positions, level.Network.Triangles, run.unwatched());
  Columns weights(level.Weights.rows(), finer.Positions.rows());
  for (Index i = 0; i < weights.cols(); ++i)
  {
    const SphereLocation at = locator.locate(finer.Positions.row(i));
    weights.col(i).setZero();
    for (int k = 0; k < 3; ++k)
    {
      weights.col(i) +=
        at.Barycentric[k] * level.Weights.col(level.Network.Triangles(at.Triangle, k));
    }
  }
  level = { std::move(finer), std::move(weights) };
  run.report(1.0);
}

/// Project a row onto the triangles around its winner.
FootPoint project(const Level& level, const Adjacency& around, const double* x, int winner)
{
  FootPoint best;
  for (const int* r = around.begin(winner); r != around.end(winner); ++r)
  {
    const auto ids = level.Network.Triangles.row(*r);
    const TriangleInSpace simplex = toSpace(x, level.Weights.col(ids[0]).data(),
      level.Weights.col(ids[1]).data(), level.Weights.col(ids[2]).data(), level.Weights.rows());
    FootPoint foot = closestPointOfTriangle(simplex.X, simplex.A, simplex.B, simplex.C);
    foot.Triangle = *r;
    if (foot.SquareDistance < best.SquareDistance)
    {
      best = foot;
    }
  }
  return best;
}

/// Compute S / C for each neuron. A neuron without rows gets the mean of its neighbors.
Columns means(const NeuronSums& shares, const Adjacency& neighbors, const Columns& weights)
{
  const double negligible = NegligibleShare * shares.col(0).mean();
  Columns moved(weights.rows(), weights.cols());
  for (Index i = 0; i < moved.cols(); ++i)
  {
    Eigen::VectorXd sum = shares.row(i).tail(weights.rows()).transpose();
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      sum += negligible / neighbors.size(i) * weights.col(*j);
    }
    moved.col(i) = sum / (shares(i, 0) + negligible);
  }
  return moved;
}

/// Train one network in several passes.
void train(Level& level, const Columns& rows, SampleRotation& rotation, const Run& run)
{
  const Index neurons = level.Weights.cols(), dimension = rows.rows();
  const Adjacency neighbors = vertexNeighbors(level.Network.Triangles, neurons);
  const Adjacency around = vertexTriangles(level.Network.Triangles, neurons);
  for (int pass = 0; pass < PassesPerLevel; ++pass)
  {
    const Run passing =
      run.part(static_cast<double>(pass) / PassesPerLevel, (pass + 1.0) / PassesPerLevel);
    rotation.turn(RowsPerNeuron * neurons);
    Columns patterns(dimension, rotation.count());
    for (Index i = 0; i < patterns.cols(); ++i)
    {
      patterns.col(i) = rows.col(rotation.id(i));
    }
    const std::vector<TwoClosest> closest =
      closestOf(patterns, level.Weights, passing.part(0.0, 0.9));
    std::vector<FootPoint> feet(patterns.cols());
    constexpr Index blockSize = 256;
    forBlocks(passing, patterns.cols(), blockSize,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          feet[i] = project(level, around, patterns.col(i).data(), closest[i].First);
        }
      });
    NeuronSums shares = NeuronSums::Zero(neurons, 1 + dimension);
    for (Index i = 0; i < patterns.cols(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index neuron = level.Network.Triangles(feet[i].Triangle, k);
        const double share = feet[i].Barycentric[k];
        shares(neuron, 0) += share;
        shares.row(neuron).tail(dimension) += share * patterns.col(i).transpose();
      }
    }
    for (int step = diffusionsOf(pass, PassesPerLevel); step > 0; --step)
    {
      diffuse(neighbors, shares, passing);
    }
    level.Weights = means(shares, neighbors, level.Weights);
    passing.report(1.0);
  }
}

/// Find winners, and compute errors and the U-matrix.
SphericalSOMResult evaluate(const Level& level, const Columns& rows, const Run& run)
{
  Steps steps(run, { 0.8, 0.2 });
  const Index neurons = level.Weights.cols();
  const Adjacency neighbors = vertexNeighbors(level.Network.Triangles, neurons);
  SphericalSOMResult result;
  result.Network = level.Network;
  result.Hits.assign(neurons, 0);
  result.Rows.assign(neurons, -1);
  int apart = 0;
  const std::vector<TwoClosest> closest = closestOf(rows, level.Weights, steps.next());
  for (Index i = 0; i < rows.cols(); ++i)
  {
    const auto [first, second] = closest[i];
    result.Winners.push_back(first);
    result.SecondWinners.push_back(second);
    result.Distances.push_back((rows.col(i) - level.Weights.col(first)).norm());
    result.QuantizationError += result.Distances.back() / static_cast<double>(rows.cols());
    apart +=
      std::find(neighbors.begin(first), neighbors.end(first), second) == neighbors.end(first);
    result.Rows[first] = result.Hits[first]++ == 0 ? static_cast<int>(i) : result.Rows[first];
  }
  result.TopographicError = apart / static_cast<double>(rows.cols());
  std::vector<int> empty;
  for (int i = 0; i < neurons; ++i)
  {
    double sum = 0.0;
    for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
    {
      sum += (level.Weights.col(i) - level.Weights.col(*j)).norm();
    }
    result.UMatrix.push_back(sum / neighbors.size(i));
    if (result.Hits[i] == 0)
    {
      empty.push_back(i);
    }
  }
  Columns points(rows.rows(), static_cast<Index>(empty.size()));
  for (std::size_t k = 0; k < empty.size(); ++k)
  {
    points.col(static_cast<Index>(k)) = level.Weights.col(empty[k]);
  }
  const std::vector<TwoClosest> closestRows = closestOf(points, rows, steps.next());
  for (std::size_t k = 0; k < empty.size(); ++k)
  {
    result.Rows[empty[k]] = closestRows[k].First;
  }
  return result;
}
}

SphericalSOMResult learnSphericalSOM(
  const Columns& table, const SphericalSOMOptions& options, const Run& run)
{
  if (table.size() == 0)
  {
    throw std::invalid_argument("the table has no rows or no columns to learn from");
  }
  if (options.NumberOfNeurons != 0 && options.NumberOfNeurons < MinimumNumberOfNeurons)
  {
    throw std::invalid_argument("NumberOfNeurons must be 0 (automatic) or at least 12");
  }
  const Index wanted = options.NumberOfNeurons > 0
    ? options.NumberOfNeurons
    : static_cast<Index>(5.0 * std::sqrt(static_cast<double>(table.cols())));
  const std::vector<int> levels = levelsOf(geodesicFrequencyFor(wanted), FirstFrequency);
  Columns rows = table;
  const ColumnUnits units = normalize(rows, options.Standardize);
  // Progress: axes, then refinement and training of each level, then errors.
  std::vector<double> shares = { 0.05 };
  for (const int f : levels)
  {
    const auto share = static_cast<double>(f * f) / (levels.back() * levels.back());
    shares.insert(shares.end(), { 0.05 * share, share });
  }
  shares.push_back(0.2);
  Steps steps(run, shares);
  const Columns axes = largestAxes(rows, options.RandomSeed, steps.next());
  Level level;
  SampleRotation rotation(rows.cols(), options.RandomSeed);
  for (const int f : levels)
  {
    const Run refining = steps.next();
    if (f == levels.front())
    {
      level.Network = makeGeodesicSphere(f, refining);
      level.Weights = axes * level.Network.Positions.transpose();
    }
    else
    {
      refine(level, f, refining);
    }
    train(level, rows, rotation, steps.next());
  }
  SphericalSOMResult result = evaluate(level, rows, steps.next());
  result.Weights =
    (level.Weights.array().colwise() * units.Unit.array()).colwise() + units.Center.array();
  result.QuantizationError *= units.Distance;
  for (double& distance : result.Distances)
  {
    distance *= units.Distance;
  }
  for (double& distance : result.UMatrix)
  {
    distance *= units.Distance;
  }
  run.report(1.0);
  return result;
}
}
