#include "Learn/Fit/PatternFit.h"

#include "Base/AcrossProcesses.h"
#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::array<double, 4> Smoothnesses = { 0.001, 0.01, 0.1, 1.0 };
constexpr Index HeldOutEvery = 5;
// Share of the identity that keeps the equations regular if the weights of all samples are tiny.
constexpr double Ridge = 1e-9;

/// Foot point of a sample.
struct Foot
{
  Index Sample;
  int Triangle;
  Vector3 Barycentric;
};

/// Normal equations A v = g of the first sum.
class ValueEquations
{
public:
  /// @param[in] unit  unit of the values, so that sums do not overflow
  ValueEquations(const TrainingSamples& samples, const Mesh& mesh, double unit)
    : Samples(samples)
    , Unit(unit)
    , Shape(mesh)
    , Neighbors(vertexNeighbors(mesh.Triangles, mesh.Positions.rows()))
    , Size(samples.numberOfPatternValues())
    , Products(6 * mesh.Triangles.rows())
    , Right(mesh.Positions.rows() * Size)
  {
  }

  void add(const Foot& foot)
  {
    const double weight = this->Samples.weight(foot.Sample);
    const double* values = this->Samples.patternValues(foot.Sample);
    Index product = 6 * Index(foot.Triangle);
    for (int k = 0; k < 3; ++k)
    {
      const double share = weight * foot.Barycentric[k];
      for (int l = k; l < 3; ++l)
      {
        this->Products.add(product++, share * foot.Barycentric[l]);
      }
      const Index vertex = this->Shape.Triangles(foot.Triangle, k);
      for (Index c = 0; c < this->Size; ++c)
      {
        this->Right.add(vertex * this->Size + c, share * (values[c] / this->Unit));
      }
    }
  }

  /// Return the minimum for a smoothness.
  Columns solve(double smoothness, const Run& run) const
  {
    FixedPointSums products = this->Products, right = this->Right;
    products.reduce(this->Samples.reduce());
    right.reduce(this->Samples.reduce());
    const Index size = this->Shape.Positions.rows();
    std::vector<Eigen::Triplet<double>> entries;
    double diagonal = 0.0;
    for (Index r = 0; r < this->Shape.Triangles.rows(); ++r)
    {
      Index product = 6 * r;
      for (int k = 0; k < 3; ++k)
      {
        for (int l = k; l < 3; ++l, ++product)
        {
          const int i = this->Shape.Triangles(r, k), j = this->Shape.Triangles(r, l);
          entries.emplace_back(i, j, products[product]);
          if (l > k)
          {
            entries.emplace_back(j, i, products[product]);
          }
          diagonal += l == k ? products[product] : 0.0;
        }
      }
    }
    const double mean = diagonal > 0.0 ? diagonal / static_cast<double>(size) : 1.0;
    for (int i = 0; i < size; ++i)
    {
      entries.emplace_back(i, i, mean * (smoothness * this->Neighbors.size(i) + Ridge));
      for (const int* j = this->Neighbors.begin(i); j != this->Neighbors.end(i); ++j)
      {
        entries.emplace_back(i, *j, -mean * smoothness);
      }
    }
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Columns values(size, this->Size);
    for (Index i = 0; i < size; ++i)
    {
      for (Index c = 0; c < this->Size; ++c)
      {
        values(i, c) = this->Unit * right[i * this->Size + c];
      }
    }
    factorize(matrix, this->Shape.Positions, 1, run).solve(values);
    return values;
  }

private:
  const TrainingSamples& Samples;
  const double Unit;
  const Mesh& Shape;
  const Adjacency Neighbors;
  const Index Size;
  FixedPointSums Products; ///< for each triangle, sums of the products p b_k b_l
  FixedPointSums Right;    ///< for each vertex, sums of p b_k a
};

/// Return the sum of the mean square errors at samples that were left out, on all ranks.
double errorAt(const TrainingSamples& samples, const Mesh& mesh, const Columns& values,
  const std::vector<Foot>& feet, double unit)
{
  FixedPointSums sum(1);
  for (const Foot& foot : feet)
  {
    const double* wanted = samples.patternValues(foot.Sample);
    double square = 0.0;
    for (Index c = 0; c < values.cols(); ++c)
    {
      double value = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        value += foot.Barycentric[k] * values(mesh.Triangles(foot.Triangle, k), c);
      }
      const double error = (value - wanted[c]) / unit;
      square += error * error;
    }
    // Overshooting values of one sample must not exceed the range of the sum.
    constexpr double maximum = 4.0;
    sum.add(0, samples.weight(foot.Sample) * std::min(maximum, square / values.cols()));
  }
  sum.reduce(samples.reduce());
  return sum[0];
}

/// Return the ranges of the samples' values on all ranks: D maxima of the negative values, then D
/// maxima.
std::vector<double> rangesOf(const TrainingSamples& samples)
{
  const Index size = samples.numberOfPatternValues();
  std::vector<double> extremes(2 * size, -std::numeric_limits<double>::infinity());
  for (Index i = 0; i < samples.size(); ++i)
  {
    const double* values = samples.patternValues(i);
    for (Index c = 0; c < size; ++c)
    {
      extremes[c] = std::max(extremes[c], -values[c]);
      extremes[size + c] = std::max(extremes[size + c], values[c]);
    }
  }
  return maximum(samples.reduce(), extremes);
}
}

Columns fitPatternValues(const TrainingSamples& samples, const Mesh& mesh, const Run& run)
{
  Steps steps(run, { 0.1, 0.4, 0.1, 0.1, 0.1, 0.1, 0.1 }); // tree, feet, fits
  const TriangleTree tree(mesh.Positions, mesh.Triangles, steps.next());
  const std::vector<double> ranges = rangesOf(samples);
  // The largest magnitude of a value
  const double unit =
    std::max(std::numeric_limits<double>::min(), *std::max_element(ranges.begin(), ranges.end()));
  ValueEquations equations(samples, mesh, unit);
  std::vector<Foot> heldOut;
  forEachFoot(
    samples, tree, samples.size(), {},
    [&](Index i, const Vector3&, const FootPoint& found)
    {
      const Foot foot = { i, found.Triangle, found.Barycentric };
      if ((samples.firstOfTotal() + i) % HeldOutEvery == HeldOutEvery - 1)
      {
        heldOut.push_back(foot);
        return;
      }
      equations.add(foot);
    },
    steps.next());
  double smoothness = Smoothnesses.front(), best = std::numeric_limits<double>::infinity();
  for (const double candidate : Smoothnesses)
  {
    const double error =
      errorAt(samples, mesh, equations.solve(candidate, steps.next()), heldOut, unit);
    if (error < best)
    {
      best = error;
      smoothness = candidate;
    }
  }
  for (const Foot& foot : heldOut)
  {
    equations.add(foot);
  }
  Columns values = equations.solve(smoothness, steps.next());
  for (Index c = 0; c < values.cols(); ++c)
  {
    values.col(c) = values.col(c).cwiseMax(-ranges[c]).cwiseMin(ranges[values.cols() + c]);
  }
  return values;
}
}
