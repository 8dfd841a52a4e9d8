#include "Learn/Fit/PatternFit.h"

#include "Base/AcrossProcesses.h"
#include "Base/FixedPointSums.h"
#include "Base/Steps.h"
#include "Cloud/FootPoints.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"
#include "Search/TriangleInSpace.h"
#include "Search/TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::array<double, 4> Smoothnesses = { 0.001, 0.01, 0.1, 1.0 };
constexpr Index HeldOutEvery = 5;
// Chosen for a bear with a checkerboard of edge length 0.4, 30,000 points and 2,562 neurons, by the
// errors that Examples/Python/learn_colors.py measures.
constexpr int NumberOfAlignments = 8;
constexpr double MoveSmoothness = 0.3;
// Quality of a triangle, 1 if it is equilateral, below which moves must not make it worse.
constexpr double MinimumQuality = 0.4;
// Share of the identity that keeps the equations regular if the weights of all samples are tiny.
constexpr double PatternRidge = 1e-9;

/// Foot point of a sample.
struct Foot
{
  Index Sample;
  int Triangle;
  Vector3 Barycentric;
};

/// Normal equations A u = g for values u of the vertices that minimize
/// sum p |b u - t|^2 + s m sum |u_i - u_j|^2, with a target t of each sample.
class NormalEquations
{
public:
  /// @param[in] neighbors  result of vertexNeighbors() for the mesh
  NormalEquations(
    const TrainingSamples& samples, const Mesh& mesh, const Adjacency& neighbors, Index columns)
    : Samples(samples)
    , Shape(mesh)
    , Neighbors(neighbors)
    , Size(columns)
    , Products(6 * mesh.Triangles.rows())
    , Right(mesh.Positions.rows() * columns)
  {
  }

  /// @param[in] target  a number for each column, of magnitude up to about 1
  void add(const Foot& foot, const double* target)
  {
    const double weight = this->Samples.weight(foot.Sample);
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
        this->Right.add(vertex * this->Size + c, share * target[c]);
      }
    }
  }

  /// Return the minimum for a smoothness s, #V by the number of columns.
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
      entries.emplace_back(i, i, mean * (smoothness * this->Neighbors.size(i) + PatternRidge));
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
        values(i, c) = right[i * this->Size + c];
      }
    }
    factorize(matrix, this->Shape.Positions, 1, run).solve(values);
    return values;
  }

private:
  const TrainingSamples& Samples;
  const Mesh& Shape;
  const Adjacency& Neighbors;
  const Index Size;
  FixedPointSums Products; ///< for each triangle, sums of the products p b_k b_l
  FixedPointSums Right;    ///< for each vertex, sums of p b_k t
};

/// Pattern values of a sample, divided by a unit.
Eigen::VectorXd scaledValues(const TrainingSamples& samples, Index i, double unit)
{
  return Eigen::Map<const Eigen::VectorXd>(
           samples.patternValues(i), samples.numberOfPatternValues()) /
    unit;
}

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

/// Return the largest magnitude of a value, or the smallest number above 0.
double unitOf(const std::vector<double>& ranges)
{
  return std::max(
    std::numeric_limits<double>::min(), *std::max_element(ranges.begin(), ranges.end()));
}

/// Values of the vertices, and the smoothness with which they were fitted.
struct FittedValues
{
  Columns Values;
  double Smoothness = 0.0;
  double Unit = 1.0; ///< largest magnitude of a value of the samples
};

FittedValues fitValues(const TrainingSamples& samples, const Mesh& mesh, const Run& run)
{
  Steps steps(run, { 0.1, 0.4, 0.1, 0.1, 0.1, 0.1, 0.1 }); // tree, feet, fits
  const TriangleTree tree(mesh.Positions, mesh.Triangles, steps.next());
  const std::vector<double> ranges = rangesOf(samples);
  const double unit = unitOf(ranges);
  const Adjacency neighbors = vertexNeighbors(mesh.Triangles, mesh.Positions.rows());
  NormalEquations equations(samples, mesh, neighbors, samples.numberOfPatternValues());
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
      equations.add(foot, scaledValues(samples, i, unit).data());
    },
    steps.next());
  double smoothness = Smoothnesses.front(), best = std::numeric_limits<double>::infinity();
  for (const double candidate : Smoothnesses)
  {
    const Columns values = unit * equations.solve(candidate, steps.next());
    const double error = errorAt(samples, mesh, values, heldOut, unit);
    if (error < best)
    {
      best = error;
      smoothness = candidate;
    }
  }
  for (const Foot& foot : heldOut)
  {
    equations.add(foot, scaledValues(samples, foot.Sample, unit).data());
  }
  Columns values = unit * equations.solve(smoothness, steps.next());
  for (Index c = 0; c < values.cols(); ++c)
  {
    values.col(c) = values.col(c).cwiseMax(-ranges[c]).cwiseMin(ranges[values.cols() + c]);
  }
  return { std::move(values), smoothness, unit };
}

/// Mesh whose vertices have coordinates and pattern values: #V columns of 3 + D numbers.
struct PatternMesh
{
  /// @param[in] around  result of vertexTriangles() for the mesh
  PatternMesh(const Mesh& mesh, const Adjacency& around, const Columns& values)
    : Triangles(mesh.Triangles)
    , Around(around)
    , Weights(3 + values.cols(), mesh.Positions.rows())
  {
    this->Weights.topRows(3) = mesh.Positions.transpose();
    this->Weights.bottomRows(values.cols()) = values.transpose();
  }

