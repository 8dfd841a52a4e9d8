#include "Learn/Fit/FairFit.h"

#include "Base/AllColumns.h"
#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Learn/Fit/SurfaceSupport.h"
#include "Linear/OverlappingParts.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace conformal
{
namespace
{
constexpr int Rings = 3; // rings of neighbors that the penalty couples

// Weights that are tried with one factorization, as powers of ten. If the surface has at least the
// fraction EnoughFreedom of its free parameters, no smaller weight is tried: the second solution
// finds smaller weights where they are needed.
constexpr double FirstWeight = 3.0, LadderEnd = 1.5, LadderStep = 0.25, LadderMove = 2.5;
constexpr double EnoughFreedom = 0.5;
constexpr int MaximumLadders = 4, KrylovSteps = 8;

// Factor of the variance of the noise in the second solution. Measured on Igea with noise up to
// 0.002: values from 2 to 4 keep its detail best, and 1 leaves noise. The factor exceeds 1 since
// the mean of variances of different vertices overestimates most of them.
constexpr double WeightOfVariance = 2.5;

// Numbers of diffusion steps by which means around a vertex are computed.
constexpr int SpreadOfChange = 2, SpreadOfNoise = 12, SpreadOfError = 4;
constexpr double MinimumChange = 1e-5; // of the mean
constexpr double FirstChange = 0.1;    // of the mean, added to the changes of the fitted mesh
constexpr double TypicalCount = 0.2;   // samples of typical noise, for each sample of a vertex
constexpr double MaximumPrecision = 100.0;

// If a triangle is inclined to the normal of a vertex by more than 66 degrees, a move along the
// normal is not meaningful. The vertex does not move.
constexpr double SharpCosine = 0.4;
constexpr double AnchorOfSharp = 100.0; // weight of the displacement, in samples of a vertex

constexpr double Ridge = 1e-10; // of the diagonal

// Up to so many vertices, the equations are solved as a whole. The cost of a factorization
// increases by the power 1.5 of the number of vertices. More vertices are divided into parts.
constexpr Index MaximumWhole = 20000;

// Up to so many vertices, the matrix of the energy is kept between weights that are tried, and its
// principal parts are solved. More vertices need too much memory for that: their smaller parts
// compute matrices of their own.
constexpr Index MaximumKept = 50000;
constexpr Index CoreOfKept = 8000, CoreOfMany = 3000;
constexpr int OverlapOfKept = 12, OverlapOfMany = 8; // in rings
constexpr Index PartsBetweenReports = 8;

/// Spread values over neighboring vertices. The sum of the values does not change.
Eigen::VectorXd diffused(const Adjacency& neighbors, Eigen::VectorXd values, int steps)
{
  for (int step = 0; step < steps; ++step)
  {
    Eigen::VectorXd spread = 0.5 * values;
    for (Index i = 0; i < values.size(); ++i)
    {
      for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
      {
        spread[*j] += 0.5 / neighbors.size(i) * values[i];
      }
    }
    values.swap(spread);
  }
  return values;
}

/// Compute the ratio of two sums around each vertex.
Eigen::VectorXd meanAround(
  const Adjacency& neighbors, const Eigen::VectorXd& sums, const Eigen::VectorXd& counts, int steps)
{
  return diffused(neighbors, sums, steps).cwiseQuotient(diffused(neighbors, counts, steps));
}

/// Find vertices with a triangle that is strongly inclined to the vertex normal.
std::vector<bool> sharpVertices(const Mesh& mesh, const Points& normals)
{
  std::vector<bool> sharp(mesh.Positions.rows(), false);
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const auto ids = mesh.Triangles.row(r);
    const Vector3 a = mesh.Positions.row(ids[0]), b = mesh.Positions.row(ids[1]),
                  c = mesh.Positions.row(ids[2]);
    const Vector3 normal = (b - a).cross(c - a).stableNormalized();
    for (const int id : ids)
    {
      sharp[id] = sharp[id] || !(normal.dot(Vector3(normals.row(id))) > SharpCosine);
    }
  }
  return sharp;
}

std::vector<OverlappingPart> partsOf(const Points& places, const Adjacency& neighbors)
{
  const Index size = places.rows();
  return size > MaximumKept ? overlappingParts(places, neighbors, CoreOfMany, OverlapOfMany)
                            : overlappingParts(places, neighbors,
                                size > MaximumWhole ? CoreOfKept : MaximumWhole, OverlapOfKept);
}

struct Solution
{
  Eigen::VectorXd Displacements; // u
  Columns Deviations;            // random vectors of the covariance of u, for noise of 1
  double DegreesOfFreedom = 0.0;
  double Variance = 0.0; // variance of the noise
  double Score = 0.0;    // score of generalized cross-validation; low is good
};

/// Minimize the squared distances plus a weight times the energy.
class FairSystem
{
public:
  FairSystem(const SampleDistances::Sum& distances, double count,
    const CurvatureChange::Energy& energy, const Points& places, const Adjacency& neighbors)
    : Distances(distances)
    , Count(count)
    , Energy(energy)
    , Places(places)
    , Parts(partsOf(places, neighbors))
    , KeptEnergy(this->keepsEnergy() ? energy.matrix() : SparseMatrix())
  {
  }

  Solution solve(double weight, const Run& run) const
  {
    constexpr Index probes = NumberOfProbes;
    Columns columns(this->Places.rows(), 1 + probes); // displacements, deviations
    Eigen::VectorXd traces(static_cast<Index>(this->Parts.size()));
    this->forParts(run,
      [&](const OverlappingPart& part, const Run& own)
      {
        const Columns ofDistances = part.rowsOf(this->Distances.Probes);
        Columns some(ofDistances.rows(), 1 + 2 * probes);
        some << part.rowsOf(this->Distances.Right - weight * this->Energy.Force), ofDistances,
          std::sqrt(weight) * part.rowsOf(this->Energy.Probes);
        this->factorizeAt(part, weight, own).solve(some);
        traces[&part - this->Parts.data()] =
          ofDistances.topRows(part.CoreSize)
            .cwiseProduct(some.block(0, 1, part.CoreSize, probes))
            .sum();
        some.middleCols(1, probes) += some.rightCols(probes);
        some.conservativeResize(some.rows(), 1 + probes);
        part.copyCore(some, columns);
      });
    Solution solution;
    solution.Displacements = columns.col(0);
    solution.Deviations = columns.rightCols(probes);
    columns.resize(0, 0);
    this->evaluate(solution, traces.sum() / static_cast<double>(probes));
    return solution;
  }

  /// Find the weight with the lowest score, and return its solution.
  Solution solveByCrossValidation(const Run& run) const
  {
    Columns columns(this->Places.rows(), static_cast<Index>(NumberOfColumns));
    columns << this->Distances.Right, this->Energy.Force, this->Distances.Probes,
      this->Energy.Probes;
    double center = FirstWeight * this->Distances.Matrix.diagonal().sum() /
      (this->keepsEnergy() ? this->KeptEnergy.diagonal().sum() : this->Energy.trace());
    for (int ladder = 1;; ++ladder)
    {
      const Run own = run.part(1.0 - std::pow(0.5, ladder - 1), 1.0 - std::pow(0.5, ladder));
      const std::vector<Trial> trials = this->trialsAround(center, columns, own);
      const auto size = static_cast<Index>(trials.size());
      Solution best;
      best.Score = std::numeric_limits<double>::infinity();
      Index bestTrial = 0;
      for (Index t = 0; t < size; ++t)
      {
        Solution solution;
        solution.Displacements = trials[t].Values.col(0).cast<double>();
        this->evaluate(solution, trials[t].Trace);
        if (solution.Score < best.Score)
        {
          best = std::move(solution);
          bestTrial = t;
        }
      }
      const bool softer = bestTrial == 0 &&
        best.DegreesOfFreedom < EnoughFreedom * static_cast<double>(this->Places.rows());
      if ((!softer && bestTrial + 1 < size) || ladder == MaximumLadders)
      {
        best.Deviations = trials[bestTrial].Values.col(1).cast<double>();
        return best;
      }
      center *= std::pow(10.0, softer ? -LadderMove : LadderMove);
    }
  }

private:
  enum
  {
    Right,
    Force,
    Probe,
    EnergyProbe,
    NumberOfColumns
  };

  /// Solution of one weight: displacements and deviations, and the trace of the influence matrix.
  struct Trial
  {
    Eigen::MatrixXf Values; // floats, since the solutions of all weights are kept
    double Trace = 0.0;
  };

  /// Solve for all weights of a ladder.
  std::vector<Trial> trialsAround(double center, const Columns& columns, const Run& run) const
  {
    std::vector<double> weights;
    for (double power = -LadderEnd; power <= LadderEnd; power += LadderStep)
    {
      weights.push_back(center * std::pow(10.0, power));
    }
    std::vector<Trial> trials(weights.size());
    for (Trial& trial : trials)
    {
      trial.Values.resize(this->Places.rows(), 2);
    }
    Columns traces(static_cast<Index>(this->Parts.size()), static_cast<Index>(weights.size()));
    this->forParts(run,
      [&](const OverlappingPart& part, const Run& own)
      {
        const ShiftedSystem system(part.principalPart(this->Distances.Matrix),
          this->factorizeAt(part, center, own.part(0.0, 0.4)), center, part.rowsOf(columns),
          KrylovSteps, own.part(0.4, 1.0));
        const Eigen::VectorXd probes = part.rowsOf(columns.col(Probe));
        for (std::size_t t = 0; t < weights.size(); ++t)
        {
          const double weight = weights[t];
          const Eigen::VectorXd ofProbe = system.solution(Probe, weight);
          Columns values(ofProbe.size(), 2);
          values.col(0) = system.solution(Right, weight) - weight * system.solution(Force, weight);
          values.col(1) = ofProbe + std::sqrt(weight) * system.solution(EnergyProbe, weight);
          part.copyCore(Eigen::MatrixXf(values.cast<float>()), trials[t].Values);
          traces(&part - this->Parts.data(), static_cast<Index>(t)) = part.isWhole()
            ? system.product(Probe, weight)
            : probes.head(part.CoreSize).dot(ofProbe.head(part.CoreSize));
        }
      });
    for (std::size_t t = 0; t < weights.size(); ++t)
    {
      trials[t].Trace = traces.col(static_cast<Index>(t)).sum();
    }
    return trials;
  }

  /// Call solve(part, run) for each part. A single part is solved on all threads, and of many
  /// parts, each on one thread.
  template <typename Solve>
  void forParts(const Run& run, const Solve& solve) const
  {
    const auto size = static_cast<Index>(this->Parts.size());
    if (this->isWhole())
    {
      solve(this->Parts[0], run);
      return;
    }
    std::vector<char> failed(size, 0); // exceptions must not leave a thread
    for (Index first = 0; first < size; first += PartsBetweenReports)
    {
      const Index end = std::min(size, first + PartsBetweenReports);
      run.forEach(end - first,
        [&](Index i)
        {
          try
          {
            solve(this->Parts[first + i], Run());
          }
          catch (const NumericalFailure&)
          {
            failed[first + i] = 1;
          }
        });
      run.report(static_cast<double>(end) / static_cast<double>(size));
    }
    if (std::find(failed.begin(), failed.end(), 1) != failed.end())
    {
      throw NumericalFailure("the equations of fairing have no solution");
    }
  }

  bool isWhole() const { return this->Parts.size() == 1; }
  bool keepsEnergy() const { return this->Places.rows() <= MaximumKept; }

  MultifrontalCholesky factorizeAt(const OverlappingPart& part, double weight, const Run& run) const
  {
    SparseMatrix matrix = part.principalPart(this->Distances.Matrix) +
      weight *
        (this->keepsEnergy() ? part.principalPart(this->KeptEnergy)
                             : this->Energy.principalPart(part.Ids));
    matrix.diagonal() *= 1.0 + Ridge;
    return factorize(matrix, this->Places(part.Ids, AllColumns), Rings, run);
  }

  void evaluate(Solution& solution, double trace) const
  {
    const SampleDistances::Sum& d = this->Distances;
    const Eigen::VectorXd& u = solution.Displacements;
    const double squares = std::max(0.0, d.Constant - 2.0 * u.dot(d.Right) + u.dot(d.Matrix * u));
    constexpr double smallest = 1e-3;
    const double free = std::max(smallest, 1.0 - trace / this->Count);
    solution.DegreesOfFreedom = trace;
    solution.Variance = squares / (this->Count * free);
    solution.Score = solution.Variance / free;
    if (!std::isfinite(solution.Score) || !u.allFinite())
    {
      throw NumericalFailure("the equations of fairing have no solution");
    }
  }

  const SampleDistances::Sum& Distances;
  const double Count; // of the samples
  const CurvatureChange::Energy& Energy;
  const Points& Places;
  const std::vector<OverlappingPart> Parts;
  const SparseMatrix KeptEnergy; // of all vertices, if they are few enough
};

class FairFit
{
public:
  FairFit(const TrainingSamples& samples, const FairFitOptions& options, const Mesh& mesh)
    : Samples(samples)
    , Options(options)
    , Surface(mesh)
    , Neighbors(vertexNeighbors(mesh.Triangles, mesh.Positions.rows()))
    , Ones(Eigen::VectorXd::Ones(mesh.Positions.rows()))
    , Creases(options.Creases.empty() ? std::vector<bool>(mesh.Positions.rows()) : options.Creases)
    , Precisions(this->Ones)
  {
  }

  /// Find foot points, and move the vertices.
  void turn(const Run& run)
  {
    Steps steps(run, { 0.3, 0.7 });
    const Points normals = vertexNormals(this->Surface.Positions, this->Surface.Triangles);
    const SampleDistances distances(
      this->Samples, this->Options, this->Surface, normals, this->Neighbors, steps.next());
    if (!(distances.count() > 0.0))
    {
      throw NumericalFailure("there are no samples to fair a mesh by");
    }
    const Run solving = steps.next();
    const CurvatureChange change(this->Surface, normals, solving.unwatched());
    const std::vector<bool> bare = bareVertices(
      this->Surface.Positions, this->Surface.Triangles, this->Neighbors, distances.masses());
    const std::vector<bool> sharp = sharpVertices(this->Surface, normals);
    Eigen::VectorXd anchors(this->Ones.size());
    for (Index i = 0; i < anchors.size(); ++i)
    {
      anchors[i] = sharp[i] || this->Creases[i] ? AnchorOfSharp : bare[i] ? 1.0 : 0.0;
    }
    this->solve(distances, change, anchors, solving);
    for (Index i = 0; i < this->Surface.Positions.rows(); ++i)
    {
      this->Surface.Positions.row(i) += this->Last.Displacements[i] * normals.row(i);
    }
  }

  const Points& positions() const { return this->Surface.Positions; }

  FairFitResult result() const
  {
    FairFitResult result;
    const Eigen::VectorXd squares = meanAround(this->Neighbors,
      this->Last.Deviations.rowwise().squaredNorm() / static_cast<double>(NumberOfProbes),
      this->Ones, SpreadOfError);
    for (const double square : squares)
    {
      result.StandardError.push_back(std::sqrt(this->Last.Variance * square));
    }
    result.DegreesOfFreedom = this->Last.DegreesOfFreedom;
    result.Variance = this->Variance;
    return result;
  }

private:
  /// Compute the mean of squares around each vertex, without creases. Add a fraction of the mean
  /// over all vertices.
  Tensors changesAround(Tensors squares, double share) const
  {
    constexpr double smallest = 1e-300; // of a plane
    constexpr double few = 1e-6;        // of a vertex, where all are on creases
    Eigen::VectorXd counts = this->Ones;
    for (Index i = 0; i < counts.size(); ++i)
    {
      counts[i] = this->Creases[i] ? few : 1.0;
    }
    squares.array().colwise() *= counts.array();
    Tensors changes(squares.rows(), squares.cols());
    for (Index c = 0; c < squares.cols(); ++c)
    {
      changes.col(c) = meanAround(this->Neighbors, squares.col(c), counts, SpreadOfChange);
    }
    changes.leftCols(3).array() += share * squares.leftCols(3).mean() + smallest;
    return changes;
  }

  void solve(const SampleDistances& distances, const CurvatureChange& change,
    const Eigen::VectorXd& anchors, const Run& run)
  {
    const bool first = this->Last.Displacements.size() == 0;
    const Index probes = first ? 1 : NumberOfProbes;
    const Run quiet = run.unwatched();
    SampleDistances::Sum sum = distances.sum(this->Precisions, probes, quiet);
    sum.Matrix.diagonal() += sum.Matrix.diagonal().mean() * anchors;
    if (first)
    {
      // The noise adds about the same change of curvature everywhere. The first weights thus differ
      // less from vertex to vertex than they should, but ridges and creases are kept.
      this->Changes = this->changesAround(
        change.squaresAt(Eigen::VectorXd::Zero(this->Ones.size()), quiet), FirstChange);
    }
    const CurvatureChange::Energy energy =
      change.energy(this->Changes, this->Creases, probes, quiet);
    const FairSystem system(
      sum, distances.count(), energy, this->Surface.Positions, this->Neighbors);
    this->Last = first
      ? system.solveByCrossValidation(run)
      : system.solve(this->Options.Smoothness * WeightOfVariance * this->Last.Variance, run);
    run.report(1.0);

    const Eigen::VectorXd& moves = this->Last.Displacements;
    const Columns& deviations = this->Last.Deviations;
    Tensors squareChanges = change.squaresAt(moves, quiet);
    Eigen::VectorXd squares = distances.squaresAt(moves);
    const double share = this->Last.Variance / static_cast<double>(deviations.cols());
    for (Index p = 0; p < deviations.cols(); ++p)
    {
      squareChanges += share * change.homogeneousSquaresAt(deviations.col(p), quiet);
      squares += share * distances.increaseAt(deviations.col(p));
    }
    this->Changes = this->changesAround(squareChanges, MinimumChange);
    const Eigen::VectorXd counts = distances.countsAt();
    const double all = squares.sum() / distances.count(), few = TypicalCount * counts.mean();
    Eigen::VectorXd variances = meanAround(
      this->Neighbors, squares + few * all * this->Ones, counts + few * this->Ones, SpreadOfNoise);
    this->Precisions = (all * variances.cwiseInverse()).cwiseMin(MaximumPrecision);
    double* const middle = variances.data() + variances.size() / 2;
    std::nth_element(variances.data(), middle, variances.data() + variances.size());
    this->Variance = *middle * distances.count() / distances.mass();
  }

  const TrainingSamples& Samples;
  const FairFitOptions& Options;
  Mesh Surface;
  const Adjacency Neighbors;
  const Eigen::VectorXd Ones;
  const std::vector<bool> Creases;
  Tensors Changes;            // variances of the change of curvature at each vertex
  Eigen::VectorXd Precisions; // inverse variances of the samples at each vertex
  Solution Last;
  double Variance = 0.0;
};
}

//------------------------------------------------------------------------------
FairFitResult fairFit(
  const TrainingSamples& samples, const FairFitOptions& options, Mesh& mesh, const Run& run)
{
  FairFit fit(samples, options, mesh);
  Steps steps(run, { 0.65, 0.35 });
  fit.turn(steps.next());
  fit.turn(steps.next());
  run.report(1.0);
  mesh.Positions = fit.positions();
  return fit.result();
}
}