  FootPoint footOn(int triangle, const Eigen::VectorXd& x) const
  {
    const auto ids = this->Triangles.row(triangle);
    const TriangleInSpace simplex = toSpace(x.data(), this->Weights.col(ids[0]).data(),
      this->Weights.col(ids[1]).data(), this->Weights.col(ids[2]).data(), x.size());
    FootPoint foot = closestPointOfTriangle(simplex.X, simplex.A, simplex.B, simplex.C);
    foot.Triangle = triangle;
    return foot;
  }

  /// Find the closest point in all dimensions, by steps from triangle to triangle. The first
  /// triangle is the closest one in three dimensions.
  FootPoint project(const Eigen::VectorXd& x, int triangle) const
  {
    constexpr int maximumSteps = 4;
    FootPoint best = this->footOn(triangle, x);
    for (int step = 0; step < maximumSteps; ++step)
    {
      const int from = best.Triangle;
      for (int k = 0; k < 3; ++k)
      {
        const int vertex = this->Triangles(from, k);
        for (const int* r = this->Around.begin(vertex); r != this->Around.end(vertex); ++r)
        {
          const FootPoint foot = this->footOn(*r, x);
          if (foot.SquareDistance < best.SquareDistance)
          {
            best = foot;
          }
        }
      }
      if (best.Triangle == from)
      {
        break;
      }
    }
    return best;
  }

  const conformal::Triangles& Triangles;
  const Adjacency& Around;
  Columns Weights;
};

/// Halve the moves of the corners of triangles that would turn over or become too thin.
void limitMoves(const Mesh& mesh, Points& moves)
{
  constexpr int rounds = 6;
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<char> isLimited(mesh.Positions.rows(), 0);
    for (Index r = 0; r < mesh.Triangles.rows(); ++r)
    {
      Vector3 before[3], after[3];
      for (int k = 0; k < 3; ++k)
      {
        before[k] = mesh.Positions.row(mesh.Triangles(r, k));
        after[k] = before[k] + Vector3(moves.row(mesh.Triangles(r, k)));
      }
      const Vector3 normal = twiceAreaVector(before[0], before[1], before[2]);
      const double now = triangleQuality(after[0], after[1], after[2]);
      if (twiceAreaVector(after[0], after[1], after[2]).dot(normal) <= 0.0 ||
        (now < MinimumQuality && now < triangleQuality(before[0], before[1], before[2])))
      {
        for (int k = 0; k < 3; ++k)
        {
          isLimited[mesh.Triangles(r, k)] = 1;
        }
      }
    }
    for (Index v = 0; v < moves.rows(); ++v)
    {
      if (isLimited[v])
      {
        moves.row(v) *= round + 1 < rounds ? 0.5 : 0.0;
      }
    }
  }
}
}

Columns fitPatternValues(const TrainingSamples& samples, const Mesh& mesh, const Run& run)
{
  return fitValues(samples, mesh, run).Values;
}

void alignWithPatternValues(const TrainingSamples& samples, Mesh& mesh, const Run& run)
{
  if (samples.dimension() < 3)
  {
    return;
  }
  const TriangleTree surface(mesh.Positions, mesh.Triangles, run.unwatched());
  TriangleTree tree = surface; // of the moved mesh
  const Index numberOfVertices = mesh.Positions.rows();
  const Adjacency neighbors = vertexNeighbors(mesh.Triangles, numberOfVertices),
                  around = vertexTriangles(mesh.Triangles, numberOfVertices);
  Steps steps(run, std::vector<double>(NumberOfAlignments + 1, 1.0));
  const FittedValues fitted = fitValues(samples, mesh, steps.next());
  Columns values = fitted.Values;
  for (int round = 0; round < NumberOfAlignments; ++round)
  {
    const Run aligning = steps.next();
    const PatternMesh full(mesh, around, values);
    tree.refit(mesh.Positions, aligning.unwatched());
    const Index size = samples.numberOfPatternValues();
    NormalEquations equations(samples, mesh, neighbors, 3);
    NormalEquations valueEquations(samples, mesh, neighbors, size);
    const auto closest = [&](Index id, const Vector3& x, int hint)
    {
      Eigen::VectorXd pattern(3 + size);
      pattern << x, Eigen::Map<const Eigen::VectorXd>(samples.patternValues(id), size);
      return full.project(pattern, tree.closestPoint(x, hint).Triangle);
    };
    forEachFoot(
      samples, closest, samples.size(), {},
      [&](Index i, const Vector3& x, const FootPoint& found)
      {
        Vector3 residual = x;
        for (int k = 0; k < 3; ++k)
        {
          residual -=
            found.Barycentric[k] * Vector3(mesh.Positions.row(mesh.Triangles(found.Triangle, k)));
        }
        const Foot foot = { i, found.Triangle, found.Barycentric };
        equations.add(foot, residual.data());
        valueEquations.add(foot, scaledValues(samples, i, fitted.Unit).data());
      },
      aligning.part(0.0, 0.8));
    Points moves = equations.solve(MoveSmoothness, aligning.part(0.8, 0.9));
    const Points normals = vertexNormals(mesh.Positions, mesh.Triangles);
    for (Index v = 0; v < moves.rows(); ++v)
    {
      const Vector3 normal = normals.row(v), move = moves.row(v);
      const Vector3 along = move - normal.dot(move) * normal;
      const Vector3 wanted = Vector3(mesh.Positions.row(v)) + along;
      moves.row(v) = surface.closestPoint(wanted).Position - Vector3(mesh.Positions.row(v));
    }
    limitMoves(mesh, moves);
    mesh.Positions += moves;
    values = fitted.Unit * valueEquations.solve(fitted.Smoothness, aligning.part(0.9, 1.0));
    aligning.report(1.0);
  }
}
}
